#include "checker/commands/commands.hpp"

#include <algorithm>
#include <array>
#include <ctime>

namespace workbook {

namespace {

/// Days between looking again, longer each time it goes well (Samani and Pan 2021 give the evidence for spacing).
constexpr std::array days_until_review = {1, 3, 7, 21, 60};

long days_since(const std::string& day, const std::string& today) {
  const auto number = [](const std::string& text) {
    std::tm time{};
    return strptime(text.c_str(), "%Y-%m-%d", &time) == nullptr ? 0 : timegm(&time) / (24L * 3600);
  };
  return number(today) - number(day);
}

struct Due {
  const Exercise* exercise = nullptr;
  long days_over = 0;  ///< negative: not yet
};

/// The exercise that has waited longest over its time, among those of earlier lectures than the last one begun.
Due most_due(const std::vector<Exercise>& exercises, const Progress& progress, const std::string& today) {
  std::string last_lecture;
  for (const Exercise& exercise : exercises)
    if (!progress.of(exercise.name()).verdict.empty()) last_lecture = exercise.lecture();
  Due due;
  for (const Exercise& exercise : exercises) {
    const Practice practice = progress.of(exercise.name());
    if (practice.passed_on.empty() || exercise.lecture() == last_lecture) continue;
    const std::string last = practice.reviews.empty() ? practice.passed_on : practice.reviews.back().day;
    const auto failed = std::find_if(practice.reviews.rbegin(), practice.reviews.rend(),
                                     [](const Review& review) { return review.verdict != "passed"; });
    const auto in_a_row = static_cast<std::size_t>(failed - practice.reviews.rbegin());
    const long over = days_since(last, today) - days_until_review[std::min(in_a_row, days_until_review.size() - 1)];
    if (due.exercise == nullptr || over > due.days_over) due = {&exercise, over};
  }
  return due;
}

/// A check of the file that a review has written; its first verdict counts.
int check_review(const Course& course, const Exercise& exercise, const fs::path& file, Progress& progress) {
  const Console console = Console::of_standard_output();
  CheckContext context(course);
  const std::size_t number = std::max<std::size_t>(progress.of(exercise.name()).reviews.size(), 1);
  const std::uint64_t seed = course.seed() + (course.has_solutions() ? number : 0);
  const CheckResult checked = check_exercise(context, check_task(course, exercise, seed, file));
  fmt::print("{}", terminal_report(checked, course, console, {}));
  if (!checked.is_judged()) return checker_failed;
  if (!checked.is_started()) {
    fmt::print("  {}\n", shown_path(file));
    return something_failed;
  }
  progress.remember_review(exercise.name(), to_string(checked.judgement.verdict));
  if (!checked.judgement.passed()) return stop("\nGo on in {}, then `{}`.", shown_path(file), command("review"));
  const Practice practice = progress.of(exercise.name());
  fmt::print("\nFirst passed on {}. Reviews so far:\n", practice.passed_on);
  for (const Review& review : practice.reviews)
    fmt::print("  {}  {} at the first try\n", review.day, in_words(review.verdict));
  std::error_code ignored;
  fs::remove(file, ignored);
  return all_passed;
}

int review(const Course& course) {
  Progress progress(course.progress_file());
  const std::vector<Exercise> exercises = course.exercises();
  const fs::path folder = course.progress_file().parent_path() / "review";
  const auto file_of = [&](const Exercise& exercise) { return folder / (exercise.name() + ".cpp"); };
  for (const Exercise& exercise : exercises)
    if (fs::exists(file_of(exercise))) return check_review(course, exercise, file_of(exercise), progress);
  const Due due = most_due(exercises, progress, current_day());
  if (due.exercise == nullptr || due.days_over < 0) {
    say("{}", due.exercise == nullptr ? "Nothing to review yet: exercises of earlier lectures that pass come here."
                                      : fmt::format("Nothing is due today; {} is next, in {}.", due.exercise->name(),
                                                    plural(static_cast<std::size_t>(-due.days_over), "day")));
    return all_passed;
  }
  const Exercise& exercise = *due.exercise;
  const std::string stub = stub_text(exercise, declared_signature(course, exercise));
  write_or_throw(file_of(exercise), stub);
  progress.begin_review(exercise.name());
  const Console console = Console::of_standard_output();
  fmt::print("{}\n{}\n", console.styled(exercise.name(), Style::strong), console.wrapped(exercise.entry->task, 2));
  say("\nYou wrote it on {}. Write it again without looking, in {}, then `{}`.", progress.of(exercise.name()).passed_on,
      shown_path(file_of(exercise)), command("review"));
  return all_passed;
}

}  // namespace

std::string due_for_review(const Course& course, const Progress& progress) {
  const std::vector<Exercise> exercises = course.exercises();
  const Due due = most_due(exercises, progress, current_day());
  return due.exercise != nullptr && due.days_over >= 0 ? due.exercise->name() : "";
}

Command review_command() {
  return {
      "review",
      students,
      "Write an exercise of an earlier lecture once more\n\nOne that is due: after 1, 3, 7, 21 and 60 days. It comes "
      "with an empty file and other cases; `review` again checks it. The first verdict is kept beside the others.",
      {"review"},
      {},
      review};
}

}  // namespace workbook
