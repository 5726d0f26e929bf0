#include "checker/sandbox/sandbox.hpp"

#include "checker/base/child_process.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>

namespace workbook {
namespace {

// --- the filter of system calls

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // no filter there
#endif

#if !defined(__x86_64__)  // what newer architectures do without
#define SYS_arch_prctl -1
#define SYS_time -1
#define SYS_readlink -1
#define SYS_open -1
#define SYS_access -1
#define SYS_dup2 -1
#endif

/// What becomes of a system call whose argument is as it should be; all arguments that matter here have 32 bits.
struct Rule {
  int call;
  std::uint32_t argument;
  std::uint32_t mask;
  std::uint32_t value;
  std::uint32_t action = SECCOMP_RET_ALLOW;
};

constexpr std::uint32_t refuse(int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); }

/// Stands for the number of the new process. No process has it: Linux numbers end at 2²².
constexpr std::uint32_t own_process = 0x5e1f5e1f;
constexpr std::uint32_t all_bits = 0xffffffff;
constexpr std::uint32_t writing = O_ACCMODE | O_CREAT | O_TRUNC;

/// What a static program does that computes, prints, sleeps and looks at the clock.
constexpr int computing[] = {
    // memory
    SYS_brk, SYS_mmap, SYS_munmap, SYS_mremap, SYS_mprotect,
    // the descriptors that it was given
    SYS_read, SYS_write, SYS_readv, SYS_writev, SYS_lseek, SYS_fstat, SYS_close,
    // start, end, and its own signals
    SYS_arch_prctl, SYS_set_tid_address, SYS_set_robust_list, SYS_rseq, SYS_futex, SYS_getrandom, SYS_exit,
    SYS_exit_group, SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack, SYS_restart_syscall,
    // clocks
    SYS_clock_gettime, SYS_clock_getres, SYS_gettimeofday, SYS_time, SYS_times, SYS_nanosleep, SYS_clock_nanosleep,
    // harmless questions
    SYS_getpid, SYS_getppid, SYS_gettid, SYS_getuid, SYS_geteuid, SYS_getgid, SYS_getegid, SYS_uname, SYS_sysinfo,
    SYS_getrusage, SYS_getrlimit, SYS_getcpu, SYS_sched_yield, SYS_sched_getaffinity};

constexpr Rule computing_rules[] = {
    {SYS_madvise, 2, ~31U, 0},  // no advice that damages pages
    {SYS_fcntl, 1, all_bits, F_GETFL},
    {SYS_execveat, 0, all_bits, program_descriptor},  // the start; the descriptor is closed by it
    {SYS_prlimit64, 2, all_bits, 0},                  // reading limits, not setting them
    {SYS_kill, 0, all_bits, own_process},             // abort() and raise()
    {SYS_tgkill, 0, all_bits, own_process},
    {SYS_ioctl, 0, 0, 0, refuse(ENOTTY)},     // "is this a terminal?"
    {SYS_readlink, 0, 0, 0, refuse(ENOENT)},  // "what is my own path?"
    {SYS_readlinkat, 0, 0, 0, refuse(ENOENT)},
    // fstat of newer C libraries; its path may name a file yet
    {SYS_newfstatat, 3, AT_EMPTY_PATH, AT_EMPTY_PATH, refuse(EACCES)}};

/// What a program does besides that is linked dynamically, and a sanitizer's runtime.
constexpr int reading[] = {SYS_pread64, SYS_dup2, SYS_dup3, SYS_setitimer};

constexpr Rule reading_rules[] = {{SYS_open, 1, writing, 0},
                                  {SYS_openat, 2, writing, 0},
                                  {SYS_newfstatat, 3, AT_EMPTY_PATH, AT_EMPTY_PATH},
                                  {SYS_newfstatat, 0, 0, 0, refuse(EACCES)},
                                  {SYS_access, 0, 0, 0, refuse(EACCES)},
                                  {SYS_faccessat, 0, 0, 0, refuse(EACCES)},
                                  {SYS_fcntl, 1, all_bits, F_SETFD},
                                  {SYS_prctl, 0, 0, 0, refuse(EPERM)}};

/// What no compiler, assembler or linker needs.
constexpr int hostile[] = {
    // connections
    SYS_socket, SYS_socketpair, SYS_io_uring_setup,
    // other processes and their keys
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_keyctl, SYS_add_key, SYS_request_key,
    // the kernel, and other views of the files
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_mount, SYS_unshare, SYS_setns, SYS_chroot};

/// A program of the kernel's packet filter, of fixed size: between fork and exec nothing may be allocated.
class Filter {
 public:
  Filter() {
    add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch));
    add(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0);
    add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
    load_call();
#if defined(__x86_64__)
    constexpr std::uint32_t x32_calls = 0x40000000;  // the same calls by other numbers
    add(BPF_JMP | BPF_JGE | BPF_K, x32_calls, 0, 1);
    add(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS);
#endif
  }

  template <std::size_t count>
  void add_calls(const int (&calls)[count], std::uint32_t action) {
    for (const int call : calls) {
      add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(call), 0, 1);
      add(BPF_RET | BPF_K, action);
    }
  }

  template <std::size_t count>
  void add_rules(const Rule (&rules)[count]) {
    for (const Rule& rule : rules) {
      const auto argument = static_cast<std::uint32_t>(offsetof(seccomp_data, args)) + 8U * rule.argument;
      const auto self = static_cast<std::uint32_t>(::getpid());
      add(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(rule.call), 0, 5);
      add(BPF_LD | BPF_W | BPF_ABS, argument);
      add(BPF_ALU | BPF_AND | BPF_K, rule.mask);
      add(BPF_JMP | BPF_JEQ | BPF_K, rule.value == own_process ? self : rule.value, 0, 1);
      add(BPF_RET | BPF_K, rule.action);
      load_call();
    }
  }

  bool load(std::uint32_t otherwise) {
    add(BPF_RET | BPF_K, otherwise);
    const sock_fprog program{static_cast<unsigned short>(size_), code_.data()};
    return size_ < code_.size() && ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0;
  }

 private:
  void add(std::uint16_t code, std::uint32_t operand, std::uint8_t if_true = 0, std::uint8_t if_false = 0) {
    if (size_ < code_.size()) code_[size_++] = {code, if_true, if_false, operand};
  }
  void load_call() { add(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)); }

  std::array<sock_filter, 512> code_{};
  std::size_t size_ = 0;
};

// --- rules for files, by the numbers of the kernel: the headers of many systems are older than it

namespace landlock {

constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;

struct Ruleset {
  std::uint64_t files, network, scopes;
};

struct [[gnu::packed]] PathBeneath {
  std::uint64_t allowed;
  std::int32_t parent;
};

constexpr std::uint64_t execute = 1, write_file = 2, read_file = 4, read_folder = 8, truncate = 1 << 14,
                        device = 1 << 15;
constexpr std::uint64_t reading = execute | read_file | read_folder;

bool allow(int ruleset, int file, std::uint64_t access) {
  struct stat status {};
  if (::fstat(file, &status) != 0) return false;
  if (!S_ISDIR(status.st_mode)) access &= execute | write_file | read_file | truncate | device;
  const PathBeneath rule{access, file};
  return ::syscall(add_rule, ruleset, 1, &rule, 0) == 0;
}

/// What is not there needs no rule.
bool allow(int ruleset, const std::string& path, std::uint64_t access) {
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return errno == ENOENT || errno == ENOTDIR || errno == EACCES;
  const bool allowed = allow(ruleset, file, access);
  ::close(file);
  return allowed;
}

}  // namespace landlock

SandboxStrength what_the_kernel_offers() {
  constexpr unsigned ask_version = 1;
  const long version = ::syscall(landlock::create_ruleset, nullptr, 0, ask_version);
  const bool has_filters = architecture != 0 && (::prctl(PR_GET_SECCOMP) >= 0 || errno != EINVAL);
  return {has_filters, std::max(0, static_cast<int>(version)), {}};
}

/// Where compilers and shared libraries are installed, never anybody's own files.
std::vector<std::string> system_folders(const std::string& compiler) {
  std::vector<std::string> folders = {"/etc/ld.so.cache", "/lib", "/lib64", "/nix/store"};
  std::error_code error;
  const std::filesystem::path program = std::filesystem::canonical(compiler, error);
  for (const std::filesystem::path& prefix :
       {std::filesystem::path("/usr"), std::filesystem::path("/usr/local"), program.parent_path().parent_path()})
    for (const char* folder : {"bin", "include", "lib", "lib64", "libexec"})
      if (!prefix.empty()) folders.push_back((prefix / folder).string());
  return folders;
}

struct Attempt {
  const char* what;
  bool (*succeeds)();
};

constexpr Attempt attempts[] = {
    {"read a file", [] { return ::open("/etc/passwd", O_RDONLY | O_CLOEXEC) >= 0; }},
    {"write a file", [] { return ::open(".", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600) >= 0; }},
    {"open a connection", [] { return ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0) >= 0; }},
    {"signal another process", [] { return ::kill(::getppid(), 0) == 0; }},
    {"trace another process", [] { return ::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr) == 0; }},
    {"start a process", [] {
       const pid_t started = ::fork();
       if (started == 0) ::_exit(0);
       return started > 0;
     }}};

/// In a copy of this process.
bool succeeds(const Attempt& attempt, const Sandbox& sandbox) {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(sandbox.enter() == nullptr && attempt.succeeds() ? 0 : 1);
  int status = 0;
  while (process > 0 && ::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return process > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

Sandbox::Sandbox(SandboxProfile profile) : profile_(std::move(profile)), strength_(what_the_kernel_offers()) {}

const char* Sandbox::enter() const noexcept {
  if (const char* failed = limit_resources()) return failed;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return "give up privileges";
  if (const char* failed = restrict_files()) return failed;
  return filter_system_calls();
}

const char* Sandbox::limit_resources() const noexcept {
  const rlim_t memory = profile_.memory_bytes == 0 ? RLIM_INFINITY : profile_.memory_bytes;
  const rlim_t processes = profile_.calls == SandboxProfile::Calls::build ? RLIM_INFINITY : 0;
  const struct {
    decltype(RLIMIT_CPU) resource;
    rlim_t soft;
    const char* step;
    rlim_t added = 0;  // to the hard limit
  } limits[] = {       // Not 0, with which a system that hands core dumps to a collector would still start it.
                {RLIMIT_CORE, 1, "limit core dumps"},
                // The hard limit ends a program that ignores the signal of the soft one.
                {RLIMIT_CPU, profile_.processor_seconds, "limit its processor time", 1},
                {RLIMIT_AS, memory, "limit its memory"},
                {RLIMIT_STACK, profile_.stack_bytes, "limit its stack"},
                {RLIMIT_FSIZE, profile_.file_bytes, "limit the size of its files"},
                {RLIMIT_NPROC, processes, "limit its processes"},
                {RLIMIT_NOFILE, profile_.open_files, "limit its open files"}};
  for (const auto& limit : limits) {
    rlimit now{};
    if (::getrlimit(limit.resource, &now) != 0) return limit.step;
    const rlimit wanted{std::min(limit.soft, now.rlim_max), std::min(limit.soft + limit.added, now.rlim_max)};
    if (::setrlimit(limit.resource, &wanted) != 0) return limit.step;
  }
  // Sanitizers of GCC 12 find no room for their tables where newer kernels scatter addresses widely.
  if (profile_.calls == SandboxProfile::Calls::compute_and_read) ::personality(ADDR_NO_RANDOMIZE);
  return nullptr;
}

const char* Sandbox::restrict_files() const noexcept {
  const int version = strength_.landlock;
  if (version == 0) return nullptr;
  // All that a version knows: 13 kinds of access, and one more with versions 2, 3 and 5; network from 4, scopes from 6.
  const std::uint64_t all = (std::uint64_t{1} << (13 + (version >= 2) + (version >= 3) + (version >= 5))) - 1;
  const landlock::Ruleset rules{all, version >= 4 ? 3U : 0U, version >= 6 ? 3U : 0U};
  const int ruleset = static_cast<int>(::syscall(landlock::create_ruleset, &rules, sizeof rules, 0));
  bool done = ruleset >= 0;
  if (profile_.calls != SandboxProfile::Calls::build && ::fcntl(program_descriptor, F_GETFD) >= 0)
    done = done && landlock::allow(ruleset, program_descriptor, landlock::reading);
  for (const std::string& path : profile_.readable) done = done && landlock::allow(ruleset, path, landlock::reading);
  for (const std::string& path : profile_.writable) done = done && landlock::allow(ruleset, path, all);
  done = done && ::syscall(landlock::restrict_self, ruleset, 0) == 0;
  if (ruleset >= 0) ::close(ruleset);
  return done ? nullptr : "restrict its files";
}

const char* Sandbox::filter_system_calls() const noexcept {
  if (!strength_.filters_system_calls) return nullptr;
  const bool builds = profile_.calls == SandboxProfile::Calls::build;
  Filter filter;
  if (builds) {
    filter.add_calls(hostile, refuse(EPERM));
  } else {
    if (profile_.calls == SandboxProfile::Calls::compute_and_read) {
      filter.add_calls(reading, SECCOMP_RET_ALLOW);
      filter.add_rules(reading_rules);
    }
    filter.add_calls(computing, SECCOMP_RET_ALLOW);
    filter.add_rules(computing_rules);
  }
  // A trap and not a plain kill: the worker's own handler can then say which call it was before it ends.
  return filter.load(builds ? SECCOMP_RET_ALLOW : SECCOMP_RET_TRAP) ? nullptr : "filter its system calls";
}

SandboxProfile run_profile() { return {}; }

SandboxProfile diagnose_profile(const std::string& compiler, const std::string& program) {
  SandboxProfile profile{.calls = SandboxProfile::Calls::compute_and_read,
                         .memory_bytes = 0,
                         .open_files = 32,
                         .readable = system_folders(compiler)};
  profile.readable.insert(profile.readable.end(), {program, "/proc/self"});
  return profile;
}

SandboxProfile compile_profile(const std::string& compiler, const std::vector<std::string>& inputs,
                               const std::string& workspace) {
  SandboxProfile profile{.calls = SandboxProfile::Calls::build,
                         .processor_seconds = 60,
                         .memory_bytes = std::size_t{2} << 30,
                         .stack_bytes = std::size_t{64} << 20,
                         .file_bytes = std::size_t{64} << 20,
                         .open_files = 256,
                         .readable = system_folders(compiler),
                         .writable = {workspace, "/dev/null"}};
  profile.readable.insert(profile.readable.end(), inputs.begin(), inputs.end());
  return profile;
}

SandboxTier SandboxStrength::tier() const {
  if (!filters_system_calls || !holes.empty()) return SandboxTier::none;
  return landlock > 0 ? SandboxTier::reduced : SandboxTier::minimal;
}

std::string SandboxStrength::sentence() const {
  if (tier() == SandboxTier::reduced)
    return "reduced: system calls are filtered, and compilers read only what they need";
  if (tier() == SandboxTier::minimal)
    return "minimal: system calls are filtered, but this kernel has no Landlock: a student's file can include any file "
           "that you can read";
  return fmt::format("none: limits on time, memory and output only; a function can {}",
                     holes.empty() ? "do what you can" : fmt::format("{}", fmt::join(holes, ", ")));
}

std::string to_string(SandboxTier tier) {
  constexpr const char* names[] = {"none", "minimal", "reduced"};
  return names[static_cast<int>(tier)];
}

SandboxStrength probe_sandbox() {
  SandboxStrength strength = what_the_kernel_offers();
  const Sandbox sandbox(run_profile());
  for (const Attempt& attempt : attempts)
    if (succeeds(attempt, sandbox)) strength.holes.emplace_back(attempt.what);
  return strength;
}

bool can_confine_files() { return what_the_kernel_offers().tier() == SandboxTier::reduced; }

}  // namespace workbook
