#include "checker/messages/resetting.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string version_is_kept(const std::string& file) { return fmt::format("Your version is kept as {}.", file); }

std::string is_at_the_beginning(const std::string& file) {
  return fmt::format("{} is as it was at the beginning.", file);
}

std::string not_reset_because_not_kept(const std::string& exercise, const std::string& file,
                                       const std::string& reason) {
  return fmt::format("{} was not reset, because your version could not be kept as {}: {}.", exercise, file, reason);
}

std::string not_reset_because_not_written(const std::string& exercise, const std::string& file) {
  return fmt::format("{} was not reset: {} cannot be written; make its folder writable.", exercise, file);
}

std::string not_reset(const std::string& exercise, const std::string& reason) {
  return fmt::format("{} was not reset: {}.", exercise, reason);
}

}  // namespace workbook::messages
