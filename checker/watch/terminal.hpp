/// @file
/// The terminal as the watch uses it: its size, its keys one by one, its cursor.
#pragma once

#include <cstddef>
#include <string_view>

namespace workbook {

struct TerminalSize {
  std::size_t columns = 80;
  std::size_t rows = 24;

  bool operator==(const TerminalSize&) const = default;
};

/// Of standard output; 80 by 24 where it does not say.
TerminalSize terminal_size();

/// Can standard output be drawn on? It is a terminal that understands more than letters.
bool can_be_drawn_on();

/// Writes all of it to standard output at once. False if nobody reads it any more.
bool write_out(std::string_view text);

/// While this lives, every key arrives at once and none is shown. The terminal gets its ordinary manners back at the
/// end of it, and also when a signal such as SIGSEGV ends the program. It does nothing if standard input is no
/// terminal.
class KeyByKey {
 public:
  KeyByKey();
  ~KeyByKey();
  KeyByKey(const KeyByKey&) = delete;
  KeyByKey& operator=(const KeyByKey&) = delete;

  bool has_keyboard() const { return has_keyboard_; }

  /// For the time that the program is stopped by Ctrl-Z, and after it.
  void give_back();
  void take();

 private:
  bool has_keyboard_ = false;
};

}  // namespace workbook
