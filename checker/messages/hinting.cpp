#include "checker/messages/hinting.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string hint_heading(std::size_t number, std::size_t total) { return fmt::format("Hint {} of {}", number, total); }

std::string hint_goes_on() { return "Ask again for the next one."; }

std::string hint_was_the_last(const std::string& notes, const std::string& anchor) {
  return fmt::format("That was the last hint. The paragraph of the notes: {}, {}.", notes, anchor);
}

}  // namespace workbook::messages
