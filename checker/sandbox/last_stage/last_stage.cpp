// Started by bubblewrap in new namespaces, as their first process: sets the limits and filters that bubblewrap cannot,
// starts the program, and tells the checker how that ended, for bubblewrap tells signals and exit statuses apart no
// more. With the end of this process everything in its namespaces ends. A small static program of its own, because it
// is started for every run.
//
//   last_stage PROFILE... PROGRAM ARGUMENT...      see to_arguments(SandboxProfile)
//   last_stage NUMBER                              makes this one of the attempts; exit status 1 if it succeeds, else 0
#include "checker/base/child_process.hpp"
#include "checker/sandbox/last_stage/attempts.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace workbook {
namespace {

void say(ProcessReport report, const char* step = "") {
  std::strncpy(report.step, step, sizeof report.step - 1);
  // If the checker has closed its end, we are about to be killed: ignore the error.
  [[maybe_unused]] const ssize_t unused = ::write(report_descriptor, &report, sizeof report);
}

[[noreturn]] void exec_program(char** program, const SandboxProfile& profile, int landlock) {
  say({ProcessReport::begun});
  const bool has_descriptor = ::fcntl(program_descriptor, F_GETFD) >= 0;  // else it is started by its path
  const char* failed = enter_sandbox(profile, landlock);
  if (!failed) {
    if (has_descriptor)
      ::syscall(SYS_execveat, program_descriptor, "", program, environ, AT_EMPTY_PATH);
    else
      ::execve(program[0], program, environ);
    failed = "start the program";
  }
  say({ProcessReport::failed, errno}, failed);
  ::_exit(127);
}

/// Waits for the end of the program, or ends it when the checker closes its side.
void watch(pid_t program, const sigset_t& usual_signals) {
  int status = 0;
  rusage usage{};
  while (::wait4(program, &status, WNOHANG, &usage) == 0) {
    pollfd checker{report_descriptor, POLLIN, 0};
    if (::ppoll(&checker, 1, nullptr, &usual_signals) > 0) {
      ::kill(program, SIGKILL);
      ::wait4(program, &status, 0, &usage);
      break;
    }
  }
  say({ProcessReport::ended, status, seconds(usage)});
}

int start(char** words) {
  const SandboxProfile profile = read_profile(words);
  const int landlock = what_the_kernel_offers().landlock;
  ::unsetenv("PWD");            // set by bubblewrap
  ::prctl(PR_SET_DUMPABLE, 0);  // to nobody in these namespaces
  for (const int descriptor : {report_descriptor, program_descriptor}) ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  ::signal(SIGCHLD, [](int) {});  // wakes the waiting
  sigset_t awaited, usual_signals;
  ::sigemptyset(&awaited);
  ::sigaddset(&awaited, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &awaited, &usual_signals);
  // Goes on here when the program has started, or has not.
  const auto program =
      static_cast<pid_t>(::syscall(SYS_clone, CLONE_VFORK | SIGCHLD, nullptr, nullptr, nullptr, nullptr));
  if (program < 0) {
    say({ProcessReport::failed, errno}, "start a process");
    return 127;
  }
  if (program == 0) {
    ::signal(SIGCHLD, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &usual_signals, nullptr);
    exec_program(words, profile, landlock);
  }
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO, channel_descriptor, program_descriptor})
    ::close(descriptor);  // so that the checker sees when the program closes them
  say({ProcessReport::started});
  watch(program, usual_signals);
  return 0;
}

}  // namespace
}  // namespace workbook

int main(int count, char** words) {
  return count == 2 ? workbook::attempts[std::atoi(words[1])].succeeds() : workbook::start(words + 1);
}
