#include "checker/base/child_process.hpp"

#include "checker/base/process_registry.hpp"
#include "checker/worker/protocol.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <thread>

namespace workbook {
namespace {

using messages::LaunchStep;

/// Sent from the new process when it cannot become the program.
struct Failure {
  LaunchStep step;
  int reason;
};

constexpr int report_descriptor = protocol::channel + 1;
constexpr int first_free_descriptor = report_descriptor + 1;

[[noreturn]] void launch_failed(LaunchStep step, int reason) {
  throw LaunchError(messages::launch_failed(step, std::generic_category().message(reason)));
}

struct Pipe {
  Descriptor reading;
  Descriptor writing;

  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) launch_failed(LaunchStep::open_pipe, errno);
    reading = Descriptor(ends[0]);
    writing = Descriptor(ends[1]);
  }
};

/// Null-terminated pointers into strings that live on.
std::vector<char*> pointers(const char* first, const std::vector<std::string>& strings) {
  std::vector<char*> result;
  if (first) result.push_back(const_cast<char*>(first));
  for (const std::string& string : strings) result.push_back(const_cast<char*>(string.c_str()));
  result.push_back(nullptr);
  return result;
}

/// The new process between fork and exec. Everything was allocated before; here are system calls only.
class NewProcess {
 public:
  const Launch& launch;
  char* const* arguments;
  char* const* environment;
  const char* directory;  ///< or nullptr
  pid_t checker;
  int input, output, channel, report;

  [[noreturn]] void become_program() noexcept {
    restore_signals();
    std::optional<LaunchStep> failed = leave_checker();
    if (!failed) failed = place_descriptors();
    if (!failed && directory && ::chdir(directory) != 0) failed = LaunchStep::enter_directory;
    if (!failed && launch.prepare) failed = launch.prepare();
    if (!failed) {
      ::execve(launch.program, arguments, environment);
      failed = LaunchStep::start_program;
    }
    const Failure failure{*failed, errno};
    [[maybe_unused]] const ssize_t unused = ::write(report, &failure, sizeof failure);
    ::_exit(127);
  }

 private:
  static void restore_signals() noexcept {
    for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
  }

  std::optional<LaunchStep> leave_checker() const noexcept {
    if (::setsid() < 0) return LaunchStep::open_session;
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return LaunchStep::tie_to_checker;
    if (::getppid() != checker) ::_exit(127);  // the checker is gone already
    return std::nullopt;
  }

  std::optional<LaunchStep> place_descriptors() noexcept {
    // First all out of the way of the places that they shall take.
    for (int* descriptor : {&input, &output, &channel, &report}) {
      if (*descriptor < 0) continue;
      *descriptor = ::fcntl(*descriptor, F_DUPFD_CLOEXEC, first_free_descriptor);
      if (*descriptor < 0) return LaunchStep::move_descriptors;
    }
    if (::dup2(input, STDIN_FILENO) < 0 || ::dup2(output, STDOUT_FILENO) < 0 || ::dup2(output, STDERR_FILENO) < 0 ||
        (channel >= 0 && ::dup2(channel, protocol::channel) < 0) || ::dup3(report, report_descriptor, O_CLOEXEC) < 0)
      return LaunchStep::place_descriptors;
    report = report_descriptor;
    if (channel < 0) ::close(protocol::channel);
    ::closefrom(first_free_descriptor);
    return std::nullopt;
  }
};

/// No signal is delivered while this lives; the new process takes them again by itself.
class SignalsHeldBack {
 public:
  SignalsHeldBack() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsHeldBack() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsHeldBack(const SignalsHeldBack&) = delete;
  SignalsHeldBack& operator=(const SignalsHeldBack&) = delete;

 private:
  sigset_t before_{};
};

void set_nonblocking(int descriptor) { ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK); }

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Milliseconds for poll, rounded up so that it does not spin at the end.
int poll_timeout(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, 3'600'000));
}

}  // namespace

ChildProcess::ChildProcess(const Launch& launch) {
  Pipe input, output, report;
  Descriptor far_end;
  if (launch.with_channel) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      launch_failed(LaunchStep::open_channel, errno);
    channel_ = Descriptor(ends[0]);
    far_end = Descriptor(ends[1]);
    set_nonblocking(channel_.number());
  }
  const std::vector<char*> arguments = pointers(launch.program, launch.arguments);
  const std::vector<char*> environment = pointers(nullptr, launch.environment);
  const std::string directory = launch.directory.string();
  NewProcess child{launch,
                   arguments.data(),
                   environment.data(),
                   directory.empty() ? nullptr : directory.c_str(),
                   ::getpid(),
                   input.reading.number(),
                   output.writing.number(),
                   far_end.number(),
                   report.writing.number()};

  {
    // A signal to end comes before the new process or after it is known, never between.
    const SignalsHeldBack held_back;
    process_ = ::fork();
    if (process_ < 0) launch_failed(LaunchStep::start_process, errno);
    if (process_ == 0) child.become_program();
    process_registry::add(process_);
  }

  output_ = std::move(output.reading);
  set_nonblocking(output_.number());
  report.writing.close();
  Failure failure{};
  ssize_t got = 0;
  do got = ::read(report.reading.number(), &failure, sizeof failure);
  while (got < 0 && errno == EINTR);
  if (got == 0) return;  // closed by exec: the program runs
  kill();
  if (got == sizeof failure) launch_failed(failure.step, failure.reason);
  launch_failed(LaunchStep::hear_from_process, EPIPE);
}

ChildProcess::~ChildProcess() { kill(); }

void ChildProcess::ask_to_end() {
  if (!end_) ::kill(process_, SIGTERM);
}

void ChildProcess::hang_up() { ::shutdown(channel_.number(), SHUT_WR); }

void ChildProcess::signal(int number) {
  // Until it is waited for, its number cannot name another process.
  if (!end_) ::kill(process_, number);
}

std::optional<ProcessEnd> ChildProcess::wait_until(Clock::time_point deadline) {
  while (!end_) {
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 && errno != EINTR)
      return reap();
    if (info.si_pid == process_) return reap();
    if (Clock::now() >= deadline) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return end_;
}

ProcessEnd ChildProcess::kill() {
  if (end_) return *end_;
  ::kill(process_, SIGKILL);
  return reap();
}

ProcessEnd ChildProcess::reap() {
  // While the leader is not waited for, its number cannot name another group.
  ::kill(-process_, SIGKILL);
  process_registry::remove(process_);
  int status = 0;
  rusage usage{};
  pid_t waited = 0;
  do waited = ::wait4(process_, &status, 0, &usage);
  while (waited < 0 && errno == EINTR);
  ProcessEnd end;
  if (waited == process_) {
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  end_ = end;
  return end;
}

FinishedProgram run_program(const Launch& launch, std::chrono::duration<double> time_limit, std::size_t output_limit,
                            const std::function<void(std::string_view)>& listener) {
  const Clock::time_point deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(time_limit);
  ChildProcess process(launch);
  FinishedProgram finished;
  std::array<char, 16384> buffer;
  while (!finished.out_of_time && !finished.too_much_output) {
    pollfd watched{process.output(), POLLIN, 0};
    const int ready = ::poll(&watched, 1, poll_timeout(deadline));
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      finished.out_of_time = Clock::now() >= deadline;
      continue;
    }
    const ssize_t got = ::read(process.output(), buffer.data(), buffer.size());
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (got <= 0) break;
    finished.output.append(buffer.data(), static_cast<std::size_t>(got));
    if (listener) listener({buffer.data(), static_cast<std::size_t>(got)});
    if (finished.output.size() > output_limit) {
      finished.output.resize(output_limit);
      finished.too_much_output = true;
    }
  }
  const bool closed_its_output = !finished.out_of_time && !finished.too_much_output;
  if (closed_its_output) {
    if (const std::optional<ProcessEnd> end = process.wait_until(deadline)) {
      finished.end = *end;
      return finished;
    }
    finished.out_of_time = true;
  }
  finished.end = process.kill();
  return finished;
}

}  // namespace workbook
