#include "tests/program/terminal.hpp"

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <cstdlib>
#include <stdexcept>

namespace workbook::testing {

namespace {

constexpr unsigned patience = 120;  // seconds

[[noreturn]] void become_checker(const CourseCopy& course, const std::vector<std::string>& arguments,
                                 const std::vector<std::string>& environment) {
  alarm(patience);  // survives exec: a checker that hangs ends the test
  std::vector<std::string> words = {WORKBOOK_TEST_CHECKER, "--course", (course.root() / "course.json").string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const char* path = std::getenv("PATH");
  std::vector<std::string> variables = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path)};
  variables.insert(variables.end(), environment.begin(), environment.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::vector<char*> envp;
  for (std::string& variable : variables) envp.push_back(variable.data());
  envp.push_back(nullptr);
  if (chdir(course.root().c_str()) == 0) execve(argv[0], argv.data(), envp.data());
  _exit(127);
}

}  // namespace

TerminalOutcome run_on_terminal(const CourseCopy& course, const std::vector<std::string>& arguments,
                                const TerminalWindow& window, const std::vector<std::string>& environment) {
  winsize size{};
  size.ws_col = static_cast<unsigned short>(window.columns);
  size.ws_row = static_cast<unsigned short>(window.rows);
  int ours = -1;
  int theirs = -1;
  if (openpty(&ours, &theirs, nullptr, nullptr, &size) != 0) throw std::runtime_error("no pseudo terminal");
  const auto say = [&](const std::string& text) {
    if (::write(ours, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      throw std::runtime_error("the pseudo terminal takes no input");
  };
  if (!window.typed_ahead.empty()) say(window.typed_ahead);
  const pid_t child = fork();
  if (child == 0) {
    close(ours);
    if (login_tty(dup(theirs)) != 0) _exit(126);
    become_checker(course, arguments, environment);
  }
  TerminalOutcome outcome;
  fcntl(ours, F_SETFL, O_NONBLOCK);
  int status = 0;
  for (bool ended = false; !ended;) {
    ended = waitpid(child, &status, WNOHANG) != 0;
    char buffer[65536];
    for (ssize_t count = 0; (count = ::read(ours, buffer, sizeof buffer)) > 0;)
      outcome.shown.append(buffer, static_cast<std::size_t>(count));
    if (!outcome.was_asked && outcome.shown.find("\033[c") != std::string::npos) {
      outcome.was_asked = true;
      say(window.answer);
    }
    usleep(5000);
  }
  termios after{};
  outcome.echoes_afterwards =
      tcgetattr(theirs, &after) == 0 && (after.c_lflag & ECHO) != 0 && (after.c_lflag & ICANON) != 0;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  close(ours);
  close(theirs);
  return outcome;
}

}  // namespace workbook::testing
