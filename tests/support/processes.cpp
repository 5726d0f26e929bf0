#include "tests/support/processes.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace workbook::testing {

namespace {

/// Orphans of a test's children become children of the test, where waitpid sees them.
const int adopts_orphans = ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);

}  // namespace

bool nothing_left_running() {
  // What was killed a moment ago may still be dying; how many have died does not matter.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(15);
  while (adopts_orphans == 0 && std::chrono::steady_clock::now() < deadline) {
    const pid_t ended = ::waitpid(-1, nullptr, WNOHANG);
    if (ended == -1) return errno == ECHILD;
    if (ended == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace workbook::testing
