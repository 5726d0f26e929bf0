// Programs beside the checker: started without a shell, watched, and never left behind.
#include "tests/running/student.hpp"

#include "checker/base/child_process.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace workbook::testing {
namespace {

Launch shell(const std::string& script) {
  Launch launch;
  launch.program = "/bin/sh";
  launch.arguments = {"-c", script};
  launch.environment = {"PATH=/usr/bin:/bin"};
  return launch;
}

FinishedProgram finish(const std::string& script) {
  return run_program(shell(script), std::chrono::seconds(10), 10000);
}

}  // namespace

TEST_CASE("the end of a program is seen as it was") {
  CHECK(finish("exit 7").end.exit_status == 7);
  CHECK(finish("exit 7").end.signal == 0);
  CHECK(finish("kill -SEGV $$").end.signal == SIGSEGV);
  CHECK(finish("echo one; echo two >&2; echo three").output == "one\ntwo\nthree\n");
  CHECK(nothing_left_running());
}

TEST_CASE("a program starts with empty input, the given environment and no descriptors of the checker") {
  CHECK(finish("read word; echo \"$word\"").output == "\n");
  Launch launch = shell("echo $COLOUR $HOME");
  launch.environment = {"COLOUR=blue"};
  CHECK(run_program(launch, std::chrono::seconds(10), 1000).output == "blue\n");
  CHECK(finish("ls /proc/self/fd | wc -l").output == "5\n");  // 0, 1, 2, the lifeline, and what ls reads with
}

TEST_CASE("a program starts in its directory") {
  Launch launch = shell("pwd -P");
  launch.directory = std::filesystem::canonical(fresh_directory("start here"));
  CHECK(run_program(launch, std::chrono::seconds(10), 1000).output == launch.directory.string() + "\n");
}

TEST_CASE("a program that cannot be started says why") {
  const auto error = [](const Launch& launch) -> std::string {
    try {
      run_program(launch, std::chrono::seconds(10), 1000);
    } catch (const LaunchError& reason) {
      return reason.what();
    }
    return "no error";
  };
  Launch launch = shell("true");
  launch.directory = "/nowhere";
  CHECK(error(launch) == "enter its directory: No such file or directory");
  launch = shell("true");
  launch.program = "/nowhere/sh";
  CHECK(error(launch) == "start the program: No such file or directory");
  launch = shell("true");
  launch.prepare = [] {
    errno = EPERM;
    return "give up privileges";
  };
  CHECK(error(launch) == "give up privileges: Operation not permitted");
  CHECK(nothing_left_running());
}

TEST_CASE("a program and all its children end at the time limit") {
  const auto start = Clock::now();
  const FinishedProgram finished =
      run_program(shell("sleep 100 & sleep 100 & wait"), std::chrono::milliseconds(200), 1000);
  CHECK(finished.out_of_time);
  CHECK(finished.end.signal == SIGKILL);
  CHECK(Clock::now() - start < std::chrono::seconds(50));
  CHECK(nothing_left_running());
}

TEST_CASE("a program that closed its output is still limited") {
  const FinishedProgram finished = run_program(shell("exec >&- 2>&-; sleep 100"), std::chrono::milliseconds(200), 1000);
  CHECK(finished.out_of_time);
  CHECK(nothing_left_running());
}

TEST_CASE("children that outlive their program are ended with it") {
  CHECK(finish("sleep 100 >/dev/null 2>&1 & exit 3").end.exit_status == 3);
  CHECK(nothing_left_running());
}

TEST_CASE("a flood is cut") {
  const FinishedProgram finished = run_program(shell("while :; do echo again; done"), std::chrono::seconds(10), 1000);
  CHECK(finished.too_much_output);
  CHECK(finished.output.size() == 1000);
  CHECK(nothing_left_running());
}

TEST_CASE("an exception in the checker leaves no process behind") {
  CHECK_THROWS_AS(
      [] {
        const ChildProcess process(shell("sleep 100"));
        throw std::runtime_error("something in the checker");
      }(),
      std::runtime_error);
  CHECK(nothing_left_running());
}

TEST_CASE("however a checker ends, its programs and all their children end with it") {
  for (const int signal : {SIGKILL, SIGINT, SIGTERM, SIGHUP}) {
    CAPTURE(signal);
    const pid_t checker = ::fork();
    if (checker == 0) {
      const ChildProcess process(shell("sleep 100 & sleep 100 & echo started; wait"));
      pollfd started{process.output(), POLLIN, 0};
      ::poll(&started, 1, 10'000);
      ::signal(signal, SIG_DFL);
      ::raise(signal);
      ::_exit(0);
    }
    int status = 0;
    REQUIRE(::waitpid(checker, &status, 0) == checker);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(nothing_left_running());  // its children are ours now
  }
}

TEST_CASE("what ends others itself, as ninja does, is left to do so") {
  const std::filesystem::path ended = fresh_directory("ended") / "ended";
  const std::string others = fmt::format(
      "setpriv --pdeathsig TERM sh -c 'trap \"echo >\\\"{}\\\"; exit\" TERM; echo; while :; do sleep 0.1; done'; true",
      ended.string());
  Launch launch = shell(others);
  launch.ends_others = true;
  const FinishedProgram finished = run_program(launch, std::chrono::seconds(3600), 0);  // until it says something
  CHECK(finished.end.signal == SIGKILL);
  CHECK(nothing_left_running());
  CHECK(std::filesystem::exists(ended));
}

TEST_CASE("processor time is counted") {
  const FinishedProgram finished = finish("i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done");
  CHECK(finished.end.processor_seconds > 0.0);
  CHECK(finished.end.processor_seconds < 10.0);
}

TEST_CASE("a program starts with ordinary signals, whatever the checker ignores") {
  const auto before = ::signal(SIGPIPE, SIG_IGN);
  CHECK(finish("kill -PIPE $$").end.signal == SIGPIPE);
  ::signal(SIGPIPE, before);
}

}  // namespace workbook::testing
