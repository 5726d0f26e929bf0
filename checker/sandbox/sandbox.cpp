#include "checker/sandbox/sandbox.hpp"

#include "checker/messages/machine.hpp"
#include "checker/messages/running.hpp"

#include <sys/prctl.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

#if WORKBOOK_HAS_SECCOMP
#include "checker/base/descriptor.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#endif

namespace workbook {
namespace {

bool limit(decltype(RLIMIT_CPU) resource, rlim_t soft, rlim_t hard) noexcept {
  rlimit now{};
  if (::getrlimit(resource, &now) != 0) return false;
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return ::setrlimit(resource, &wanted) == 0;
}

#if WORKBOOK_HAS_SECCOMP

bool kernel_has_filters() { return ::prctl(PR_GET_SECCOMP) >= 0 || errno != EINVAL; }

/// Stands in the filter for the process number of the worker, which is known only after the fork. No process has it:
/// Linux numbers end at 2²².
constexpr std::uint32_t own_process = 0x5e1f5e1f;

/// What a static program may do that computes, prints, sleeps and reads the clock.
constexpr int allowed_calls[] = {
    // memory
    SCMP_SYS(brk), SCMP_SYS(mmap), SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(mprotect), SCMP_SYS(madvise),
    // the descriptors that it was given
    SCMP_SYS(read), SCMP_SYS(write), SCMP_SYS(readv), SCMP_SYS(writev), SCMP_SYS(lseek), SCMP_SYS(fstat),
    SCMP_SYS(close),
    // start and end
    SCMP_SYS(arch_prctl), SCMP_SYS(set_tid_address), SCMP_SYS(set_robust_list), SCMP_SYS(rseq), SCMP_SYS(futex),
    SCMP_SYS(getrandom), SCMP_SYS(getrlimit), SCMP_SYS(exit), SCMP_SYS(exit_group),
    // its own signal handlers
    SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(sigaltstack),
    SCMP_SYS(restart_syscall),
    // clocks
    SCMP_SYS(clock_gettime), SCMP_SYS(clock_getres), SCMP_SYS(gettimeofday), SCMP_SYS(time), SCMP_SYS(times),
    SCMP_SYS(nanosleep), SCMP_SYS(clock_nanosleep),
    // harmless questions
    SCMP_SYS(getpid), SCMP_SYS(getppid), SCMP_SYS(gettid), SCMP_SYS(getuid), SCMP_SYS(geteuid), SCMP_SYS(getgid),
    SCMP_SYS(getegid), SCMP_SYS(uname), SCMP_SYS(sysinfo), SCMP_SYS(getrusage), SCMP_SYS(getcpu), SCMP_SYS(sched_yield),
    SCMP_SYS(sched_getaffinity)};

using messages::Forbidden;

struct Purpose {
  const char* call;
  Forbidden operation;
};

using enum Forbidden;

constexpr Purpose purposes[] = {
    {"open", file},           {"openat", file},           {"openat2", file},         {"creat", file},
    {"fork", process},        {"vfork", process},         {"clone", process},        {"clone3", process},
    {"execve", program},      {"execveat", program},      {"socket", network},       {"socketpair", network},
    {"connect", network},     {"kill", signal_others},    {"tkill", signal_others},  {"tgkill", signal_others},
    {"ptrace", spy},          {"pidfd_open", spy},        {"process_vm_readv", spy}, {"process_vm_writev", spy},
    {"unlink", change_files}, {"unlinkat", change_files}, {"rename", change_files},  {"renameat2", change_files},
    {"mkdir", change_files},  {"mkdirat", change_files},  {"rmdir", change_files},   {"chmod", change_files}};

#endif

}  // namespace

std::optional<messages::LaunchStep> Sandbox::enter(unsigned processor_seconds) noexcept {
  using messages::LaunchStep;
  // A core limit of 1 and not 0: with 0 a system that hands core dumps to a collector would still start it.
  if (!limit(RLIMIT_CORE, 1, 1)) return LaunchStep::limit_core_dumps;
  // The hard limit ends a program that ignores the signal of the soft one.
  if (!limit(RLIMIT_CPU, processor_seconds, rlim_t{processor_seconds} + 1)) return LaunchStep::limit_processor_time;
  if (!limit(RLIMIT_AS, limits_.memory_bytes, limits_.memory_bytes)) return LaunchStep::limit_memory;
  if (!limit(RLIMIT_STACK, limits_.stack_bytes, limits_.stack_bytes)) return LaunchStep::limit_stack;
  if (!limit(RLIMIT_FSIZE, 0, 0)) return LaunchStep::limit_file_size;
  if (!limit(RLIMIT_NPROC, 0, 0)) return LaunchStep::limit_processes;
  if (!limit(RLIMIT_NOFILE, 8, 8)) return LaunchStep::limit_open_files;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return LaunchStep::give_up_privileges;
#if WORKBOOK_HAS_SECCOMP
  if (!filter_.empty()) {
    const auto self = static_cast<unsigned>(::getpid());
    for (Instruction& instruction : filter_)
      if (instruction.operand == own_process) instruction.operand = self;
    sock_fprog program{static_cast<unsigned short>(filter_.size()), reinterpret_cast<sock_filter*>(filter_.data())};
    if (::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0) return LaunchStep::filter_system_calls;
  }
#endif
  return std::nullopt;
}

#if WORKBOOK_HAS_SECCOMP

Sandbox::Sandbox(const std::filesystem::path& program, SandboxLimits limits)
    : program_(program.string()), limits_(limits) {
  if (kernel_has_filters()) build_filter();
}

void Sandbox::build_filter() {
  static_assert(sizeof(Instruction) == sizeof(sock_filter));
  const auto require = [](bool done) {
    if (!done) throw SandboxError(messages::filter_cannot_be_built());
  };
  // A trap and not a plain kill: the worker's own handler can then say which call it was before it ends.
  const std::unique_ptr<void, decltype(&seccomp_release)> context(seccomp_init(SCMP_ACT_TRAP), &seccomp_release);
  require(context != nullptr);
  const auto rule = [&](std::uint32_t action, int call, std::vector<scmp_arg_cmp> conditions = {}) {
    require(seccomp_rule_add_array(context.get(), action, call, static_cast<unsigned>(conditions.size()),
                                   conditions.data()) == 0);
  };
  require(seccomp_attr_set(context.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0);
  for (const int call : allowed_calls) rule(SCMP_ACT_ALLOW, call);

  rule(SCMP_ACT_ALLOW, SCMP_SYS(execve), {SCMP_A0_64(SCMP_CMP_EQ, reinterpret_cast<std::uintptr_t>(program_.c_str()))});
  const scmp_arg_cmp itself = SCMP_A0_64(SCMP_CMP_MASKED_EQ, 0xffffffff, own_process);
  rule(SCMP_ACT_ALLOW, SCMP_SYS(kill), {itself});  // abort() and raise() send signals
  rule(SCMP_ACT_ALLOW, SCMP_SYS(tgkill), {itself});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), {SCMP_A2_64(SCMP_CMP_EQ, 0)});  // reading limits, not setting them
  rule(SCMP_ACT_ALLOW, SCMP_SYS(fcntl), {SCMP_A1_32(SCMP_CMP_EQ, F_GETFL)});
  rule(SCMP_ACT_ALLOW, SCMP_SYS(newfstatat), {SCMP_A3_32(SCMP_CMP_EQ, AT_EMPTY_PATH)});  // fstat of newer C libraries
  rule(SCMP_ACT_ERRNO(ENOTTY), SCMP_SYS(ioctl));                                         // "is this a terminal?"
  rule(SCMP_ACT_ERRNO(ENOENT), SCMP_SYS(readlink));  // a static program asks for its own path when it starts
  rule(SCMP_ACT_ERRNO(ENOENT), SCMP_SYS(readlinkat));

  const Descriptor memory(::memfd_create("filter", MFD_CLOEXEC));
  require(static_cast<bool>(memory) && seccomp_export_bpf(context.get(), memory.number()) == 0);
  const off_t size = ::lseek(memory.number(), 0, SEEK_END);
  require(size > 0);
  filter_.resize(static_cast<std::size_t>(size) / sizeof(Instruction));
  require(::pread(memory.number(), filter_.data(), static_cast<std::size_t>(size), 0) == size);
}

SandboxStrength sandbox_strength() {
  if (kernel_has_filters()) return {true, messages::sandbox_is_whole()};
  return {false, messages::kernel_has_no_filter()};
}

std::string forbidden_operation(long system_call) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, static_cast<int>(system_call)), &std::free);
  if (!name) return messages::system_call(system_call);
  const std::string call = name.get();
  for (const Purpose& purpose : purposes)
    if (call == purpose.call) return messages::system_call(purpose.operation, call);
  return messages::system_call(call);
}

#else

Sandbox::Sandbox(const std::filesystem::path& program, SandboxLimits limits)
    : program_(program.string()), limits_(limits) {}

SandboxStrength sandbox_strength() { return {false, messages::built_without_filter()}; }

std::string forbidden_operation(long system_call) { return messages::system_call(system_call); }

#endif

}  // namespace workbook
