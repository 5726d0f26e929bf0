#include "checker/worker/instrumented/eyes.hpp"

#include "checker/worker/instrumented/facts.hpp"
#include "checker/worker/stack.hpp"

#include <fenv.h>
#include <signal.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <string_view>
#include <typeinfo>

namespace workbook {
namespace {

using sightings::Arithmetic;
using sightings::Sighting;
using sightings::What;

std::uint64_t nonce = 0;
bool watching = false;
bool said_undefined = false;
Stack stack;
std::terminate_handler usual_terminate = nullptr;

/// Made when something is thrown; sent if the function ends with it.
Sighting thrown{};
const void* thrown_object = nullptr;
int throws = 0;

/// The chain of calls up to here.
struct Chain {
  Sighting& sighting;
  std::uint64_t skipped_until;  ///< the instruction that a signal interrupted; 0: nothing is skipped

  static _Unwind_Reason_Code add(_Unwind_Context* frame, void* self) {
    auto& chain = *static_cast<Chain*>(self);
    Sighting& sighting = chain.sighting;
    int is_before = 0;
    // A return address points behind its call; that of an interrupted instruction at the instruction itself.
    const std::uint64_t next = _Unwind_GetIPInfo(frame, &is_before);
    if (next == chain.skipped_until) chain.skipped_until = 0;
    if (chain.skipped_until != 0) return _URC_NO_REASON;
    const std::uint64_t address = is_before == 0 ? next - 1 : next;
    constexpr int most = sizeof sighting.calls / sizeof *sighting.calls;
    if (sighting.call_count < most)
      sighting.calls[sighting.call_count++] = address;
    else if (std::find(sighting.calls, sighting.calls + most, address) != sighting.calls + most)
      ++sighting.repeated;
    constexpr int deep_enough = 5000;
    return sighting.repeated < deep_enough ? _URC_NO_REASON : _URC_NORMAL_STOP;
  }
};

void copy(char* to, std::size_t size, const char* text) { std::strncpy(to, text ? text : "", size - 1); }

Sighting sighting_of(What what, const char* text, std::uint64_t interrupted = 0) {
  Sighting sighting{};
  sighting.magic = sightings::sighting_magic;
  sighting.nonce = nonce;
  sighting.what = what;
  copy(sighting.text, sizeof sighting.text, text);
  Chain chain{sighting, interrupted};
  _Unwind_Backtrace(&Chain::add, &chain);
  return sighting;
}

void send(const void* from, std::size_t size) {
  const char* next = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t put = ::write(protocol::channel, next, size);
    if (put <= 0) return;
    next += put;
    size -= static_cast<std::size_t>(put);
  }
}

void send(const Sighting& sighting) {
  if (nonce != 0) send(&sighting, sizeof sighting);
}

void set_facts(Sighting& sighting, const Facts& facts) {
  sighting.fact_count = facts.count;
  std::copy(facts.numbers, facts.numbers + Facts::most, sighting.facts);
}

#if defined(__x86_64__)

/// Reads the instruction that trapped. Only what is certain is named.
Arithmetic arithmetic_at(const ucontext_t& context) {
  const auto* byte = reinterpret_cast<const unsigned char*>(context.uc_mcontext.gregs[REG_RIP]);
  unsigned char prefix = 0;
  unsigned char rex = 0;
  while (*byte == 0xf2 || *byte == 0xf3 || *byte == 0x66) prefix = *byte++;
  if ((*byte & 0xf0) == 0x40) rex = *byte++;
  if (*byte++ != 0x0f) return Arithmetic::unknown;
  const unsigned char operation = *byte++;
  switch (operation) {
    case 0x5e: {
      if (prefix != 0xf2) return Arithmetic::division;
      const int destination = ((*byte >> 3) & 7) | ((rex & 4) << 1);
      double numerator = 0.0;
      std::memcpy(&numerator, context.uc_mcontext.fpregs->_xmm[destination].element, sizeof numerator);
      return numerator == 0.0 ? Arithmetic::zero_by_zero : Arithmetic::division;
    }
    case 0x51:
      return Arithmetic::root;
    case 0x2e:
    case 0x2f:
    case 0xc2:
      return Arithmetic::comparison;
    case 0x2c:
    case 0x2d:
      return Arithmetic::conversion;
    case 0x58:
    case 0x59:
    case 0x5c:
      return Arithmetic::other;
    default:
      return Arithmetic::unknown;
  }
}

#else

Arithmetic arithmetic_at(const ucontext_t&) { return Arithmetic::unknown; }

#endif

/// Where a signal came; 0 where that is not known, and the handler stands in the chain of calls too.
std::uint64_t interrupted_at([[maybe_unused]] const void* context) {
#if defined(__x86_64__)
  return static_cast<std::uint64_t>(static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return static_cast<const ucontext_t*>(context)->uc_mcontext.pc;
#else
  return 0;
#endif
}

/// The handlers are already reset when they run, so raising the signal again ends the process.
void on_signal(int signal, siginfo_t* info, void* context) {
  const bool overflow = signal == SIGSEGV && stack.overflowed(*info, context);
  const What what = signal == SIGSYS ? What::forbidden_call : overflow ? What::stack_used_up : What::signal;
  Sighting sighting = sighting_of(what, "", interrupted_at(context));
  sighting.signal = signal;
  sighting.detail = signal == SIGSYS ? info->si_syscall : info->si_code;
  sighting.address = signal == SIGSEGV ? reinterpret_cast<std::uintptr_t>(info->si_addr) : 0;
  if (signal == SIGFPE) sighting.arithmetic = arithmetic_at(*static_cast<ucontext_t*>(context));
  send(sighting);
  ::raise(signal);
}

void on_question(int, siginfo_t*, void* context) {
  if (watching) send(sighting_of(What::still_running, "", interrupted_at(context)));
}

void on_terminate() {
  try {
    if (const std::exception_ptr flying = std::current_exception()) std::rethrow_exception(flying);
    say(What::terminated, "");
  } catch (const std::exception& error) {
    say_thrown(What::terminated, error.what(), &error);
  } catch (...) {
    say_thrown(What::terminated, "", nullptr);
  }
  usual_terminate();
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER | flags;
  ::sigaction(signal, &action, nullptr);
}

/// 101 is the first priority open to programs: ahead of every ordinary static object.
[[gnu::constructor(101)]] void install() {
  alignas(16) static char own_stack[256 * 1024];
  stack_t spare{};
  spare.ss_sp = own_stack;
  spare.ss_size = sizeof own_stack;
  ::sigaltstack(&spare, nullptr);
  stack.measure();
  for (const int signal : {SIGSYS, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    handle(signal, on_signal, static_cast<int>(SA_RESETHAND));
  handle(SIGALRM, on_question, SA_RESTART);
  usual_terminate = std::set_terminate(on_terminate);
}

void say_ended() {
  if (watching) say(What::program_ended, "");
}

}  // namespace

void open_eyes(std::uint64_t own_nonce) { nonce = own_nonce; }

void watch() { watching = true; }

void stop_watching() { watching = false; }

void say(What what, const char* text) { send(sighting_of(what, text)); }

void say_thrown(What what, const char* text, const void* exception) {
  // An exception that was caught and thrown again may not be the one that was thrown last.
  constexpr std::ptrdiff_t largest = 1024;
  const std::ptrdiff_t offset = static_cast<const char*>(exception) - static_cast<const char*>(thrown_object);
  const bool is_the_last = exception != nullptr ? offset >= 0 && offset < largest : throws == 1;
  Sighting sighting = is_the_last ? thrown : Sighting{};
  sighting.magic = sightings::sighting_magic;
  sighting.nonce = nonce;
  if (what != sighting.what) {
    sighting.what = what;
    std::memset(sighting.text, 0, sizeof sighting.text);
    copy(sighting.text, sizeof sighting.text, text);
  } else if (what == What::exception) {
    copy(sighting.text, sizeof sighting.text, text);
  }
  send(sighting);
}

void say_undefined(sightings::Undefined what, const char* type, const Facts& facts) {
  if (!watching || said_undefined) return;
  said_undefined = true;
  Sighting sighting = sighting_of(What::undefined_behavior, type);
  sighting.detail = static_cast<std::int64_t>(what);
  set_facts(sighting, facts);
  send(sighting);
}

void say_returned(int rows, int cols, const double* numbers) {
  Sighting sighting{};
  sighting.magic = sightings::sighting_magic;
  sighting.nonce = nonce;
  sighting.what = What::returned;
  sighting.rows = rows;
  sighting.cols = cols;
  send(sighting);
  if (nonce != 0) send(numbers, sizeof(double) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
}

void report_eigen_assertion(const char* condition, const Facts& facts) {
  // While `v << 1, f(), 3` is left because f threw, its destructor finds numbers missing; the first exception counts.
  if (std::uncaught_exceptions() > 0 &&
      std::string_view(condition).find("Too few coefficients") != std::string_view::npos)
    return;
  const EigenError error(condition);
  Sighting sighting = sighting_of(What::eigen_assertion, condition);
  set_facts(sighting, facts);
  thrown = sighting;
  throw error;
}

void report_library_assertion(const char* function, const char* condition, const Sides& sides) {
  Sighting sighting = sighting_of(What::library_assertion, condition);
  copy(sighting.more_text, sizeof sighting.more_text, function);
  if (sides.known) set_facts(sighting, facts(sides.left, sides.right));
  send(sighting);
  ::signal(SIGABRT, SIG_DFL);
  ::abort();
}

}  // namespace workbook

using workbook::sightings::What;

// The linker sends the calls of these functions here (--wrap).
extern "C" {

[[noreturn]] void __real___cxa_throw(void* exception, std::type_info* type, void (*destructor)(void*));
[[noreturn]] void __wrap___cxa_throw(void* exception, std::type_info* type, void (*destructor)(void*));
[[noreturn]] void __real_exit(int status);
[[noreturn]] void __wrap_exit(int status);
[[noreturn]] void __real__exit(int status);
[[noreturn]] void __wrap__exit(int status);
[[noreturn]] void __real__Exit(int status);
[[noreturn]] void __wrap__Exit(int status);
[[noreturn]] void __real_quick_exit(int status);
[[noreturn]] void __wrap_quick_exit(int status);
[[noreturn]] void __wrap___assert_fail(const char* condition, const char* file, unsigned line, const char* function);

void __wrap___cxa_throw(void* exception, std::type_info* type, void (*destructor)(void*)) {
  if (workbook::watching) {
    // An assertion of Eigen was remembered already, with its facts.
    if (*type != typeid(workbook::EigenError)) workbook::thrown = workbook::sighting_of(What::exception, "");
    workbook::thrown_object = exception;
    ++workbook::throws;
  }
  __real___cxa_throw(exception, type, destructor);
}

void __wrap_exit(int status) {
  workbook::say_ended();
  __real_exit(status);
}

void __wrap__exit(int status) {
  workbook::say_ended();
  __real__exit(status);
}

void __wrap__Exit(int status) {
  workbook::say_ended();
  __real__Exit(status);
}

void __wrap_quick_exit(int status) {
  workbook::say_ended();
  __real_quick_exit(status);
}

void __wrap___assert_fail(const char* condition, const char*, unsigned, const char*) {
  if (workbook::watching) workbook::say(What::own_assertion, condition);
  ::signal(SIGABRT, SIG_DFL);
  ::abort();
}
}
