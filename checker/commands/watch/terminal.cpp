#include "checker/commands/watch/watch.hpp"

#include <signal.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <termios.h>

#include <cctype>
#include <cstdio>

namespace workbook {

namespace {

/// How the terminal was found; a signal handler reads it.
termios saved_termios{};

/// Out of the foreground, a change would stop the program, and the terminal is another's anyway.
bool is_in_foreground() noexcept { return ::tcgetpgrp(STDIN_FILENO) == ::getpgrp(); }

extern "C" void restore_terminal(int number) {
  if (is_in_foreground()) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &saved_termios);
    constexpr std::string_view show_cursor = "\033[?25h\n";
    [[maybe_unused]] const ssize_t ignored = ::write(STDOUT_FILENO, show_cursor.data(), show_cursor.size());
  }
  ::raise(number);  // the handler is gone by now
}

}  // namespace

std::vector<std::string> take_keys(std::string& typed) {
  constexpr char escape = '\033';
  std::vector<std::string> keys;
  while (!typed.empty()) {
    std::size_t length = 1;
    if (typed[0] == escape && typed.size() > 1 && typed[1] != escape) {
      length = typed[1] == '[' ? typed.find_first_not_of("0123456789:;<=>?", 2) + 1 : typed[1] == 'O' ? 3 : 2;
      if (length == 0 || length > typed.size()) break;
    } else {
      while (length < typed.size() && (static_cast<unsigned char>(typed[length]) & 0xC0) == 0x80) ++length;
    }
    keys.push_back(typed.substr(0, length));
    if (length == 1) keys.back()[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(typed[0])));
    typed.erase(0, length);
  }
  return keys;
}

Terminal::Terminal() : has_keyboard_(::isatty(STDIN_FILENO) != 0 && ::tcgetattr(STDIN_FILENO, &saved_termios) == 0) {
  std::setvbuf(stdout, nullptr, _IOFBF, 65536);  // a screen in one piece
  sigset_t handled;
  ::sigemptyset(&handled);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGWINCH, SIGTSTP, SIGCONT}) {
    struct sigaction action {};
    const bool is_ignored = ::sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
    if (!is_ignored) ::sigaddset(&handled, number);  // by nohup, for example
  }
  signals_ = Descriptor(::signalfd(-1, &handled, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!signals_) throw std::system_error(errno, std::generic_category(), "The watch cannot read signals");
  ::sigprocmask(SIG_BLOCK, &handled, nullptr);
  struct sigaction on_crash {};
  on_crash.sa_handler = restore_terminal;
  on_crash.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    if (has_keyboard_) ::sigaction(number, &on_crash, nullptr);
  take_keyboard();
}

Terminal::~Terminal() { give_keyboard_back(); }

bool Terminal::can_be_drawn_on() { return ::isatty(STDOUT_FILENO) != 0 && environment("TERM", "dumb") != "dumb"; }

TerminalSize Terminal::size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

bool Terminal::write(std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
}

std::string Terminal::read() {
  std::array<char, 256> buffer;
  const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  return {buffer.data(), got > 0 ? static_cast<std::size_t>(got) : 0};
}

std::vector<int> Terminal::take_signals() {
  std::vector<int> numbers;
  signalfd_siginfo info{};
  while (::read(signals_.number(), &info, sizeof info) == static_cast<ssize_t>(sizeof info))
    numbers.push_back(static_cast<int>(info.ssi_signo));
  return numbers;
}

void Terminal::stop() {
  give_keyboard_back();
  sigset_t stop;
  ::sigemptyset(&stop);
  ::sigaddset(&stop, SIGTSTP);
  ::raise(SIGTSTP);
  ::sigprocmask(SIG_UNBLOCK, &stop, nullptr);  // here it stops, unless nobody could continue it
  ::sigprocmask(SIG_BLOCK, &stop, nullptr);
  take_keyboard();
}

void Terminal::give_keyboard_back() const {
  if (has_keyboard_ && is_in_foreground()) ::tcsetattr(STDIN_FILENO, TCSANOW, &saved_termios);
}

void Terminal::take_keyboard() const {
  if (!has_keyboard_) return;
  termios key_by_key = saved_termios;
  key_by_key.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  key_by_key.c_cc[VMIN] = 1;
  key_by_key.c_cc[VTIME] = 0;
  // Started in the background, the program is stopped here until it is called to the front, as is usual.
  ::tcsetattr(STDIN_FILENO, TCSANOW, &key_by_key);
}

}  // namespace workbook
