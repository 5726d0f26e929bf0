// What a worker still says when a signal ends it: which system call was forbidden, that the stack is used up, what was
// thrown where nobody could catch it. The checker uses it as an explanation only; what ended the process it sees
// itself.
#include "checker/worker/protocol.hpp"

#include <malloc.h>
#include <signal.h>
#include <sys/resource.h>
#include <ucontext.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <exception>

namespace workbook {
namespace {

std::uintptr_t stack_begin = 0;
std::uintptr_t stack_size = 0;
std::terminate_handler usual_terminate = nullptr;

void say(int signal, std::int64_t detail, const char* text = "") {
  protocol::ReplyHeader report{};
  report.magic = protocol::reply_magic;
  report.status = protocol::Status::crash_report;
  report.signal = signal;
  report.detail = detail;
  std::strncpy(report.text, text, sizeof report.text - 1);
  [[maybe_unused]] const ssize_t unused = ::write(protocol::channel, &report, sizeof report);
}

/// Near the lower end of the stack, or below it by no more than a large array.
bool is_beyond_stack(std::uintptr_t address) {
  constexpr std::uintptr_t margin = std::uintptr_t{256} << 10, largest_step = std::uintptr_t{64} << 20;
  const std::uintptr_t depth = stack_begin - address;
  return address < stack_begin && depth + margin > stack_size && depth < stack_size + largest_step;
}

/// The stack pointer of the interrupted code: beyond the end even before an array as large as that is touched there.
std::uintptr_t stack_pointer([[maybe_unused]] const ucontext_t& context) {
#if defined(__x86_64__)
  return static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RSP]);
#elif defined(__aarch64__)
  return static_cast<std::uintptr_t>(context.uc_mcontext.sp);
#else
  return 0;
#endif
}

void on_forbidden_call(int signal, siginfo_t* info, void*) {
  say(signal, info->si_syscall);
  ::raise(signal);  // the handler is already reset: this ends the process
}

void on_bad_address(int signal, siginfo_t* info, void* context) {
  const bool overflow = is_beyond_stack(reinterpret_cast<std::uintptr_t>(info->si_addr)) ||
                        is_beyond_stack(stack_pointer(*static_cast<const ucontext_t*>(context)));
  say(signal, overflow ? protocol::stack_overflow : protocol::nothing_known);
  ::raise(signal);
}

void on_terminate() {
  try {
    if (const std::exception_ptr flying = std::current_exception()) std::rethrow_exception(flying);
  } catch (const std::exception& error) {
    say(SIGABRT, protocol::exception_with_text, error.what());
  } catch (...) {
    say(SIGABRT, protocol::exception_without_text);
  }
  usual_terminate();
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
  ::sigaction(signal, &action, nullptr);
}

/// 101 is the first priority open to programs: ahead of every ordinary static object of the student.
[[gnu::constructor(101)]] void install() {
  alignas(16) static char own_stack[64 * 1024];
  stack_t spare{};
  spare.ss_sp = own_stack;
  spare.ss_size = sizeof own_stack;
  ::sigaltstack(&spare, nullptr);
  stack_begin = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  rlimit limit{};
  ::getrlimit(RLIMIT_STACK, &limit);
  stack_size = static_cast<std::uintptr_t>(limit.rlim_cur);
  handle(SIGSYS, on_forbidden_call);
  handle(SIGSEGV, on_bad_address);
  usual_terminate = std::set_terminate(on_terminate);
  ::mallopt(M_PERTURB, 0x01);  // new memory on the heap holds 0xfe…: the same absurd number every time
}

}  // namespace
}  // namespace workbook
