#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/report/console.hpp"
#include "checker/report/standing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace {

struct State {
  std::string mark;
  std::string words;
  Style style;
};

State state_of(const Course& course, const Progress& progress, const Exercise& exercise) {
  const std::string verdict = progress.verdict(exercise.name());
  if (verdict == "passed") {
    if (progress.passed(exercise.name(), fingerprint(course.student_file(exercise))))
      return {"✓", "passed", Style::good};
    return {"?", "changed since it passed", Style::warning};
  }
  if (verdict.empty() || verdict == "not_started") return {"·", "not started", Style::quiet};
  std::string words = verdict;
  std::replace(words.begin(), words.end(), '_', ' ');
  return {"✗", words, Style::bad};
}

void print_warning(const Progress& progress) {
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
}

}  // namespace

int list(const Course& course) {
  const Console console = Console::of_standard_output();
  const Progress progress(course.progress_file());
  for (const Card& card : course.cards()) {
    fmt::print("{}  {}\n", console.styled(card.lecture, Style::strong), card.title);
    for (const CardExercise& entry : card.exercises) {
      const State state = state_of(course, progress, {&card, &entry});
      fmt::print("  {}{} {}\n", console.mark(state.mark, state.style), padded(entry.name, 30),
                 console.styled(state.words, state.style));
    }
    fmt::print("\n");
  }
  print_warning(progress);
  return all_passed;
}

int status(const Course& course) {
  const Console console = Console::of_standard_output();
  const Progress progress(course.progress_file());
  const Standing standing = standing_of(course, progress);
  const std::size_t width = std::clamp<std::size_t>(console.width() / 4, 8, 24);
  for (const Card& card : course.cards()) {
    const std::size_t total = card.exercises.size();
    const std::size_t passed = standing.count_passed(card.lecture);
    fmt::print("{} {} {:>2} of {:<2}  {}\n", padded(card.lecture, 22), console.bar(passed, total, width), passed, total,
               console.width() >= 90 ? card.title : "");
  }
  fmt::print("\n");
  if (const Exercise* next = standing.next()) {
    fmt::print("{}", introduction(course, *next, "Next", console));
    fmt::print("  check  ./checker/run check {}\n  hint   ./checker/run hint {}\n", next->name(), next->name());
  } else {
    fmt::print(
        "{}\n",
        console.wrapped(fmt::format(
            "All {} exercises pass. You have written the library; `checker check --seed 2` tries it on other numbers.",
            standing.total())));
  }
  print_warning(progress);
  return all_passed;
}

}  // namespace workbook
