#include "tests/watch/terminal_session.hpp"

#include "checker/base/files.hpp"

#include <fmt/format.h>
#include <vterm.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

namespace workbook::testing {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

}  // namespace

void pipe_through_cat() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) ::_exit(126);
  if (::fork() == 0) {
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[1]);
    ::execlp("cat", "cat", "-u", nullptr);
    ::_exit(127);
  }
  ::dup2(ends[1], STDOUT_FILENO);
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  ::close(ends[0]);
  ::close(ends[1]);
}

TerminalSession::TerminalSession(const CourseCopy& course, const std::vector<std::string>& arguments,
                                 const TerminalOptions& options)
    : course_(course),
      emulator_(vterm_new(options.rows, options.columns), vterm_free),
      columns_(options.columns),
      rows_(options.rows) {
  vterm_set_utf8(emulator_.get(), 1);
  screen_ = vterm_obtain_screen(emulator_.get());
  vterm_screen_reset(screen_, 1);

  const std::string environment =
      fmt::format("TERM=xterm-256color {}", fmt::join(options.environment, " "));  // of a name the last counts
  std::tie(process_, terminal_) = course.start_on_terminal(fmt::format("watch {}", fmt::join(arguments, " ")), columns_,
                                                           rows_, environment, options.prepare);
}

TerminalSession::~TerminalSession() {
  if (status_ < 0) ::kill(process_, SIGKILL);
  if (status_ < 0) ::waitpid(process_, nullptr, 0);
  close();
}

bool TerminalSession::pump(milliseconds time) {
  pollfd source{terminal_, POLLIN, 0};
  if (::poll(&source, 1, static_cast<int>(time.count())) <= 0) return false;
  std::array<char, 65536> buffer;
  const ssize_t got = ::read(terminal_, buffer.data(), buffer.size());
  if (got <= 0) {
    std::this_thread::sleep_for(std::min(time, milliseconds(5)));  // nobody writes to it any more
    return false;
  }
  written_.append(buffer.data(), static_cast<std::size_t>(got));
  vterm_input_write(emulator_.get(), buffer.data(), static_cast<std::size_t>(got));
  return true;
}

bool TerminalSession::until(const std::function<bool()>& condition, milliseconds at_most) {
  for (const auto end = Clock::now() + at_most; !condition();) {
    const auto left = std::chrono::ceil<milliseconds>(end - Clock::now());
    if (left <= milliseconds(0)) return false;
    pump(std::min(left, milliseconds(10)));
  }
  return true;
}

bool TerminalSession::shows(const std::vector<std::string>& parts, milliseconds at_most) {
  return until(
      [&] {
        const std::string now = screen();
        return std::ranges::all_of(parts, [&](const std::string& part) { return has(now, part); });
      },
      at_most);
}

bool TerminalSession::has_verdict(const std::string& exercise, const std::string& verdict) const {
  const std::string text = read(course_.root() / ".workbook/progress.json");
  const auto exercises = text.empty() ? nlohmann::json() : nlohmann::json::parse(text).at("exercises");
  return exercises.contains(exercise) && exercises[exercise].value("verdict", "") == verdict &&
         exercises[exercise].value("source", "") == file_fingerprint(course_.exercise(exercise));
}

bool TerminalSession::judges(const std::string& exercise, const std::string& verdict, milliseconds at_most) {
  const std::string mark = verdict == "passed" ? "✓ " : verdict == "not_started" ? "· " : "✗ ";
  return until([&] { return has_verdict(exercise, verdict) && has(screen(), mark + exercise); }, at_most);
}

std::string TerminalSession::screen() {
  while (pump(milliseconds(0))) {
  }
  std::string text;
  std::vector<char> buffer(static_cast<std::size_t>(columns_) * 8 + 1);
  for (int row = 0; row < rows_; ++row) {
    const std::size_t length =
        vterm_screen_get_text(screen_, buffer.data(), buffer.size() - 1, VTermRect{row, row + 1, 0, columns_});
    const std::string line(buffer.data(), std::min(length, buffer.size() - 1));
    text += line.substr(0, line.find_last_not_of(std::string(" \n\0", 3)) + 1) + '\n';
  }
  return text;
}

void TerminalSession::type(const std::string& keys) const {
  if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("the terminal takes no keys");
}

void TerminalSession::resize(int columns, int rows) {
  columns_ = columns;
  rows_ = rows;
  vterm_set_size(emulator_.get(), rows, columns);
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  ::ioctl(terminal_, TIOCSWINSZ, &size);
}

void TerminalSession::send(int signal) const { ::kill(process_, signal); }

std::size_t TerminalSession::send_to_jobs(int signal) const {
  std::istringstream children(read(fmt::format("/proc/{0}/task/{0}/children", process_)));
  std::size_t count = 0;
  for (pid_t child = 0; children >> child; ++count) ::kill(child, signal);
  return count;
}

void TerminalSession::close() {
  if (terminal_ >= 0) ::close(std::exchange(terminal_, -1));
}

int TerminalSession::ends() {
  const auto has_ended = [&] {
    int status = 0;
    if (status_ < 0 && ::waitpid(process_, &status, WNOHANG) == process_)
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_ >= 0;
  };
  until(has_ended);
  return status_;
}

bool TerminalSession::is_restored() const {
  termios now{};
  return ::tcgetattr(terminal_, &now) == 0 && (now.c_lflag & ICANON) != 0 && (now.c_lflag & ECHO) != 0;
}

bool TerminalSession::shows_cursor() {
  screen();
  const std::size_t hidden = written_.rfind("\033[?25l");
  const std::size_t shown = written_.rfind("\033[?25h");
  return hidden == std::string::npos || (shown != std::string::npos && shown > hidden);
}

}  // namespace workbook::testing
