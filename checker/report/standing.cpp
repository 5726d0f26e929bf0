#include "checker/report/standing.hpp"

#include "checker/worker/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace workbook {

namespace {

namespace fs = std::filesystem;

/// As seen from where the student stands, if that folder still exists.
std::string nearby(const fs::path& file) {
  std::error_code problem;
  const fs::path nearer = fs::proximate(file, problem);
  return printable((problem ? file : nearer).string());
}

}  // namespace

std::size_t Standing::count_passed() const {
  return static_cast<std::size_t>(std::count(passed.begin(), passed.end(), true));
}

std::size_t Standing::count_passed(const std::string& lecture) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < exercises.size(); ++i) count += passed[i] && exercises[i].lecture() == lecture ? 1 : 0;
  return count;
}

const Exercise* Standing::next() const {
  for (std::size_t i = 0; i < exercises.size(); ++i) {
    if (!passed[i]) return &exercises[i];
  }
  return nullptr;
}

Standing standing_of(const Course& course, const Progress& progress) {
  Standing standing;
  standing.exercises = course.exercises();
  for (const Exercise& exercise : standing.exercises)
    standing.passed.push_back(progress.passed(exercise.name(), fingerprint(course.student_file(exercise))));
  return standing;
}

std::string introduction(const Course& course, const Exercise& exercise, const std::string& label,
                         const Console& console) {
  const fs::path notes = course.notes_page(exercise.lecture()).value_or(course.notes_file(*exercise.card));
  return fmt::format("{}: {}\n{}\n  file   {}\n  notes  {}\n", label, console.styled(exercise.name(), Style::strong),
                     console.wrapped(exercise.entry->task, 2), nearby(course.student_file(exercise)), nearby(notes));
}

}  // namespace workbook
