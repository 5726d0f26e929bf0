/// @file
/// The watch as a student has it: on a terminal of its own, driven by keys and saved files, read from the screen.
#pragma once

#include "tests/support/processes.hpp"

#include "tests/program/program.hpp"

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct VTerm;
struct VTermScreen;

namespace workbook::testing {

struct TerminalOptions {
  int columns = 80;
  int rows = 30;
  std::vector<std::string> environment = {};  ///< "NAME=value", added to an otherwise plain one
  std::function<void()> prepare = {};         ///< done in the new process before the checker starts
};

/// For `prepare`: the checker's input is empty and its output a pipe, from which the terminal is written.
void pipe_through_cat();

/// `checker watch ARGUMENTS` on a terminal. What still runs of it at the end of the test is killed.
class TerminalSession {
 public:
  using Milliseconds = std::chrono::milliseconds;

  explicit TerminalSession(const CourseCopy& course, const std::vector<std::string>& arguments = {},
                           const TerminalOptions& options = {});
  ~TerminalSession();
  TerminalSession(const TerminalSession&) = delete;
  TerminalSession& operator=(const TerminalSession&) = delete;

  /// Waits until the condition holds, or for so long, while the terminal shows what comes.
  bool until(const std::function<bool()>& condition, Milliseconds at_most = std::chrono::seconds(60));
  void wait(Milliseconds time) {
    until([] { return false; }, time);
  }

  /// Waits until the screen holds all the parts, or for so long.
  bool shows(const std::vector<std::string>& parts, Milliseconds at_most = std::chrono::seconds(60));

  /// Has the exercise this verdict, on the file as it is now?
  bool has_verdict(const std::string& exercise, const std::string& verdict) const;
  /// Waits until it has, and the screen shows it.
  bool judges(const std::string& exercise, const std::string& verdict, Milliseconds at_most = std::chrono::seconds(60));

  /// What is to be read on the screen now: its rows, without the spaces at their ends.
  std::string screen();
  /// Everything that was ever written to the terminal, with its control sequences.
  const std::string& written() const { return written_; }

  void type(const std::string& keys) const;
  void resize(int columns, int rows);
  void send(int signal) const;
  /// Sends a signal to the checks and plots that the watch has running. How many there are.
  std::size_t send_to_jobs(int signal) const;
  /// Closes the terminal, as a window is closed.
  void close();

  /// How it ended: its exit status, 128 and the number of a signal, or −1 if it runs on.
  int ends();

  /// Does the terminal wait for the return key and show what is typed, as a shell expects it?
  bool is_restored() const;
  bool shows_cursor();

 private:
  bool pump(Milliseconds time);

  const CourseCopy& course_;
  int terminal_ = -1;
  pid_t process_ = -1;
  int status_ = -1;
  std::unique_ptr<VTerm, void (*)(VTerm*)> emulator_;
  VTermScreen* screen_ = nullptr;
  int columns_;
  int rows_;
  std::string written_;
};

}  // namespace workbook::testing
