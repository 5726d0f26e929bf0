#include "checker/commands/built_programs.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/stub.hpp"
#include "checker/messages/handing_out.hpp"
#include "checker/messages/machine.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <string_view>
#include <system_error>

namespace workbook {

namespace fs = std::filesystem;

namespace {

/// What students get, relative to the top level. What is not named here stays at home: the solutions first of all.
constexpr std::array handed_out = {
    ".clang-format",        ".clangd",   ".devcontainer", ".github",       ".gitignore", "CMakeLists.txt",
    "CMakePresets.json",    "LICENSE",   "README.md",     "checker",       "include",    "lectures",
    "tests/CMakeLists.txt", "tests/run", "tests/judging", "tests/running", "tests/setup"};

/// The copy could not be made; one sentence.
struct HandoutError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool is_left_behind(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with('.') || name.ends_with('~') || name.ends_with(".orig");
}

void place_file(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy_file(from, to, fs::copy_options::overwrite_existing);
}

/// Copies a file, or a folder without dot-files and editors' backups.
void copy_part(const fs::path& from, const fs::path& to) {
  if (!fs::is_directory(from)) return place_file(from, to);
  for (auto entry = fs::recursive_directory_iterator(from); entry != fs::recursive_directory_iterator(); ++entry) {
    if (is_left_behind(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      place_file(entry->path(), to / entry->path().lexically_relative(from));
    }
  }
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw HandoutError(messages::cannot_write_handout(file.string(), messages::disk_may_be_full()));
}

/// Every exercise as it was at the beginning, whatever has been tried in this copy.
void write_stubs(const Course& course, const fs::path& copy) {
  for (const Card& card : course.cards()) {
    const LectureReference reference = course.reference(card.lecture, 1);
    const fs::path exercises = copy / "lectures" / card.lecture / "exercises";
    fs::remove_all(exercises);
    fs::create_directories(exercises);
    for (const CardExercise& entry : card.exercises) {
      const Exercise exercise{&card, &entry};
      place_file(course.hints_file(exercise), exercises / course.hints_file(exercise).filename());
      write_file(exercises / (entry.name + ".cpp"),
                 stub_text(entry.task, card.contract, reference.exercise(entry.name).signature));
    }
  }
}

/// What the reference implementation made: the results to judge by, the numbers and figures of the notes.
void copy_made(const Course& course, const fs::path& copy) {
  for (const Card& card : course.cards()) {
    const fs::path data = copy / "lectures" / card.lecture / "handed_out";
    place_file(course.reference_file(card.lecture), data / "reference.json");
    place_file(course.build() / "printed" / (card.lecture + ".txt"), data / "printed.txt");
    fs::create_directories(data / "figures");
    // "drawn" is the build's own mark.
    for (const auto& figure : fs::directory_iterator(course.build() / "figures" / card.lecture)) {
      if (figure.path().filename() != "drawn") place_file(figure.path(), data / "figures" / figure.path().filename());
    }
  }
}

void make_copy(const Course& course, const fs::path& copy) {
  for (const char* part : handed_out) {
    if (fs::exists(course.root() / part)) copy_part(course.root() / part, copy / part);
  }
  write_stubs(course, copy);
  copy_made(course, copy);
}

}  // namespace

int handout(const Course& course, const fs::path& directory) {
  if (!course.has_solutions()) {
    fmt::print(stderr, "{}\n", messages::handout_needs_solutions());
    return wrong_usage;
  }
  std::error_code problem;
  const fs::file_status there = fs::status(directory, problem);
  if (fs::exists(there) && !(fs::is_directory(there) && fs::is_empty(directory, problem))) {
    fmt::print(stderr, "{}\n", messages::handout_needs_a_new_folder(directory.string()));
    return wrong_usage;
  }
  const FinishedProgram built = build_target(course, "handed_out");
  if (!built.succeeded()) {
    fmt::print(stderr, "{}\n{}\n", built.output, messages::handout_could_not_be_built());
    return checker_failed;
  }
  // Under another name first, so that there is a whole copy or none.
  const fs::path target = fs::absolute(directory).lexically_normal();
  const fs::path whole = target.has_filename() ? target : target.parent_path();
  const fs::path unfinished = fmt::format("{}.unfinished-{}", whole.string(), getpid());
  try {
    make_copy(course, unfinished);
    if (fs::exists(whole)) fs::remove(whole);
    fs::rename(unfinished, whole);
  } catch (const std::exception& reason) {
    fs::remove_all(unfinished, problem);
    fmt::print(stderr, "{}\n", messages::cannot_write_handout(directory.string(), reason.what()));
    return checker_failed;
  }
  fmt::print("{}\n", messages::handed_out(directory.string(), course.cards().size(), course.exercises().size()));
  return all_passed;
}

}  // namespace workbook
