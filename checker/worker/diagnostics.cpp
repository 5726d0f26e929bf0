// What a worker says in a diagnostic run: the sanitizers' reports, and lines "event NAME" on what they do not see. The
// chain of calls follows each in lines "frame LINE|FILE|FUNCTION". checker/explain/diagnostic_run.cpp reads them.
#include "checker/worker/protocol.hpp"
#include "checker/worker/serve.hpp"

#include <dlfcn.h>
#include <fenv.h>
#include <sanitizer/common_interface_defs.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#define FRAMES "color=never:stack_trace_format='frame %l|%s|%f'"

extern "C" {
const char* __asan_default_options();
const char* __ubsan_default_options();
std::size_t __sanitizer_get_current_allocated_bytes();
void __sanitizer_malloc_hook(const volatile void* memory, std::size_t size);
}

// Newer compilers would keep variables on another stack, which nobody fills, to find uses after return.
const char* __asan_default_options() {
  return FRAMES
      ":detect_leaks=0:disable_coredump=0:handle_abort=1:handle_sigfpe=1:max_allocation_size_mb=512:"
      "malloc_context_size=0:quarantine_size_mb=16:print_legend=0:detect_stack_use_after_return=0";
}

const char* __ubsan_default_options() { return FRAMES ":print_stacktrace=1:print_summary=1:report_error_type=1"; }

namespace workbook {
namespace {

bool watching = false;
std::uint64_t filling = 0;

/// The address sanitizer reports abort() with its calls.
void on_forbidden_call(int, siginfo_t*, void*) {
  ::dprintf(STDERR_FILENO, "event forbidden\n");
  std::abort();
}

/// Alarms that come while others have the processors are one, so that their number tells how long the call has run: the
/// first ones, before a loop may have begun, are no samples.
void on_alarm(int, siginfo_t*, void*) {
  constexpr int before_samples = 24;
  static int alarms = 0, samples = 0;
  if (++alarms < before_samples) return;
  ::dprintf(STDERR_FILENO, "event running\n");
  __sanitizer_print_stack_trace();
  if (++samples == 16) ::_exit(0);
}

void report_exit() {
  if (!watching) return;
  ::dprintf(STDERR_FILENO, "event exit\n");
  __sanitizer_print_stack_trace();
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*)) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO;
  ::sigaction(signal, &action, nullptr);
}

[[gnu::no_sanitize("address")]] void fill(void* first, std::size_t bytes) {
  char* next = static_cast<char*>(first);
  for (; bytes >= sizeof filling; bytes -= sizeof filling, next += sizeof filling)
    std::memcpy(next, &filling, sizeof filling);
  std::memcpy(next, &filling, bytes);
}

}  // namespace

void before_call(std::int32_t mode) {
  // Standard error is for reports: what the student prints goes nowhere.
  ::dup2(STDIN_FILENO, STDOUT_FILENO);
  for (std::ostream* stream : {&std::cout, &std::cerr, &std::clog}) stream->rdbuf(nullptr);
  filling = (mode & protocol::fill_with_nan) != 0 ? protocol::never_set : 0;
  handle(SIGSYS, on_forbidden_call);
  std::atexit(report_exit);
  std::at_quick_exit(report_exit);
  std::feclearexcept(FE_ALL_EXCEPT);
  if ((mode & (protocol::trap_invalid | protocol::trap_non_finite)) != 0) ::feenableexcept(FE_INVALID);
  if ((mode & protocol::trap_non_finite) != 0) ::feenableexcept(FE_DIVBYZERO | FE_OVERFLOW);
  if ((mode & protocol::sample) != 0) {
    handle(SIGALRM, on_alarm);
    const itimerval often{{0, 13'000}, {0, 13'000}};  // no multiple of what loops are likely to take
    ::setitimer(ITIMER_REAL, &often, nullptr);        // a loop that sleeps uses hardly any processor time
  }
  watching = true;
}

// Optimised, so that it keeps nothing on the stack that it fills.
[[gnu::noinline, gnu::optimize("O2"), gnu::no_sanitize("address")]] void fill_memory(void* result, std::size_t size) {
  fill(result, size);
  constexpr std::size_t depth = std::size_t{128} * 1024;
  auto* next = reinterpret_cast<volatile std::uint64_t*>(__builtin_frame_address(0));
  for (std::size_t n = 0; n < depth / sizeof filling; ++n) *--next = filling;
}

void after_call() {
  ::fedisableexcept(FE_ALL_EXCEPT);
  watching = false;
}

}  // namespace workbook

// These stand before the functions of the same names in the C++ and sanitizer libraries.
extern "C" void __cxa_throw(void* object, void* type, void (*destroy)(void*)) {
  constexpr int most = 20;  // more are no error, but a way of working
  static int thrown = 0;
  if (workbook::watching && ++thrown <= most) {
    ::dprintf(STDERR_FILENO, "event thrown\n");
    __sanitizer_print_stack_trace();
  }
  const auto next = reinterpret_cast<void (*)(void*, void*, void (*)(void*))>(::dlsym(RTLD_NEXT, "__cxa_throw"));
  next(object, type, destroy);
  std::abort();
}

void _exit(int status) {
  workbook::report_exit();
  ::syscall(SYS_exit_group, status);
  __builtin_unreachable();
}

void _Exit(int status) { ::_exit(status); }

void __sanitizer_malloc_hook(const volatile void* memory, std::size_t size) {
  constexpr std::size_t most_memory = std::size_t{512} << 20;
  if (!workbook::watching) return;
  if (__sanitizer_get_current_allocated_bytes() > most_memory) {
    workbook::after_call();
    ::dprintf(STDERR_FILENO, "event memory\n");
    std::abort();
  }
  workbook::fill(const_cast<void*>(memory), size);
}
