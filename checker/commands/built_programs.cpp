#include "checker/commands/built_programs.hpp"

#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>

namespace workbook {

namespace fs = std::filesystem;

FinishedProgram build_target(const Course& course, const std::string& target) { return make(course.build(), {target}); }

std::string student_program(const Course& course, const std::string& target, const std::string& what) {
  const FinishedProgram built = build_target(course, target);
  if (built.succeeded()) return (course.build().directory / "lectures" / target).string();
  std::set<std::string> exercises;
  static const std::regex error(R"(lectures/\w+/exercises/(\w+)\.cpp:\d+:\d+: error)");
  for (std::sregex_iterator match(built.output.begin(), built.output.end(), error), end; match != end; ++match)
    exercises.insert((*match)[1]);
  if (exercises.empty()) throw std::runtime_error(fmt::format("{}\nThe {} could not be built.", built.output, what));
  fmt::print("The {} need files of yours that do not compile:\n", what);
  for (const std::string& exercise : exercises) fmt::print("  {}\n", command("check " + exercise));
  return "";
}

std::size_t copy_figures(const Course& course, const std::string& lecture, const fs::path& to) {
  const fs::path from = course.build().directory / "figures" / lecture;
  std::size_t count = 0;
  if (!fs::exists(from)) return count;
  fs::create_directories(to);
  for (const auto& picture : fs::directory_iterator(from)) {
    if (picture.path().filename() == "drawn") continue;  // the build's own mark
    fs::copy_file(picture.path(), to / picture.path().filename(), fs::copy_options::overwrite_existing);
    count += picture.path().extension() == ".svg" ? 1 : 0;
  }
  return count;
}

void print_outcome(const Console& console, const std::string& name, const Outcome& outcome) {
  const Style style = outcome.is_good() ? Style::good : outcome.is_not_started ? Style::quiet : Style::bad;
  const std::string mark = console.mark(outcome.is_good() ? "✓" : outcome.is_not_started ? "·" : "✗", style);
  const std::size_t indent = mark.empty() ? 0 : 2;
  const std::string text = outcome.is_good() ? name : name + ": " + outcome.trouble;
  fmt::print("{}{}\n", mark, console.wrapped(text, indent).substr(indent));
  std::fflush(stdout);
}

}  // namespace workbook
