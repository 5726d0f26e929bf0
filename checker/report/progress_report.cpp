#include "checker/report/reports.hpp"

#include "checker/judging/judge.hpp"

#include <algorithm>

namespace workbook {

State state_of(const Course& course, const Progress& progress, const Exercise& exercise) {
  const std::string verdict = progress.verdict(exercise.name());
  if (verdict == "passed") {
    if (progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
      return {"✓", "passed", Style::good};
    return {"?", "changed since it passed", Style::warning};
  }
  if (verdict.empty() || verdict == "not_started") return {"·", "not started", Style::quiet};
  return {"✗", in_words(verdict), Style::bad};
}

std::string overview(const Course& course, const ProgressSummary& summary, const Console& console) {
  double points = 0, all_points = 0;
  for (std::size_t i = 0; i < summary.exercises.size(); ++i) {
    all_points += summary.exercises[i].entry->points;
    if (summary.passed[i]) points += summary.exercises[i].entry->points;
  }
  std::string text = console.wrapped(fmt::format("{} of {} exercises pass, {} of {} points.", summary.count_passed(),
                                                 summary.exercises.size(), points, all_points)) +
                     "\n\n";
  std::size_t name_width = 0;
  std::size_t title_width = 0;
  for (const Card& card : course.cards()) {
    name_width = std::max(name_width, display_width(card.lecture));
    title_width = std::max(title_width, display_width(card.title));
  }
  const std::size_t bar_width = std::clamp<std::size_t>(console.width() / 4, 8, 24);
  for (const Card& card : course.cards()) {
    const std::size_t total = card.exercises.size();
    const std::size_t passed = summary.count_passed(card.lecture);
    const std::string bar = console.plain() ? "" : console.bar(passed, total, bar_width) + "  ";
    const bool has_room = console.width() >= name_width + bar_width + 16 + title_width;
    const std::string count = fmt::format("{} of {}", passed, total);
    text += console.mark(passed == total ? "✓" : " ", Style::good) + padded(card.lecture, name_width) + "  " + bar +
            (has_room ? padded(count, 10) + console.styled(card.title, Style::quiet) : count) + "\n";
  }
  return text;
}

std::string exercise_list(const Course& course, const Progress& progress, const ProgressSummary& summary,
                          const Console& console) {
  std::size_t name_width = 0;
  for (const Exercise& exercise : course.exercises()) name_width = std::max(name_width, display_width(exercise.name()));
  const bool is_wide = console.width() >= name_width + 40;
  std::string text;
  for (const Card& card : course.cards()) {
    text += (text.empty() ? "" : "\n") + console.styled(card.lecture, Style::strong) + "\n";
    std::string place =
        fmt::format("{}: {} of {} are yours", card.title, summary.count_passed(card.lecture), card.exercises.size());
    if (!card.builds_on.empty()) place += fmt::format("; builds on {}", fmt::join(card.builds_on, ", "));
    text += console.wrapped(place, 2) + "\n";
    for (const CardExercise& entry : card.exercises) {
      const State state = state_of(course, progress, {&card, &entry});
      text += "  " + console.mark(state.mark, state.style) + padded(entry.name, is_wide ? name_width : 0) + "  " +
              console.styled(is_wide ? padded(state.words, 24) : state.words, state.style);
      std::string worth = entry.points == 1 ? "1 point" : fmt::format("{} points", entry.points);
      if (entry.is_problem()) worth += fmt::format(", problem, {} min", entry.minutes);
      if (is_wide) text += console.styled(worth, Style::quiet);
      text += "\n";
    }
  }
  return text;
}

std::string introduction(const Course& course, const Exercise& exercise, const Console& console) {
  const auto notes = course.notes_page(exercise.lecture()).value_or(course.notes_file(*exercise.card));
  return fmt::format("Next: {}\n{}\n  file   {}\n  notes  {}\n", console.styled(exercise.name(), Style::strong),
                     console.wrapped(exercise.entry->task, 2), shown_path(course.student_file(exercise)),
                     shown_path(notes));
}

}  // namespace workbook
