// Which system calls a program may make. libseccomp turns the rules into what the kernel runs; this is done before the
// new process exists, where something may still be allocated.
#include "checker/base/child_process.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <seccomp.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <memory>

namespace workbook {
namespace {

/// What becomes of a system call whose arguments are as they should be.
struct Rule {
  int call;
  std::vector<scmp_arg_cmp> arguments = {};
  std::uint32_t action = SCMP_ACT_ALLOW;
};

using Rules = std::vector<Rule>;

constexpr std::uint64_t whole_number =
    0xffffffff;  // of a number: the kernel does not look at the upper half of its register

scmp_arg_cmp has_bits(unsigned argument, std::uint64_t mask, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}
scmp_arg_cmp is_number(unsigned argument, std::uint64_t value) { return has_bits(argument, whole_number, value); }
scmp_arg_cmp is_null(unsigned argument) { return {argument, SCMP_CMP_EQ, 0, 0}; }

constexpr std::uint64_t writing_flags = O_ACCMODE | O_CREAT | O_TRUNC;

/// What a static program does that computes, prints, sleeps and looks at the clock.
constexpr int computing_calls[] = {
    // memory
    SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect),
    // the descriptors that it was given
    SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(readv), SCMP_SYS(writev), SCMP_SYS(lseek), SCMP_SYS(fstat),
    SCMP_SYS(close),
    // start, end, and its own signals
    SCMP_SYS(arch_prctl), SCMP_SYS(set_tid_address), SCMP_SYS(set_robust_list), SCMP_SYS(rseq), SCMP_SYS(futex),
    SCMP_SYS(getrandom), SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
    SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack), SCMP_SYS(restart_syscall),
    // clocks
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(times),
    SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep),
    // harmless questions
    SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(gettid), SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid),
    SCMP_SYS(getegid), SCMP_SYS(uname), SCMP_SYS(sysinfo), SCMP_SYS(getrusage), SCMP_SYS(getrlimit), SCMP_SYS(getcpu),
    SCMP_SYS(sched_yield), SCMP_SYS(sched_getaffinity)};

Rules computing_rules() {
  return {{SCMP_SYS(madvise), {has_bits(2, ~std::uint64_t{31} & whole_number, 0)}},  // no advice that damages pages
          {SCMP_SYS(fcntl), {is_number(1, F_GETFL)}},
          {SCMP_SYS(execveat), {is_number(0, program_descriptor)}},  // the start; the descriptor is closed by it
          {SCMP_SYS(prlimit64), {is_number(0, 0), is_null(2)}},      // reading its own limits, not setting them
          {SCMP_SYS(kill), {is_number(0, own_process)}},             // abort() and raise()
          {SCMP_SYS(tgkill), {is_number(0, own_process)}},
          {SCMP_SYS(ioctl), {}, SCMP_ACT_ERRNO(ENOTTY)},     // "is this a terminal?"
          {SCMP_SYS(readlink), {}, SCMP_ACT_ERRNO(ENOENT)},  // "what is my own path?"
          {SCMP_SYS(readlinkat), {}, SCMP_ACT_ERRNO(ENOENT)}};
}

/// What a program does besides that is linked dynamically, and a sanitizer's runtime.
constexpr int reading_calls[] = {SCMP_SYS(pread64), SCMP_SYS(dup2), SCMP_SYS(dup3), SCMP_SYS(setitimer)};

Rules reading_rules() {
  constexpr std::uint64_t sign = 0x80000000;  // of AT_FDCWD, but not of a descriptor
  return {{SCMP_SYS(open), {has_bits(1, writing_flags, 0)}},
          {SCMP_SYS(openat), {has_bits(2, writing_flags, 0)}},
          {SCMP_SYS(newfstatat), {has_bits(0, sign, 0), has_bits(3, AT_EMPTY_PATH, AT_EMPTY_PATH)}},
          {SCMP_SYS(newfstatat), {has_bits(0, sign, sign)}, SCMP_ACT_ERRNO(EACCES)},
          {SCMP_SYS(newfstatat), {has_bits(0, sign, 0), has_bits(3, AT_EMPTY_PATH, 0)}, SCMP_ACT_ERRNO(EACCES)},
          {SCMP_SYS(access), {}, SCMP_ACT_ERRNO(EACCES)},
          {SCMP_SYS(faccessat), {}, SCMP_ACT_ERRNO(EACCES)},
          {SCMP_SYS(fcntl), {is_number(1, F_SETFD)}},
          {SCMP_SYS(prctl), {}, SCMP_ACT_ERRNO(EPERM)}};
}

/// What no compiler, assembler or linker needs.
constexpr int hostile_calls[] = {
    // connections
    SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(io_uring_setup),
    // other processes and their keys
    SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(keyctl), SCMP_SYS(add_key),
    SCMP_SYS(request_key),
    // the kernel, and other views of the files
    SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(mount), SCMP_SYS(unshare),
    SCMP_SYS(setns), SCMP_SYS(chroot)};

Rules rules_of(SandboxProfile::Calls calls) {
  Rules rules;
  const auto add = [&](const auto& unconditional, std::uint32_t action) {
    for (const int call : unconditional) rules.push_back({call, {}, action});
  };
  const auto add_all = [&](const Rules& more) { rules.insert(rules.end(), more.begin(), more.end()); };
  if (calls == SandboxProfile::Calls::build) {
    add(hostile_calls, SCMP_ACT_ERRNO(EPERM));
    return rules;
  }
  add(computing_calls, SCMP_ACT_ALLOW);
  add_all(computing_rules());
  if (calls == SandboxProfile::Calls::compute) {
    // fstat of newer C libraries; its path may name a file yet
    rules.push_back({SCMP_SYS(newfstatat), {has_bits(3, AT_EMPTY_PATH, AT_EMPTY_PATH)}, SCMP_ACT_ERRNO(EACCES)});
  } else {
    add(reading_calls, SCMP_ACT_ALLOW);
    add_all(reading_rules());
  }
  return rules;
}

/// @throws LaunchError
std::vector<std::uint64_t> filter_program(SandboxProfile::Calls calls) {
  // A trap and not a plain kill: the worker's own handler can then say which call it was before it ends.
  const bool builds = calls == SandboxProfile::Calls::build;
  const std::unique_ptr<void, decltype(&::seccomp_release)> filter(
      ::seccomp_init(builds ? SCMP_ACT_ALLOW : SCMP_ACT_TRAP), ::seccomp_release);
  const auto require = [](int result) {
    if (result < 0) throw LaunchError("make a filter of system calls", -result);
  };
  int ends[2];  // of a pipe: a file may not grow where files are limited
  require(::pipe2(ends, O_CLOEXEC) == 0 ? 0 : -errno);
  const Descriptor from(ends[0]), to(ends[1]);
  require(filter ? 0 : -ENOMEM);
  require(::seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  for (const Rule& rule : rules_of(calls))
    if (rule.call >= 0)  // newer architectures do without some
      require(::seccomp_rule_add_array(filter.get(), rule.action, rule.call,
                                       static_cast<unsigned>(rule.arguments.size()), rule.arguments.data()));
  require(::seccomp_export_bpf(filter.get(), to.number()));
  static_assert(sizeof(sock_filter) == sizeof(std::uint64_t));
  std::vector<std::uint64_t> program(BPF_MAXINSNS);
  const ssize_t size = ::read(from.number(), program.data(), program.size() * sizeof(std::uint64_t));
  require(size > 0 ? 0 : -EIO);
  program.resize(static_cast<std::size_t>(size) / sizeof(std::uint64_t));
  return program;
}

}  // namespace

const std::vector<std::uint64_t>& system_call_filter(SandboxProfile::Calls calls) {
  static std::map<SandboxProfile::Calls, std::vector<std::uint64_t>> made;
  std::vector<std::uint64_t>& filter = made[calls];
  if (filter.empty()) filter = filter_program(calls);
  return filter;
}

}  // namespace workbook
