#include "checker/base/child_process.hpp"

#include "checker/base/console.hpp"
#include "checker/base/text.hpp"

#include <fcntl.h>
#include <grp.h>
#include <linux/capability.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <thread>

namespace workbook {
namespace {

constexpr int first_free_descriptor = program_descriptor + 1;

/// Both ends of a pipe or of a channel. What is written to the second is read from the first.
struct Ends {
  Descriptor first, second;

  explicit Ends(bool is_channel = false) {
    std::array<int, 2> ends{};
    const int made = is_channel ? ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data())
                                : ::pipe2(ends.data(), O_CLOEXEC);
    if (made != 0) throw LaunchError(is_channel ? "open a channel" : "open a pipe", errno);
    first = Descriptor(ends[0]);
    second = Descriptor(ends[1]);
  }
};

/// Null-terminated pointers into strings that live on.
std::vector<char*> pointers(const std::vector<std::string>& strings) {
  std::vector<char*> result;
  result.reserve(strings.size() + 1);
  for (const std::string& string : strings) result.push_back(const_cast<char*>(string.c_str()));
  result.push_back(nullptr);
  return result;
}

void unblock_signals() noexcept {
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// The new process between fork and exec. Everything was allocated before; here are system calls only.
class NewProcess {
 public:
  const Launch& launch;
  char* const* arguments;
  char* const* environment;
  const char* directory;  ///< or nullptr
  pid_t checker;
  int input, output, lifeline, report;
  int channel;  ///< or that of the lifeline
  int program;  ///< or -1

  [[noreturn]] void become_program() noexcept {
    for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
    unblock_signals();
    const char* failed = tie_to_checker();
    if (!failed) failed = place_descriptors();
    if (!failed && directory && ::chdir(directory) != 0) failed = "enter its directory";
    if (!failed && launch.prepare) failed = launch.prepare();
    if (!failed) {
      if (launch.with_channel && launch.namespaces.empty())
        ::syscall(SYS_execveat, program_descriptor, "", arguments, environment, AT_EMPTY_PATH);
      else
        ::execve(arguments[0], arguments, environment);
      failed = "start the program";
    }
    ProcessReport said{ProcessReport::failed, errno};
    std::strncpy(said.step, failed, sizeof said.step - 1);
    [[maybe_unused]] const ssize_t unused = ::write(report, &said, sizeof said);
    ::_exit(127);
  }

 private:
  const char* place_descriptors() noexcept {
    // First all out of the way of the places that they shall take.
    const bool has_program = program >= 0;
    for (int* descriptor : {&input, &output, &channel, &report, &program}) {
      if (*descriptor < 0) continue;
      *descriptor = ::fcntl(*descriptor, F_DUPFD_CLOEXEC, first_free_descriptor);
      if (*descriptor < 0) return "move its descriptors";
    }
    if (::dup2(input, STDIN_FILENO) < 0 || ::dup2(output, STDOUT_FILENO) < 0 || ::dup2(output, STDERR_FILENO) < 0 ||
        ::dup2(channel, channel_descriptor) < 0 || ::dup3(report, report_descriptor, closed_by_exec()) < 0 ||
        (has_program && ::dup3(program, program_descriptor, closed_by_exec()) < 0))
      return "place its descriptors";
    report = report_descriptor;
    ::closefrom(has_program ? first_free_descriptor : program_descriptor);
    return nullptr;
  }

  /// The kernel ends a program with its parent, but not the children of that program, and a compiler has some. For
  /// them is the lifeline: when nobody holds its other end any more, the kernel sends the signal to their whole group.
  const char* tie_to_checker() const noexcept {
    if (::setsid() < 0) return "open its own session";
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return "tie its life to the checker";
    if (!launch.namespaces.empty()) {
      const pid_t guard = ::fork();
      if (guard < 0) return "start its guard";
      if (guard == 0) watch_lifeline();
    } else if (!launch.with_channel && !launch.ends_others) {
      ::fcntl(lifeline, F_SETOWN, -::getpid());
      ::fcntl(lifeline, F_SETSIG, SIGKILL);
      ::fcntl(lifeline, F_SETFL, O_ASYNC);
    }
    if (::getppid() != checker) ::_exit(127);  // the checker is gone already
    return nullptr;
  }

  /// Kills the group when the checker is gone. The first process of a namespace ignores the signal of a lifeline, and
  /// if bubblewrap is killed before it has set up the namespace, that process would wait for it for ever.
  [[noreturn]] void watch_lifeline() const noexcept {
    ::dup2(lifeline, STDIN_FILENO);
    ::closefrom(STDIN_FILENO + 1);
    char byte;
    [[maybe_unused]] const ssize_t closed = TEMP_FAILURE_RETRY(::read(STDIN_FILENO, &byte, 1));
    ::kill(0, SIGKILL);
    ::_exit(0);
  }

  /// By the program itself: what makes namespaces for it hands these descriptors on.
  int closed_by_exec() const noexcept { return launch.namespaces.empty() ? O_CLOEXEC : 0; }
};

constexpr rlim_t most_memory = rlim_t{4} << 30;  // a check needs some 100 MB; a scanner that runs wild stops here

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = TEMP_FAILURE_RETRY(::write(descriptor, bytes.data(), bytes.size()));
    if (put <= 0) ::_exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
}

/// The new process. It leaves by _exit: what the parent has begun to print, and its objects, are not its own.
[[noreturn]] void work_and_exit(const std::function<std::string(const ForkedJob::Send&)>& work, int result,
                                pid_t parent) {
  unblock_signals();
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // not SIGKILL: it has compilers of its own to end
  if (::getppid() != parent) ::_exit(1);
#if !defined(__SANITIZE_ADDRESS__)  // which reserves terabytes of addresses
  rlimit memory{};
  ::getrlimit(RLIMIT_AS, &memory);
  memory.rlim_cur = std::min(most_memory, memory.rlim_max);  // the soft limit: a sanitizer's process raises it again
  ::setrlimit(RLIMIT_AS, &memory);
#endif
  try {
    write_all(result, work([result](std::string_view bytes) { write_all(result, bytes); }));
  } catch (...) {  // whatever it is: this must not go on in the parent's code
    ::_exit(2);
  }
  ::_exit(0);
}

constexpr std::uint32_t change_users = (1U << CAP_SETUID) | (1U << CAP_SETGID), end_processes = 1U << CAP_KILL;

bool set_capabilities(std::uint32_t permitted, std::uint32_t effective) noexcept {
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  const __user_cap_data_struct data[2] = {{effective, permitted, 0}, {}};
  return ::syscall(SYS_capset, &header, data) == 0;
}

constexpr std::chrono::minutes longest_build{30};
constexpr std::size_t most_output = std::size_t{4} << 20;

Launch launch_of(const std::string& program, const std::vector<std::string>& arguments) {
  Launch launch;
  launch.program = program;
  launch.arguments = arguments;
  launch.environment = {"PATH=" + environment("PATH", "/usr/local/bin:/usr/bin:/bin")};
  return launch;
}

}  // namespace

LaunchError::LaunchError(const std::string& step, int system_error)
    : std::runtime_error(step + ": " + std::generic_category().message(system_error)) {}

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long>(left, 0, 3'600'000));
}

ChildProcess::ChildProcess(const Launch& launch)
    : in_namespaces_(!launch.namespaces.empty()), ends_others_(launch.ends_others), held_(launch.held) {
  const Ends input;  // closed at once: there is nothing to read
  Ends output, lifeline, report(true);
  std::optional<Ends> channel;
  if (launch.with_channel) channel.emplace(true);
  const bool is_open = launch.opened && *launch.opened;
  const std::shared_ptr<const Descriptor> program = is_open ? launch.opened : Program(launch.program).opened;
  if (launch.with_channel && !*program) throw LaunchError("start the program", errno);
  std::vector<std::string> command = launch.namespaces;
  command.push_back(launch.program);
  command.insert(command.end(), launch.arguments.begin(), launch.arguments.end());
  const std::vector<char*> arguments = pointers(command);
  const std::vector<char*> environment = pointers(launch.environment);
  const std::string directory = launch.directory.string();
  const int names_senders = 1;
  ::setsockopt(report.first.number(), SOL_SOCKET, SO_PASSCRED, &names_senders, sizeof names_senders);
  const timeval longest_silence{10, 0};
  ::setsockopt(report.first.number(), SOL_SOCKET, SO_RCVTIMEO, &longest_silence, sizeof longest_silence);
  NewProcess child{launch,
                   arguments.data(),
                   environment.data(),
                   directory.empty() ? nullptr : directory.c_str(),
                   ::getpid(),
                   input.first.number(),
                   output.second.number(),
                   lifeline.first.number(),
                   report.second.number(),
                   (channel ? channel->first : lifeline.first).number(),
                   launch.with_channel ? program->number() : -1};
  process_ = program_ = ::fork();
  if (process_ < 0) throw LaunchError("start a process", errno);
  if (process_ == 0) child.become_program();

  output_ = std::move(output.first);
  lifeline_ = std::move(lifeline.second);
  if (channel) channel_ = std::move(channel->second);
  reports_ = std::move(report.first);
  for (const Descriptor& ours : {std::cref(output_), std::cref(channel_)}) ::fcntl(ours.number(), F_SETFL, O_NONBLOCK);
  output.second.close();
  report.second.close();
  wait_for_start();
}

void ChildProcess::wait_for_start() {
  while (const std::optional<ProcessReport> report = receive_report()) {
    if (report->kind == ProcessReport::started) return;
    if (report->kind != ProcessReport::failed) continue;
    kill();
    throw LaunchError(report->step, report->number);
  }
  const int silence = errno;
  if (silence == 0 && !in_namespaces_) return;  // closed by exec: the program runs
  ::kill(-process_, SIGKILL);
  std::array<char, 500> said{};  // by what should make the namespaces
  const ssize_t size = in_namespaces_ ? ::read(output_.number(), said.data(), said.size()) : 0;
  kill();
  if (size <= 0) throw LaunchError("hear from the new process", silence == 0 ? EPIPE : silence);
  const std::string_view text(said.data(), static_cast<std::size_t>(size));
  throw LaunchError(printable(text.substr(0, text.find('\n'))));
}

/// The next report; nothing at their end, or with an errno.
std::optional<ProcessReport> ChildProcess::receive_report() {
  ProcessReport report;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(ucred))> control{};
  iovec bytes{&report, sizeof report};
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  const ssize_t got = TEMP_FAILURE_RETRY(::recvmsg(reports_.number(), &message, MSG_WAITALL | MSG_CMSG_CLOEXEC));
  if (got >= 0) errno = 0;
  if (got != sizeof report) return std::nullopt;
  report.step[sizeof report.step - 1] = '\0';
  const cmsghdr* const sender = CMSG_FIRSTHDR(&message);
  if (report.kind == ProcessReport::begun && sender && sender->cmsg_type == SCM_CREDENTIALS) {
    ucred credentials{};
    std::memcpy(&credentials, CMSG_DATA(sender), sizeof credentials);
    program_ = credentials.pid;
  }
  return report;
}

ChildProcess::~ChildProcess() { kill(); }

void ChildProcess::close_write() { ::shutdown(channel_.number(), SHUT_WR); }

bool ChildProcess::is_running() const {
  std::ifstream statistics("/proc/" + std::to_string(program_) + "/stat");
  std::string line;
  std::getline(statistics, line);
  const auto name_ends = line.rfind(") ");
  return name_ends != std::string::npos && !std::strchr("ZX", line.at(name_ends + 2));
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
  constexpr std::chrono::seconds patience{2};
  if (end_) return *end_;
  // The process above the program ends everything in its namespaces, and then itself.
  if (in_namespaces_ && program_ != process_ && ::shutdown(reports_.number(), SHUT_WR) == 0)
    if (const std::optional<ProcessEnd> end = wait_until(Clock::now() + patience)) return *end;
  ::kill(process_, SIGKILL);
  return reap();
}

ProcessEnd ChildProcess::reap() {
  // While the leader is not waited for, its number cannot name another group.
  if (!ends_others_) ::kill(-process_, SIGKILL);
  int status = SIGKILL;
  rusage usage{};
  const pid_t waited = TEMP_FAILURE_RETRY(::wait4(process_, &status, 0, &usage));
  double processor_seconds = seconds(usage);
  if (in_namespaces_) {
    status = SIGKILL;  // unless the process above the program still could tell
    while (const std::optional<ProcessReport> report = receive_report())
      if (report->kind == ProcessReport::ended) status = report->number, processor_seconds = report->processor_seconds;
  }
  ProcessEnd end;
  if (waited == process_) {
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.exit_status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.processor_seconds = processor_seconds;
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
  std::optional<ProcessEnd> end;
  if (!finished.out_of_time && !finished.too_much_output) {
    end = process.wait_until(deadline);
    finished.out_of_time = !end;
  }
  finished.end = end ? *end : process.kill();
  return finished;
}

FinishedProgram make(const Build& build, const std::vector<std::string>& targets) {
  const std::string program = "/usr/bin/env";
  std::vector<std::string> arguments = {"bash", build.setup.string(), "build/" + build.directory.filename().string()};
  arguments.insert(arguments.end(), targets.begin(), targets.end());
  Launch launch = launch_of(program, arguments);
  launch.ends_others = true;  // a compiler whose ninja is killed goes on
  // The script writes into a pipe; what went wrong is for the caller to say.
  const bool is_written_over = ::isatty(STDERR_FILENO) != 0 && !Console::of_standard_error().plain();
  launch.environment.emplace_back(is_written_over ? "WORKBOOK_PROGRESS=terminal" : "WORKBOOK_PROGRESS=lines");
  FinishedProgram finished = run_program(launch, longest_build, most_output, [](std::string_view piece) {
    fmt::print(stderr, "{}", piece);
    std::fflush(stderr);
  });
  if (!finished.succeeded()) finished.output = read_file(build.directory / "build.log").value_or(finished.output);
  return finished;
}

void exec_program(std::vector<std::string> program_and_arguments) {
  std::fflush(stdout);
  std::vector<char*> pointers;
  for (std::string& one : program_and_arguments) pointers.push_back(one.data());
  pointers.push_back(nullptr);
  ::execv(pointers.front(), pointers.data());
  throw std::runtime_error(fmt::format("{} cannot be started ({}).", pointers.front(), std::strerror(errno)));
}

FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit) {
  return run_program(launch_of(program, arguments), limit, most_output);
}

ForkedJob::ForkedJob(const std::function<std::string(const Send&)>& work, Clock::duration time_limit)
    : deadline_(begun_ + time_limit) {
  Ends pipe;
  bytes_ = std::move(pipe.first);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) throw LaunchError("start a process", errno);
  if (process_ == 0) work_and_exit(work, pipe.second.number(), parent);
  ::setpgid(process_, process_);  // Ctrl-C and Ctrl-Z are for the parent, which decides what becomes of its jobs
  ::fcntl(bytes_.number(), F_SETFL, O_NONBLOCK);
}

ForkedJob::~ForkedJob() { end(); }

bool ForkedJob::collect() {
  std::array<char, 65536> buffer;
  while (!closed_) {
    const ssize_t got = ::read(bytes_.number(), buffer.data(), buffer.size());
    if (got > 0) output_.append(buffer.data(), static_cast<std::size_t>(got));
    if (got == 0) closed_ = true;
    if (got < 0 && errno != EINTR) break;
  }
  return closed_ || Clock::now() >= deadline_;
}

std::string ForkedJob::finish() {
  while (!collect()) {
    pollfd watched{bytes_.number(), POLLIN, 0};
    ::poll(&watched, 1, milliseconds_until(deadline_));
  }
  if (!closed_) {
    end();
    return "it ran for too long";
  }
  int status = 0;
  TEMP_FAILURE_RETRY(::waitpid(process_, &status, 0));
  process_ = -1;
  if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  return WEXITSTATUS(status) == 0 ? "" : "it failed";
}

void ForkedJob::end() {
  if (process_ < 0) return;
  ::kill(process_, SIGTERM);
  const auto patience = Clock::now() + std::chrono::seconds(1);
  while (::waitpid(process_, nullptr, WNOHANG) == 0) {
    if (Clock::now() > patience) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process_ = -1;
}

bool become_user(uid_t user, bool starts_other_users) noexcept {
  int end_with_parent = 0;
  return ::prctl(PR_SET_KEEPCAPS, starts_other_users ? 1 : 0) == 0 &&
         ::prctl(PR_GET_PDEATHSIG, &end_with_parent) == 0 && ::setgroups(0, nullptr) == 0 &&
         ::setresgid(user, user, user) == 0 && ::setresuid(user, user, user) == 0 &&
         ::prctl(PR_SET_PDEATHSIG, end_with_parent) == 0 &&
         (!starts_other_users || set_capabilities(change_users | end_processes, end_processes));
}

const char* become_unique_user() noexcept {
  // Above all users that systems give out by themselves, and the number of a process stays below 2²².
  constexpr uid_t first = 2'000'000'000;
  if (::geteuid() == 0 || !set_capabilities(change_users, change_users)) return nullptr;
  const bool done = become_user(first + static_cast<uid_t>(::getpid())) && set_capabilities(0, 0);
  return done ? nullptr : "become a user of its own";
}

std::size_t usable_processors() {
  cpu_set_t usable;
  const bool is_known = ::sched_getaffinity(0, sizeof usable, &usable) == 0;
  return is_known ? static_cast<std::size_t>(CPU_COUNT(&usable)) : std::max(1U, std::thread::hardware_concurrency());
}

void wait_for_any(const std::vector<int>& descriptors) {
  std::vector<pollfd> watched;
  watched.reserve(descriptors.size());
  for (const int descriptor : descriptors) watched.push_back({descriptor, POLLIN, 0});
  ::poll(watched.data(), watched.size(), 1000);
}

}  // namespace workbook
