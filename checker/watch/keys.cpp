#include "checker/watch/keys.hpp"

#include "checker/base/printable.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace workbook {

namespace {

constexpr char escape = '\033';

Action meaning_of_letter(char letter) {
  switch (letter) {
    case 'h':
      return Action::hint;
    case 'l':
      return Action::list;
    case 'p':
      return Action::plot;
    case 'n':
      return Action::next;
    case 'b':
      return Action::back;
    case 'c':
      return Action::compiler;
    case 'r':
      return Action::again;
    case 'q':
    case '\x03':  // Ctrl-C and Ctrl-D, where they arrive as letters
    case '\x04':
      return Action::quit;
    case 'j':
      return Action::down;
    case 'k':
      return Action::up;
    case ' ':
      return Action::page_down;
    default:
      return Action::unknown;
  }
}

/// Of a key without a letter, by what follows the escape.
Action meaning_of_sequence(std::string_view sequence) {
  if (sequence == "[A" || sequence == "OA") return Action::up;
  if (sequence == "[B" || sequence == "OB") return Action::down;
  if (sequence == "[5~") return Action::page_up;
  if (sequence == "[6~") return Action::page_down;
  return Action::unknown;
}

/// How many bytes after an escape belong to it; `complete` is false if more are to come.
std::size_t length_of_sequence(std::string_view after, bool& complete) {
  complete = true;
  if (after.empty() || after[0] == escape) return 0;  // the escape key alone
  if (after[0] == 'O') {
    complete = after.size() >= 2;
    return std::min<std::size_t>(after.size(), 2);
  }
  if (after[0] != '[') return 1;
  for (std::size_t i = 1; i < after.size(); ++i) {
    if (after[i] >= 0x40 && after[i] <= 0x7e) return i + 1;
  }
  complete = false;
  return after.size();
}

std::size_t length_of_letter(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && length < 4 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) ++length;
  return length;
}

}  // namespace

std::vector<Key> KeyReader::read(std::string_view bytes) {
  const std::string text = std::exchange(rest_, {}) + std::string(bytes);
  std::string_view left = text;
  std::vector<Key> keys;
  while (!left.empty()) {
    if (left[0] == escape) {
      bool complete = true;
      const std::size_t length = length_of_sequence(left.substr(1), complete);
      if (!complete && left.size() < 32) {
        rest_ = left;
        break;
      }
      keys.push_back({meaning_of_sequence(left.substr(1, length)), ""});
      left.remove_prefix(1 + length);
      continue;
    }
    const std::size_t length = length_of_letter(left);
    const bool visible = length > 1 || std::isprint(static_cast<unsigned char>(left[0])) != 0;
    const char letter = length > 1 ? '\0' : left[0];
    const auto small = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    keys.push_back({meaning_of_letter(small), visible ? printable(left.substr(0, length)) : ""});
    left.remove_prefix(length);
  }
  return keys;
}

}  // namespace workbook
