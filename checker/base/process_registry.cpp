#include "checker/base/process_registry.hpp"

#include <signal.h>

#include <array>
#include <atomic>

namespace workbook::process_registry {

namespace {

/// Of fixed size and without locks, because a signal handler reads it. One more than fit is left to the kernel.
std::array<std::atomic<pid_t>, 64> leaders{};
static_assert(std::atomic<pid_t>::is_always_lock_free);

void replace(pid_t old_leader, pid_t new_leader) noexcept {
  for (std::atomic<pid_t>& leader : leaders) {
    pid_t expected = old_leader;
    if (leader.compare_exchange_strong(expected, new_leader)) return;
  }
}

extern "C" void end_all(int number) {
  for (const std::atomic<pid_t>& leader : leaders) {
    if (const pid_t group = leader.load(); group > 0) ::kill(-group, SIGKILL);
  }
  ::raise(number);  // the handler is gone by now: this ends the checker
}

}  // namespace

void add(pid_t leader) noexcept { replace(0, leader); }

void remove(pid_t leader) noexcept { replace(leader, 0); }

void end_with_the_checker() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = end_all;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    ::sigaction(number, &action, nullptr);
  }
}

}  // namespace workbook::process_registry
