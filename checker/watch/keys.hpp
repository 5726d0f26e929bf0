/// @file
/// What the keys of the watch mean.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

enum class Action { hint, list, plot, next, back, compiler, again, quit, down, up, page_down, page_up, unknown };

/// A key that was pressed.
struct Key {
  Action action = Action::unknown;
  std::string name;  ///< what was typed, as it can be shown; "" for a key without a letter

  bool operator==(const Key&) const = default;
};

/// Turns what a terminal sends into keys. A sequence that is cut in the middle is kept for the next call.
class KeyReader {
 public:
  std::vector<Key> read(std::string_view bytes);

 private:
  std::string rest_;
};

}  // namespace workbook
