#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/course/stub.hpp"
#include "checker/messages/resetting.hpp"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

namespace workbook {

namespace fs = std::filesystem;

namespace {

/// A name beside the progress file that is not taken yet.
fs::path place_to_keep(const Course& course, const std::string& name) {
  const fs::path folder = course.progress_file().parent_path() / "kept";
  for (int number = 1;; ++number) {
    fs::path place = folder / fmt::format("{}.{}.cpp", name, number);
    if (!fs::exists(place)) return place;
  }
}

}  // namespace

int reset(const Course& course, const std::string& name) {
  const Exercise exercise = course.find_exercise(name);
  const LectureReference lecture = course.reference(exercise.lecture(), 1);
  const std::string stub = stub_text(exercise.entry->task, exercise.card->contract, lecture.exercise(name).signature);
  const fs::path file = course.student_file(exercise);

  std::error_code problem;
  if (fs::exists(file, problem)) {
    const fs::path kept = place_to_keep(course, name);
    fs::create_directories(kept.parent_path(), problem);
    if (!fs::copy_file(file, kept, problem)) {
      fmt::print(stderr, "{}\n", messages::not_reset_because_not_kept(name, kept.string(), problem.message()));
      return checker_failed;
    }
    fmt::print("{}\n", messages::version_is_kept(kept.string()));
  }
  const fs::path fresh = file.string() + ".new";
  {
    std::ofstream out(fresh, std::ios::binary);
    out << stub;
    if (!out) {
      fmt::print(stderr, "{}\n", messages::not_reset_because_not_written(name, fresh.string()));
      return checker_failed;
    }
  }
  fs::rename(fresh, file, problem);
  if (problem) {
    fmt::print(stderr, "{}\n", messages::not_reset(name, problem.message()));
    fs::remove(fresh, problem);
    return checker_failed;
  }
  Progress progress(course.progress_file());
  progress.forget(name);
  fmt::print("{}\n", messages::is_at_the_beginning(file.string()));
  return all_passed;
}

}  // namespace workbook
