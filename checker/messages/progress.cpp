#include "checker/messages/progress.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string damaged_progress_set_aside(const std::string& aside) {
  return fmt::format(
      "Your progress file was damaged; it is set aside as {} and counting starts afresh. Your exercises are untouched.",
      aside);
}

std::string damaged_progress_stays(const std::string& file) {
  return fmt::format(
      "Your progress file {} is damaged and cannot be set aside; make its folder writable. Your exercises are "
      "untouched.",
      file);
}

std::string progress_not_saved(const std::string& file) {
  return fmt::format(
      "Your progress could not be saved in {}; make that folder writable. The verdict above holds all the same.", file);
}

}  // namespace workbook::messages
