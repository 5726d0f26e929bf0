#include "checker/messages/handing_out.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string handout_needs_solutions() {
  return "This copy was handed out itself: it has no solutions, so no other copy can be made from it. Copy the folder.";
}

std::string handout_needs_a_new_folder(const std::string& directory) {
  return fmt::format("{} is there already; name a new or an empty folder, so that nothing in it is lost.", directory);
}

std::string handout_could_not_be_built() {
  return "Nothing was handed out, because the figures and numbers of the notes could not be made; mend what the lines "
         "above name.";
}

std::string cannot_write_handout(const std::string& directory, const std::string& reason) {
  return fmt::format("{} could not be written ({}); nothing was handed out. Name a folder in a place that is writable.",
                     directory, reason);
}

std::string handed_out(const std::string& directory, std::size_t lectures, std::size_t exercises) {
  return fmt::format(
      "{} holds {} lectures with {} exercises, and no solutions. Students type ./checker/run in it; put it into an "
      "archive or a repository of its own.",
      directory, lectures, exercises);
}

}  // namespace workbook::messages
