#include "checker/sandbox/sandbox.hpp"

#include "checker/base/child_process.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>

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

}  // namespace

SandboxStrength what_the_kernel_offers() {
  constexpr unsigned ask_version = 1;
  const long version = ::syscall(landlock::create_ruleset, nullptr, 0, ask_version);
  SandboxStrength strength;
  strength.filters_system_calls = architecture != 0 && (::prctl(PR_GET_SECCOMP) >= 0 || errno != EINVAL);
  strength.landlock = std::max(0, static_cast<int>(version));
  return strength;
}

std::vector<std::string> written(const SandboxProfile& profile) {
  std::vector<std::string> words;
  for (const std::size_t number : {static_cast<std::size_t>(profile.calls), std::size_t{profile.processor_seconds},
                                   profile.memory_bytes, profile.stack_bytes, profile.file_bytes,
                                   std::size_t{profile.open_files}, profile.readable.size(), profile.writable.size()})
    words.push_back(std::to_string(number));
  for (const auto* paths : {&profile.readable, &profile.writable})
    words.insert(words.end(), paths->begin(), paths->end());
  return words;
}

SandboxProfile read_profile(char**& words) {
  const auto number = [&] { return std::strtoull(*words++, nullptr, 10); };
  SandboxProfile profile;
  profile.calls = static_cast<SandboxProfile::Calls>(number());
  profile.processor_seconds = static_cast<unsigned>(number());
  profile.memory_bytes = number();
  profile.stack_bytes = number();
  profile.file_bytes = number();
  profile.open_files = static_cast<unsigned>(number());
  profile.readable.resize(number());
  profile.writable.resize(number());
  for (auto* paths : {&profile.readable, &profile.writable})
    for (std::string& path : *paths) path = *words++;
  return profile;
}

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
  const int version = landlock_;
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
  if (!filters_) return nullptr;
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

}  // namespace workbook
