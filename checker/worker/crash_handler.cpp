#include "checker/worker/crash_handler.hpp"

#include "checker/worker/protocol.hpp"
#include "checker/worker/stack.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <exception>

namespace workbook {
namespace {

Stack stack;
std::terminate_handler usual_terminate = nullptr;

void say(int signal, std::int64_t detail, const char* text) {
  protocol::ReplyHeader words{};
  words.magic = protocol::reply_magic;
  words.status = protocol::Status::crash_report;
  words.signal = signal;
  words.detail = detail;
  std::strncpy(words.text, text, sizeof words.text - 1);
  [[maybe_unused]] const ssize_t unused = ::write(protocol::channel, &words, sizeof words);
}

void on_forbidden_call(int signal, siginfo_t* info, void*) {
  say(signal, info->si_syscall, "");
  ::raise(signal);  // the handler is already reset: this ends the process
}

void on_bad_address(int signal, siginfo_t* info, void* context) {
  say(signal, stack.overflowed(*info, context) ? protocol::stack_used_up : 0, "");
  ::raise(signal);
}

void on_terminate() {
  try {
    if (const std::exception_ptr flying = std::current_exception()) std::rethrow_exception(flying);
  } catch (const std::exception& error) {
    say(SIGABRT, 0, error.what());
  } catch (...) {
    say(SIGABRT, protocol::foreign_exception, "");
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
  stack.measure();
  handle(SIGSYS, on_forbidden_call);
  handle(SIGSEGV, on_bad_address);
  usual_terminate = std::set_terminate(on_terminate);
}

}  // namespace

void keep_crash_handler_linked() {}

}  // namespace workbook
