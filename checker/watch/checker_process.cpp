#include "checker/watch/checker_process.hpp"

#include <fmt/format.h>

#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>

namespace workbook {

namespace {

constexpr std::size_t longest_output = std::size_t{1} << 20;

/// How long a command that was told to end may take for ending what it has started.
constexpr std::chrono::seconds shutdown_timeout{1};

/// Ours, with what the terminal would have told the command itself.
std::vector<std::string> environment_for(const Console& console) {
  std::vector<std::string> result;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (!text.starts_with("COLUMNS=") && !text.starts_with("CLICOLOR_FORCE=")) result.push_back(text);
  }
  result.push_back(fmt::format("COLUMNS={}", console.width()));
  if (console.color()) result.emplace_back("CLICOLOR_FORCE=1");
  if (console.plain()) result.emplace_back("WORKBOOK_PLAIN=1");
  return result;
}

std::unique_ptr<ChildProcess> start(const std::filesystem::path& course_file, const std::vector<std::string>& arguments,
                                    const Console& console) {
  Launch launch;
  launch.program = "/proc/self/exe";
  launch.arguments = {"--course", course_file.string()};
  launch.arguments.insert(launch.arguments.end(), arguments.begin(), arguments.end());
  launch.environment = environment_for(console);
  // If we are killed, it is told to end, not killed: so it can end its compiler.
  launch.prepare = []() -> std::optional<messages::LaunchStep> {
    if (::prctl(PR_SET_PDEATHSIG, SIGTERM) != 0) return messages::LaunchStep::tie_to_watch;
    return std::nullopt;
  };
  return std::make_unique<ChildProcess>(launch);
}

}  // namespace

CheckerProcess::CheckerProcess(const std::filesystem::path& course_file, const std::vector<std::string>& arguments,
                               const Console& console)
    : process_(start(course_file, arguments, console)) {}

CheckerProcess::~CheckerProcess() {
  process_->ask_to_end();
  process_->wait_until(Clock::now() + shutdown_timeout);  // else the process is killed with its object
}

bool CheckerProcess::collect() {
  std::array<char, 16384> buffer;
  for (;;) {
    const ssize_t got = ::read(process_->output(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return errno != EAGAIN && errno != EWOULDBLOCK;
    if (got == 0) return true;
    const auto size = static_cast<std::size_t>(got);
    if (output_.size() < longest_output) output_.append(buffer.data(), std::min(size, longest_output - output_.size()));
  }
}

ProcessEnd CheckerProcess::end() {
  const auto ended = process_->wait_until(Clock::now() + shutdown_timeout);
  return ended ? *ended : process_->kill();
}

}  // namespace workbook
