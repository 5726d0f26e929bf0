#include "checker/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <thread>

namespace workbook {
namespace {

/// Sent from the new process when it cannot become the program. It is a copy of the checker: a literal stands at the
/// same address in both.
struct Failure {
  const char* step;
  int reason;
};

constexpr int first_free_descriptor = program_descriptor + 1;

struct Ends {
  Descriptor ours;
  Descriptor theirs;
};

Ends pipe_from_child() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw LaunchError("open a pipe", errno);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Ends pipe_to_child() {
  Ends pipe = pipe_from_child();
  std::swap(pipe.ours, pipe.theirs);
  return pipe;
}

Ends socket_pair() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw LaunchError("open a channel", errno);
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Null-terminated pointers into strings that live on.
std::vector<char*> pointers(const std::vector<std::string>& strings, const std::string* first = nullptr) {
  std::vector<char*> result;
  if (first) result.push_back(const_cast<char*>(first->c_str()));
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
    const char* failed = place_descriptors();
    if (!failed) failed = tie_to_checker();
    if (!failed && directory && ::chdir(directory) != 0) failed = "enter its directory";
    if (!failed && launch.with_channel && !open_program()) failed = "start the program";
    if (!failed && launch.prepare) failed = launch.prepare();
    if (!failed) {
      if (launch.with_channel)
        ::syscall(SYS_execveat, program_descriptor, "", arguments, environment, AT_EMPTY_PATH);
      else
        ::execve(launch.program.c_str(), arguments, environment);
      failed = "start the program";
    }
    const Failure failure{failed, errno};
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

  const char* place_descriptors() noexcept {
    // First all out of the way of the places that they shall take.
    for (int* descriptor : {&input, &output, &channel, &report}) {
      *descriptor = ::fcntl(*descriptor, F_DUPFD_CLOEXEC, first_free_descriptor);
      if (*descriptor < 0) return "move its descriptors";
    }
    if (::dup2(input, STDIN_FILENO) < 0 || ::dup2(output, STDOUT_FILENO) < 0 || ::dup2(output, STDERR_FILENO) < 0 ||
        ::dup2(channel, channel_descriptor) < 0 || ::dup3(report, report_descriptor, O_CLOEXEC) < 0)
      return "place its descriptors";
    report = report_descriptor;
    ::closefrom(program_descriptor);
    return nullptr;
  }

  /// The kernel ends a program with its parent, but not the children of that program, and a compiler has some. For
  /// them is the lifeline: when nobody holds its other end any more, the kernel sends the signal to their whole group.
  const char* tie_to_checker() const noexcept {
    if (::setsid() < 0) return "open its own session";
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return "tie its life to the checker";
    if (!launch.with_channel) {
      ::fcntl(channel_descriptor, F_SETOWN, -::getpid());
      ::fcntl(channel_descriptor, F_SETSIG, SIGKILL);
      ::fcntl(channel_descriptor, F_SETFL, O_ASYNC);
    }
    if (::getppid() != checker) ::_exit(127);  // the checker is gone already
    return nullptr;
  }

  bool open_program() const noexcept {
    const int program = ::open(launch.program.c_str(), O_PATH | O_CLOEXEC);
    return program == program_descriptor ||
           (program >= 0 && ::dup3(program, program_descriptor, O_CLOEXEC) == program_descriptor);
  }
};

void set_nonblocking(int descriptor) { ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK); }

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

LaunchError::LaunchError(const char* failed_step, int system_error)
    : std::runtime_error(std::string(failed_step) + ": " + std::generic_category().message(system_error)),
      step(failed_step),
      reason(system_error) {}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, 3'600'000));
}

ChildProcess::ChildProcess(const Launch& launch) {
  const Ends input = pipe_to_child();  // closed at once: there is nothing to read
  Ends output = pipe_from_child();
  Ends report = pipe_from_child();
  Ends channel = launch.with_channel ? socket_pair() : pipe_to_child();
  const std::vector<char*> arguments = pointers(launch.arguments, &launch.program);
  const std::vector<char*> environment = pointers(launch.environment);
  const std::string directory = launch.directory.string();
  NewProcess child{launch,
                   arguments.data(),
                   environment.data(),
                   directory.empty() ? nullptr : directory.c_str(),
                   ::getpid(),
                   input.theirs.number(),
                   output.theirs.number(),
                   channel.theirs.number(),
                   report.theirs.number()};
  process_ = ::fork();
  if (process_ < 0) throw LaunchError("start a process", errno);
  if (process_ == 0) child.become_program();

  output_ = std::move(output.ours);
  set_nonblocking(output_.number());
  (launch.with_channel ? channel_ : lifeline_) = std::move(channel.ours);
  if (launch.with_channel) set_nonblocking(channel_.number());
  report.theirs.close();
  Failure failure{};
  ssize_t got = 0;
  do got = ::read(report.ours.number(), &failure, sizeof failure);
  while (got < 0 && errno == EINTR);
  if (got == 0) return;  // closed by exec: the program runs
  kill();
  if (got == sizeof failure) throw LaunchError(failure.step, failure.reason);
  throw LaunchError("hear from the new process", EPIPE);
}

ChildProcess::~ChildProcess() { kill(); }

void ChildProcess::ask_to_end() {
  if (!end_) ::kill(process_, SIGTERM);
}

void ChildProcess::close_write() { ::shutdown(channel_.number(), SHUT_WR); }

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
    const int ready = ::poll(&watched, 1, milliseconds_until(deadline));
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
    finished.too_much_output = finished.output.size() > output_limit;
  }
  finished.output.resize(std::min(finished.output.size(), output_limit));
  if (!finished.out_of_time && !finished.too_much_output) {
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
