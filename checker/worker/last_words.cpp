#include "checker/worker/last_words.hpp"

#include "checker/worker/frames.hpp"

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <exception>

namespace workbook {
namespace {

std::uintptr_t stack_begin = 0;
std::uintptr_t stack_size = 0;
std::terminate_handler usual_terminate = nullptr;

void say(int signal, std::int64_t detail, const char* text) {
  frames::ReplyHeader words{};
  words.magic = frames::reply_magic;
  words.status = frames::Status::last_words;
  words.signal = signal;
  words.detail = detail;
  std::strncpy(words.text, text, sizeof words.text - 1);
  [[maybe_unused]] const ssize_t unused = ::write(frames::channel, &words, sizeof words);
}

void on_forbidden_call(int signal, siginfo_t* info, void*) {
  say(signal, info->si_syscall, "");
  ::raise(signal);  // the handler is already reset: this ends the process
}

/// An address near the lower end of the stack: only a stack that grew too far touches memory there.
bool is_stack_overflow(std::uintptr_t address) {
  constexpr std::uintptr_t margin = std::uintptr_t{256} * 1024;
  constexpr std::uintptr_t largest_step = std::uintptr_t{16} * 1024 * 1024;
  const std::uintptr_t depth = stack_begin - address;
  return address < stack_begin && depth + margin > stack_size && depth < stack_size + largest_step;
}

void on_bad_address(int signal, siginfo_t* info, void*) {
  const bool overflow = is_stack_overflow(reinterpret_cast<std::uintptr_t>(info->si_addr));
  say(signal, overflow ? frames::stack_used_up : 0, "");
  ::raise(signal);
}

void on_terminate() {
  try {
    if (const std::exception_ptr flying = std::current_exception()) std::rethrow_exception(flying);
  } catch (const std::exception& error) {
    say(SIGABRT, 0, error.what());
  } catch (...) {
    say(SIGABRT, 0, "something that is not a std::exception");
  }
  usual_terminate();
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
  ::sigaction(signal, &action, nullptr);
}

/// 101 is the first priority open to programs: ahead of every ordinary static object.
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
}

}  // namespace

void keep_last_words_linked() {}

}  // namespace workbook
