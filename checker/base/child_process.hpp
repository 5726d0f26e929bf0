/// @file
/// What runs beside the checker and cannot outlive it: programs (the compiler, the worker, the build), and pieces of
/// its own work.
#pragma once

#include "checker/base/files.hpp"

#include <sys/resource.h>
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

namespace workbook {

using Clock = std::chrono::steady_clock;

/// What the new process finds after standard input, output and error.
inline constexpr int channel_descriptor = 3;  ///< the socket pair to talk over, or the read end of the lifeline
inline constexpr int report_descriptor = 4;   ///< where its ProcessReport goes; closed by exec
inline constexpr int program_descriptor = 5;  ///< with a channel: the program itself; closed by exec

/// What a new process says of itself before it becomes the program. In namespaces the process above it then goes on.
struct ProcessReport {
  enum Kind : int { begun, failed, started, ended } kind = failed;
  int number = 0;                  ///< failed: an errno; ended: the status as waitpid has it
  double processor_seconds = 0.0;  ///< ended
  char step[48] = "";              ///< failed
};

/// Processor time.
inline double seconds(const rusage& usage) {
  const auto microseconds = [](const timeval& time) {
    return 1e6 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec);
  };
  return 1e-6 * (microseconds(usage.ru_utime) + microseconds(usage.ru_stime));
}

struct LaunchError : std::runtime_error {
  /// @param step  that failed: "enter its directory". @param system_error  an errno
  LaunchError(const std::string& step, int system_error);
  using std::runtime_error::runtime_error;
};

struct Launch {
  std::string program;                   ///< path; nothing is searched, no shell is involved
  std::vector<std::string> arguments;    ///< without the program's own name
  std::vector<std::string> environment;  ///< "NAME=value"; nothing is inherited
  std::filesystem::path directory;       ///< where it starts; empty: where the checker stands
  bool ends_others = false;              ///< it ends what it has started, and is left the time to do so
  /// A socket pair to talk over. The program is then started by its descriptor and not by its path, so that a filter of
  /// system calls can let through exactly this one start.
  bool with_channel = false;
  std::shared_ptr<const Descriptor> opened;  ///< with a channel: the program, where it is open already
  /// Runs in the new process just before the program, and may only make system calls: between fork and exec nothing
  /// else is safe. Returns nullptr, or the step that failed (a literal), with the reason in errno.
  std::function<const char*()> prepare;
  /// Lives as long as the process.
  std::shared_ptr<const void> held;
  /// A command that makes namespaces, and in them starts what follows as the program: checker/sandbox/last_stage at its
  /// end. Empty: none.
  std::vector<std::string> namespaces;
};

struct ProcessEnd {
  int exit_status = 0;
  int signal = 0;  ///< 0 if the process ended by itself
  double processor_seconds = 0.0;
};

/// A running program with its own process group. Its standard input is empty; standard output and error arrive
/// together. Nothing of it is left when the object is gone, nor when the checker is killed. PR_SET_PDEATHSIG fires when
/// the creating thread ends: create it from a thread that outlives it.
class ChildProcess {
 public:
  /// @throws LaunchError
  explicit ChildProcess(const Launch& launch);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  pid_t number() const { return program_; }
  int output() const { return output_.number(); }    ///< does not block
  int channel() const { return channel_.number(); }  ///< does not block

  /// Closes our sending direction of the channel.
  void close_write();

  /// False as soon as the program has ended, even if what started it in its namespaces still clears up.
  bool is_running() const;

  /// How the process ended, or nothing if it still runs at that time.
  std::optional<ProcessEnd> wait_until(Clock::time_point deadline);

  /// Ends the process and all its children, if any are left.
  ProcessEnd kill();

 private:
  void wait_for_start();
  std::optional<ProcessReport> receive_report();
  ProcessEnd reap();

  pid_t process_ = -1;
  pid_t program_ = -1;  ///< the same, or in its namespaces
  bool in_namespaces_;
  Descriptor output_;
  Descriptor channel_;
  Descriptor lifeline_;
  Descriptor reports_;
  std::optional<ProcessEnd> end_;
  bool ends_others_;
  std::shared_ptr<const void> held_;
};

/// Milliseconds for poll, rounded up so that it does not spin at the end.
int milliseconds_until(Clock::time_point deadline);

/// A program that ran to its end, or to one of its limits.
struct FinishedProgram {
  ProcessEnd end;
  std::string output;
  bool out_of_time = false;
  bool too_much_output = false;

  /// It ended by itself, with exit status 0, within its limits.
  bool succeeded() const { return !out_of_time && !too_much_output && end.signal == 0 && end.exit_status == 0; }
};

/// Runs a program and collects what it prints; a listener hears of every piece as it comes. @throws LaunchError
FinishedProgram run_program(const Launch& launch, std::chrono::duration<double> time_limit, std::size_t output_limit,
                            const std::function<void(std::string_view)>& listener = {});

struct Build {
  std::filesystem::path setup;      ///< checker/setup.sh; empty where nothing can be built
  std::filesystem::path directory;  ///< build/PRESET
};

/// Makes targets, with a line of progress on standard error. Where that fails, the output is what the build said.
/// @throws LaunchError
FinishedProgram make(const Build& build, const std::vector<std::string>& targets);

/// Goes on as another program, on this terminal. @throws std::runtime_error if it cannot be started
[[noreturn]] void exec_program(std::vector<std::string> program_and_arguments);

/// Runs a program that finds others on PATH and inherits nothing else. @throws LaunchError
FinishedProgram run_with_path(const std::string& program, const std::vector<std::string>& arguments,
                              std::chrono::duration<double> limit);

/// The process is ended with this object. It dies with the thread that made it, and what it has started itself
/// dies with it (see ChildProcess). Make it while no other thread runs.
class ForkedJob {
 public:
  /// Hands over bytes while the work goes on.
  using Send = std::function<void(std::string_view)>;

  /// @param work  returns the last bytes; what it throws counts as a failure
  ForkedJob(const std::function<std::string(const Send&)>& work, Clock::duration time_limit);
  ForkedJob(const std::function<std::string()>& work, Clock::duration time_limit)
      : ForkedJob([&work](const Send&) { return work(); }, time_limit) {}
  ~ForkedJob();
  ForkedJob(const ForkedJob&) = delete;
  ForkedJob& operator=(const ForkedJob&) = delete;

  /// Becomes readable when there is something to collect.
  int descriptor() const { return bytes_.number(); }
  /// Takes what has come so far, without waiting. True once the job is over, or its time: then finish() does not wait.
  bool collect();
  /// Waits for the end. Returns "" if the job handed over its bytes, or what happened instead.
  std::string finish();

  const std::string& output() const { return output_; }
  Clock::time_point begun() const { return begun_; }

 private:
  void end();

  Clock::time_point begun_ = Clock::now();
  Clock::time_point deadline_;
  pid_t process_ = -1;
  Descriptor bytes_;
  std::string output_;
  bool closed_ = false;
};

/// Gives root up for good, for a user without rights. The life of a job stays tied to its parent, which Linux forgets
/// with the user. Returns false with the reason in errno.
/// @param starts_other_users  keeps the right to start processes as other users, and to end them
bool become_user(uid_t user, bool starts_other_users = false) noexcept;

/// In a new process, where the checker has kept that right: goes on without it, as a user that no other process has.
/// Returns nullptr, or the step that failed.
const char* become_unique_user() noexcept;

/// How many processors this process may use: all, or those that a batch system gave it.
std::size_t usable_processors();

/// Waits until one of these can be read, a second at most.
void wait_for_any(const std::vector<int>& descriptors);

struct DoNothing {
  void operator()(const auto&) const {}
};

/// Keeps one job more running than there are processors, for each waits now and then for others; collects each when it
/// is over.
/// @param begin    begin(k) starts the k-th job and returns a pointer that owns it
/// @param collect  collect(k, job); called in the order in which the jobs end
/// @param meanwhile  meanwhile(job); called about every second for one that is running
template <class Begin, class Collect, class Meanwhile = DoNothing>
void run_jobs(std::size_t count, const Begin& begin, const Collect& collect, const Meanwhile& meanwhile = {}) {
  const std::size_t at_once = usable_processors() + 1;
  std::vector<std::pair<std::size_t, decltype(begin(count))>> running;
  for (std::size_t next = 0; next < count || !running.empty();) {
    for (; next < count && running.size() < at_once; ++next) running.emplace_back(next, begin(next));
    std::vector<int> descriptors;
    descriptors.reserve(running.size());
    for (const auto& [unused, job] : running) descriptors.push_back(job->descriptor());
    wait_for_any(descriptors);
    std::erase_if(running, [&](const auto& each) {
      if (!each.second->collect()) return false;
      collect(each.first, *each.second);
      return true;
    });
    if (!running.empty()) meanwhile(*running.front().second);
  }
}

}  // namespace workbook
