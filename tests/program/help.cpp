// The help, the completion and the ways to show text.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace workbook::testing;

namespace {

/// The commands that --help lists.
std::vector<std::string> commands_of(const std::string& help) {
  std::vector<std::string> commands;
  const std::regex entry("^  ([a-z][a-z-]+) +[A-Z]");
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (std::regex_search(line, found, entry)) commands.push_back(found[1]);
  }
  return commands;
}

std::size_t letters(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](unsigned char byte) { return (byte & 0xC0) != 0x80; }));
}

/// What bash would offer after these words; the last one is being typed.
std::string completed(const CourseCopy& course, const std::string& words) {
  write(course.root() / "completion.bash", course.run("completion").out);
  write(course.root() / "try.bash", ". ./completion.bash\nCOMP_WORDS=(" + words +
                                        ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_rigid_body_workbook\n"
                                        "printf '%s ' \"${COMPREPLY[@]}\" >completed\n");
  REQUIRE(std::system(("cd '" + course.root().string() + "' && bash try.bash").c_str()) == 0);
  return read(course.root() / "completed");
}

}  // namespace

TEST_CASE("every command has help with a description and fits 80 and 44 columns") {
  const CourseCopy course;
  const std::vector<std::string> commands = commands_of(course.run("--help").out);
  CHECK(commands.size() >= 10);
  for (const std::string& command : commands) {
    for (const std::size_t width : {std::size_t{80}, std::size_t{44}}) {
      CAPTURE(command);
      const Outcome outcome = course.run(command + " --help", "COLUMNS=" + std::to_string(width));
      CHECK(outcome.status == 0);
      CHECK(has(outcome.out, "Usage: checker " + command));
      std::istringstream lines(outcome.out);
      for (std::string line; std::getline(lines, line);) {
        const bool may_be_longer = line.starts_with("  checker ") || line.starts_with("Usage");
        CHECK_MESSAGE((may_be_longer || letters(line) <= width), line);
      }
    }
  }
}

TEST_CASE("the help of the program explains status, environment and files") {
  const CourseCopy course;
  const std::string help = course.run("--help").out;
  for (const char* part : {"Exit status:", "NO_COLOR", "WORKBOOK_PLAIN", ".workbook/progress.json", "For instructors"})
    CHECK_MESSAGE(has(help, part), part);
}

TEST_CASE("bash completes commands, options, exercises, lectures and files") {
  const CourseCopy course;
  CHECK(completed(course, "checker che") == "check ");
  CHECK(completed(course, "./checker/run hint spring_f") == "spring_force ");
  CHECK(completed(course, "checker examples 0") == "01_springs ");
  CHECK(completed(course, "checker check --se") == "--seed ");
  CHECK(completed(course, "checker check --file cou") == "course.json ");
  CHECK(completed(course, "checker check --seed s") == " ");
  for (const std::string& command : commands_of(course.run("--help").out))
    CHECK_MESSAGE(has(completed(course, "checker " + command), command), command);
}

TEST_CASE("the plain mode has words for marks and no drawings") {
  const CourseCopy course;
  course.answer_energy("return 0;");
  for (const char* command : {"check --plain", "--plain check", "list --plain", "--plain", "doctor --plain"}) {
    CAPTURE(std::string(command));
    const std::string out = course.run(command, "CLICOLOR_FORCE=1").out;
    for (const char* mark : {"✓", "✗", "·", "\033", "###", "..."}) CHECK_MESSAGE(!has(out, mark), out);
  }
  CHECK(has(course.run("check", "WORKBOOK_PLAIN=1").out, "spring_energy  wrong value"));
}

TEST_CASE("colour comes when it is asked for, and NO_COLOR wins") {
  const CourseCopy course;
  CHECK(!has(course.run("list").out, "\033["));
  CHECK(has(course.run("list", "CLICOLOR_FORCE=1").out, "\033["));
  CHECK(!has(course.run("list", "CLICOLOR_FORCE=1 NO_COLOR=1").out, "\033["));
}
