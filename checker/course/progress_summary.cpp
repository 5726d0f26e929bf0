#include "checker/course/progress_summary.hpp"

#include "checker/base/printable.hpp"
#include "checker/messages/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace workbook {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t label_width = 6;

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

State state_of(const Course& course, const Progress& progress, const Exercise& exercise) {
  const std::string verdict = progress.verdict(exercise.name());
  if (verdict == "passed") {
    if (progress.passed(exercise.name(), fingerprint(course.student_file(exercise))))
      return {"✓", messages::passed(), Style::good};
    return {"?", messages::changed_since_it_passed(), Style::warning};
  }
  if (verdict.empty() || verdict == "not_started") return {"·", messages::not_started(), Style::quiet};
  return {"✗", messages::verdict_in_words(verdict), Style::bad};
}

std::string overview(const Course& course, const Standing& standing, const Console& console) {
  double points = 0;
  double all_points = 0;
  for (std::size_t i = 0; i < standing.total(); ++i) {
    const double worth = standing.exercises[i].entry->points;
    all_points += worth;
    if (standing.passed[i]) points += worth;
  }
  std::string text =
      console.wrapped(messages::standing(standing.count_passed(), standing.total(), points, all_points)) + "\n\n";
  std::size_t name_width = 0;
  for (const Card& card : course.cards()) name_width = std::max(name_width, display_width(card.lecture));
  std::size_t title_width = 0;
  for (const Card& card : course.cards()) title_width = std::max(title_width, display_width(card.title));
  const std::size_t bar_width = std::clamp<std::size_t>(console.width() / 4, 8, 24);
  for (const Card& card : course.cards()) {
    const std::size_t total = card.exercises.size();
    const std::size_t passed = standing.count_passed(card.lecture);
    const bool is_complete = passed == total;
    std::string line = console.mark(is_complete ? "✓" : " ", Style::good) + padded(card.lecture, name_width) + "  ";
    if (!console.plain()) line += console.bar(passed, total, bar_width) + "  ";
    line += messages::of(passed, total);
    const std::size_t title_column = name_width + bar_width + 16;
    if (console.width() >= title_column + title_width) {
      const std::size_t taken = name_width + bar_width + 6 + display_width(messages::of(passed, total));
      line += std::string(title_column - std::min(title_column, taken), ' ') + console.styled(card.title, Style::quiet);
    }
    text += line + "\n";
  }
  return text;
}

std::string exercise_list(const Course& course, const Progress& progress, const Console& console) {
  std::size_t name_width = 0;
  for (const Exercise& exercise : course.exercises()) name_width = std::max(name_width, display_width(exercise.name()));
  const bool is_wide = console.width() >= name_width + 40;
  std::string text;
  for (const Card& card : course.cards()) {
    text += (text.empty() ? "" : "\n") + console.styled(card.lecture, Style::strong) + "\n";
    text += console.wrapped(card.title, 2) + "\n";
    for (const CardExercise& entry : card.exercises) {
      const State state = state_of(course, progress, {&card, &entry});
      std::string line =
          "  " + console.mark(state.mark, state.style) + padded(entry.name, is_wide ? name_width + 2 : 0);
      if (!is_wide) line += "  ";
      line += console.styled(is_wide ? padded(state.words, 24) : state.words, state.style);
      if (is_wide) line += console.styled(messages::points(entry.points), Style::quiet);
      text += line + "\n";
    }
  }
  return text;
}

std::string introduction(const Course& course, const Exercise& exercise, const std::string& label,
                         const Console& console) {
  const fs::path notes = course.notes_page(exercise.lecture()).value_or(course.notes_file(*exercise.card));
  return fmt::format("{}: {}\n{}\n  {} {}\n  {} {}\n", label, console.styled(exercise.name(), Style::strong),
                     console.wrapped(exercise.entry->task, 2), padded(messages::file_row(), label_width),
                     nearby(course.student_file(exercise)), padded(messages::notes_row(), label_width), nearby(notes));
}

}  // namespace workbook
