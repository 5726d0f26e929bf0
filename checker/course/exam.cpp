#include "checker/course/exam.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <random>

namespace workbook {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Exam, started, minutes, seed, problems)

std::chrono::seconds Exam::time_left() const {
  return std::chrono::minutes(minutes) - std::chrono::seconds(std::time(nullptr) - started);
}

fs::path exam_file(const Course& course) { return course.progress_file().parent_path() / "exam.json"; }

std::optional<Exam> running_exam(const Course& course) {
  const std::optional<std::string> text = read_file(exam_file(course));
  if (!text) return std::nullopt;
  try {
    return nlohmann::json::parse(*text).get<Exam>();
  } catch (const nlohmann::json::exception&) {
    throw UsageError(fmt::format("{} is damaged, so the exam cannot go on; remove it and begin another one.",
                                 shown_path(exam_file(course))));
  }
}

std::vector<Exercise> drawn_problems(const Course& course, const Progress& progress, const std::string& lectures,
                                     std::uint64_t seed) {
  constexpr std::size_t most = 6;
  const std::size_t dash = lectures.find('-');
  if (dash == 0 || dash + 1 == lectures.size())
    throw UsageError(fmt::format("'{}' lacks a lecture; a range is written as in `{}`.", printable(lectures),
                                 command("exam 01-03")));
  const Card& first = course.find_lecture(lectures.substr(0, dash));
  const Card& last = dash == std::string::npos ? first : course.find_lecture(lectures.substr(dash + 1));
  if (last.lecture < first.lecture)
    throw UsageError(fmt::format("'{}' is no range of lectures; the earlier one comes first, as in `{}`.",
                                 printable(lectures), command("exam 01-03")));
  std::vector<Exercise> drawn;
  std::ranges::copy_if(course.exercises(), std::back_inserter(drawn), [&](const Exercise& exercise) {
    const Practice known = progress.of(exercise.name());
    const bool is_seen = known.hints_shown > 0 || (!known.verdict.empty() && known.verdict != "not_started") ||
                         is_begun(course.student_file(exercise));
    return exercise.entry->is_problem() && !is_seen && first.lecture <= exercise.lecture() &&
           exercise.lecture() <= last.lecture;
  });
  if (drawn.empty())
    throw UsageError(
        fmt::format("There is no problem in '{}' that you have not seen; name other lectures.", printable(lectures)));
  // The standard's distributions and shuffles differ between libraries.
  std::mt19937_64 random(seed);
  for (std::size_t i = drawn.size() - 1; i > 0; --i) std::swap(drawn[i], drawn[random() % (i + 1)]);
  drawn.resize(std::min(drawn.size(), most));
  const std::vector<Exercise> all = course.exercises();
  std::ranges::sort(drawn, {},
                    [&](const Exercise& one) { return std::ranges::find(all, one.entry, &Exercise::entry); });
  return drawn;
}

void write_exam(const Course& course, const Exam& exam) {
  write_or_throw(exam_file(course), nlohmann::json(exam).dump(2) + "\n");
}

void refuse_in_exam(const Course& course, const std::vector<Exercise>& exercises) {
  const std::optional<Exam> exam = running_exam(course);
  if (!exam) return;
  for (const Exercise& exercise : exercises)
    if (std::ranges::count(exam->problems, exercise.name()) > 0)
      throw UsageError(fmt::format("{} is a problem of the exam that is running: no help until `{}` has graded it.",
                                   exercise.name(), command("exam --finish")));
}

std::string time_text(const Exam& exam) {
  const std::string time = hours_and_minutes(exam.time_left());
  return exam.time_left().count() >= 0 ? time + " left" : "over time by " + time;
}

std::string hours_and_minutes(std::chrono::seconds time) {
  const long minutes = (std::abs(time.count()) + 30) / 60;
  if (minutes >= 60 && minutes % 60 == 0) return fmt::format("{} h", minutes / 60);
  return minutes < 60 ? fmt::format("{} min", minutes) : fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace workbook
