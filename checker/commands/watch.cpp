#include "checker/watch/watch.hpp"

#include "checker/commands/commands.hpp"
#include "checker/messages/watching.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <system_error>

namespace workbook {

int watch(const Course& course, const std::filesystem::path& course_file, const std::string& name) {
  WatchedPart part{course.choose(name.empty() ? std::vector<std::string>{} : std::vector<std::string>{name}), ""};
  if (part.exercises.empty()) {
    fmt::print(stderr, "{}\n", messages::nothing_to_watch());
    return checker_failed;
  }
  const bool one_exercise = part.exercises.front().name() == name;
  if (!name.empty() && !one_exercise) part.name = part.exercises.front().lecture();
  Watch(course, std::filesystem::absolute(course_file), part).run();
  return all_passed;
}

}  // namespace workbook
