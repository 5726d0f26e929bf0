#include "tests/watch/watched.hpp"

#include <fmt/format.h>
#include <vterm.h>

#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace workbook::testing {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Orphans become children of the test, where waitpid sees them.
const int adopts_orphans = ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  result.reserve(texts.size() + 1);
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

}  // namespace

WatchedTerminal::WatchedTerminal(const CourseCopy& course, const std::vector<std::string>& arguments,
                                 const TerminalOptions& options)
    : emulator_(vterm_new(options.rows, options.columns), vterm_free), columns_(options.columns), rows_(options.rows) {
  vterm_set_utf8(emulator_.get(), 1);
  screen_ = vterm_obtain_screen(emulator_.get());
  vterm_screen_reset(screen_, 1);

  std::vector<std::string> words = {WORKBOOK_TEST_CHECKER, "--course", (course.root() / "course.json").string(),
                                    "watch"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const char* path = std::getenv("PATH");
  std::vector<std::string> environment = options.environment;
  environment.push_back(std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path));
  environment.push_back("TERM=xterm-256color");  // unless the options say otherwise, before it
  const std::vector<char*> argument_pointers = pointers(words);
  const std::vector<char*> environment_pointers = pointers(environment);
  const std::string directory = course.root().string();

  winsize size{};
  size.ws_col = static_cast<unsigned short>(options.columns);
  size.ws_row = static_cast<unsigned short>(options.rows);
  process_ = ::forkpty(&terminal_, nullptr, nullptr, &size);
  if (process_ < 0) throw std::runtime_error("no terminal for the test");
  if (process_ == 0) {
    if (options.prepare) options.prepare();
    if (::chdir(directory.c_str()) == 0)
      ::execve(argument_pointers[0], argument_pointers.data(), environment_pointers.data());
    ::_exit(127);
  }
}

WatchedTerminal::~WatchedTerminal() {
  if (status_ < 0) ::kill(process_, SIGKILL);
  if (status_ < 0) ::waitpid(process_, nullptr, 0);
  if (terminal_ >= 0) ::close(terminal_);
}

bool WatchedTerminal::pump(milliseconds time) {
  if (terminal_ < 0) {
    std::this_thread::sleep_for(time);
    return false;
  }
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

void WatchedTerminal::wait(milliseconds time) {
  const auto end = Clock::now() + time;
  for (auto now = Clock::now(); now < end; now = Clock::now()) pump(std::chrono::ceil<milliseconds>(end - now));
}

bool WatchedTerminal::until(const std::function<bool()>& condition, milliseconds at_most) {
  const auto end = Clock::now() + at_most;
  while (!condition()) {
    if (Clock::now() >= end) return false;
    pump(milliseconds(10));
  }
  return true;
}

bool WatchedTerminal::shows(const std::vector<std::string>& parts, milliseconds at_most) {
  return until(
      [&] {
        const std::string now = screen();
        for (const std::string& part : parts) {
          if (!has(now, part)) return false;
        }
        return true;
      },
      at_most);
}

std::string WatchedTerminal::screen() {
  while (pump(milliseconds(0))) {
  }
  std::string text;
  std::vector<char> buffer(static_cast<std::size_t>(columns_) * 8 + 1);
  for (int row = 0; row < rows_; ++row) {
    const std::size_t length =
        vterm_screen_get_text(screen_, buffer.data(), buffer.size() - 1, VTermRect{row, row + 1, 0, columns_});
    std::string line(buffer.data(), std::min(length, buffer.size() - 1));
    while (!line.empty() && (line.back() == ' ' || line.back() == '\n' || line.back() == '\0')) line.pop_back();
    text += line + '\n';
  }
  return text;
}

void WatchedTerminal::type(const std::string& keys) {
  if (::write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size()))
    throw std::runtime_error("the terminal takes no keys");
}

void WatchedTerminal::resize(int columns, int rows) {
  columns_ = columns;
  rows_ = rows;
  vterm_set_size(emulator_.get(), rows, columns);
  winsize size{};
  size.ws_col = static_cast<unsigned short>(columns);
  size.ws_row = static_cast<unsigned short>(rows);
  ::ioctl(terminal_, TIOCSWINSZ, &size);
}

void WatchedTerminal::send(int signal) const { ::kill(process_, signal); }

std::size_t WatchedTerminal::send_to_commands(int signal) const {
  std::istringstream children(read(fmt::format("/proc/{0}/task/{0}/children", process_)));
  std::size_t count = 0;
  for (pid_t child = 0; children >> child; ++count) ::kill(child, signal);
  return count;
}

void WatchedTerminal::close() { ::close(std::exchange(terminal_, -1)); }

int WatchedTerminal::ends(milliseconds at_most) {
  until(
      [&] {
        int status = 0;
        if (status_ < 0 && ::waitpid(process_, &status, WNOHANG) == process_)
          status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return status_ >= 0;
      },
      at_most);
  return status_;
}

bool WatchedTerminal::has_ordinary_manners() const {
  termios manners{};
  return ::tcgetattr(terminal_, &manners) == 0 && (manners.c_lflag & ICANON) != 0 && (manners.c_lflag & ECHO) != 0;
}

bool WatchedTerminal::shows_cursor() {
  screen();
  const std::size_t shown = written_.rfind("\033[?25h");
  const std::size_t hidden = written_.rfind("\033[?25l");
  return hidden == std::string::npos || (shown != std::string::npos && shown > hidden);
}

bool nothing_left_running() {
  if (adopts_orphans != 0) return false;
  for (int tries = 0; tries < 300; ++tries) {
    const pid_t ended = ::waitpid(-1, nullptr, WNOHANG);
    if (ended == -1) return errno == ECHILD;
    if (ended == 0) std::this_thread::sleep_for(milliseconds(5));
  }
  return false;
}

}  // namespace workbook::testing
