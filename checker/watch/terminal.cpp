#include "checker/watch/terminal.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace workbook {

namespace {

constexpr int crashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// The manners of the terminal before they were changed; a signal handler reads them.
termios ordinary_manners{};

void set_manners(const termios& manners) noexcept {
  // Out of the foreground, a change would stop the program, and the terminal is another's anyway.
  if (::tcgetpgrp(STDIN_FILENO) == ::getpgrp()) ::tcsetattr(STDIN_FILENO, TCSANOW, &manners);
}

extern "C" void put_terminal_right(int number) {
  set_manners(ordinary_manners);
  constexpr std::string_view show_cursor = "\033[?25h\n";
  if (::isatty(STDOUT_FILENO) != 0) {
    [[maybe_unused]] const ssize_t ignored = ::write(STDOUT_FILENO, show_cursor.data(), show_cursor.size());
  }
  ::raise(number);  // the handler is gone by now
}

void on_crash(void (*handler)(int)) {
  for (const int number : crashes) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    ::sigaction(number, &action, nullptr);
  }
}

}  // namespace

TerminalSize terminal_size() {
  winsize size{};
  TerminalSize result;
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) {
    if (size.ws_col > 0) result.columns = size.ws_col;
    if (size.ws_row > 0) result.rows = size.ws_row;
  }
  return result;
}

bool can_be_drawn_on() {
  const char* term = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) != 0 && term != nullptr && *term != '\0' && std::strcmp(term, "dumb") != 0;
}

bool write_out(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      pollfd ready{STDOUT_FILENO, POLLOUT, 0};
      ::poll(&ready, 1, 1000);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

KeyByKey::KeyByKey() : has_keyboard_(::isatty(STDIN_FILENO) != 0 && ::tcgetattr(STDIN_FILENO, &ordinary_manners) == 0) {
  if (!has_keyboard_) return;
  on_crash(put_terminal_right);
  take();
}

KeyByKey::~KeyByKey() {
  if (!has_keyboard_) return;
  give_back();
  on_crash(SIG_DFL);
}

void KeyByKey::give_back() {
  if (has_keyboard_) set_manners(ordinary_manners);
}

void KeyByKey::take() {
  if (!has_keyboard_) return;
  termios manners = ordinary_manners;
  manners.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  manners.c_cc[VMIN] = 1;
  manners.c_cc[VTIME] = 0;
  // Started in the background, the program is stopped here until it is called to the front, as is usual.
  ::tcsetattr(STDIN_FILENO, TCSANOW, &manners);
}

}  // namespace workbook
