/// @file
/// The terminal as the watch uses it: its size, its keys one by one, its cursor, and its signals.
#pragma once

#include "checker/base/files.hpp"

#include <string>
#include <vector>

namespace workbook {

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// The keys at the front of what was typed, which are taken from it: small letters, and a whole escape sequence as one
/// key, so that no part of it is taken for a letter. What is cut in the middle stays for the next call.
std::vector<std::string> take_keys(std::string& typed);

/// While this lives, every key arrives at once and none is shown. The terminal is as before at the end of it, and also
/// when a signal such as SIGSEGV ends the program. From its making to the end of the program, the signals that end,
/// stop, continue or resize a program on a terminal are read, not delivered.
class Terminal {
 public:
  /// @throws std::system_error
  Terminal();
  ~Terminal();

  bool has_keyboard() const { return has_keyboard_; }

  /// Standard output is a terminal that understands more than letters.
  static bool can_be_drawn_on();
  /// Of standard output; 80 by 24 where it does not say.
  static TerminalSize size();

  /// Writes all of it to standard output at once. False if nobody reads it any more.
  static bool write(std::string_view text);

  /// What was typed, as it comes; "" at the end of the terminal.
  static std::string read();

  /// Becomes readable when a signal has come.
  int signals() const { return signals_.number(); }
  std::vector<int> take_signals();

  /// Does what Ctrl-Z usually does; returns when the program is continued.
  void stop();
  /// Every key at once, again: a shell that continues a program may have changed that.
  void take_keyboard() const;

 private:
  void give_keyboard_back() const;

  bool has_keyboard_;
  Descriptor signals_;
};

}  // namespace workbook
