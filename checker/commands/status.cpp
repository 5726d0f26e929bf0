// Where the student stands: what is shown without a command, and the command list.
#include "checker/commands/commands.hpp"
#include "checker/course/assignment.hpp"
#include "checker/course/exam.hpp"

#include <algorithm>
#include <sstream>

namespace workbook {

namespace {

/// What is odd: the progress, and files among the exercises that are none, a slip in a name or something of the
/// student's own.
void print_remarks(const Course& course, const Progress& progress) {
  warn(progress);
  for (const Card& card : course.cards()) {
    std::vector<std::string> names;
    for (const CardExercise& entry : card.exercises) names.push_back(entry.name);
    std::error_code problem;
    for (const auto& entry : fs::directory_iterator(course.lectures() / card.lecture / "exercises", problem)) {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() != ".cpp" || name.starts_with('.') || std::ranges::count(names, name) > 0) continue;
      const std::string meant = did_you_mean(name, names);
      fmt::print(stderr, "{} is no exercise of the course and is not checked.{}\n", course.in_course(entry.path()),
                 meant.empty() ? "" : fmt::format(" Did you mean {}.cpp?", meant));
    }
  }
}

/// How much time an exam leaves, while one runs.
void print_exam(const Course& course) {
  if (const std::optional<Exam> exam = running_exam(course))
    say("\nAn exam is running, {}: `{}`", time_text(*exam), command("exam"));
}

/// "Week 3, due 2027-03-01T23:59:00Z: 2 of 5 exercises pass."
std::string assignment_state(const Course& course, const ProgressSummary& summary) {
  const Assignment assignment(course, course.lectures() / "assignment.json");
  const auto passed =
      std::ranges::count_if(assignment.exercises(), [&](const Exercise& exercise) { return summary.passes(exercise); });
  return fmt::format("{}{}: {} of {} exercises pass.", assignment.title().empty() ? "Assignment" : assignment.title(),
                     assignment.due_text().empty() ? "" : ", due " + assignment.due_text(), passed,
                     assignment.exercises().size());
}

/// How to go through a lecture: what is left of it, in the order in which it is best done, and how long it takes.
std::string plan(const Course& course, const ProgressSummary& summary, const Card& card,
                 const std::vector<Exercise>& asked) {
  constexpr std::size_t words_in_a_minute = 100, minutes_for_a_figure = 5;
  const Console console = Console::of_standard_output();
  std::istringstream notes(read_file(course.notes_file(card)).value_or(""));
  std::size_t words = 0, figures = 0;
  for (std::string word; notes >> word; ++words) figures += word.starts_with("\\live{") ? 1 : 0;
  std::vector<std::string> exercises, problems;
  std::size_t minutes[2] = {};
  for (const Exercise& exercise : asked) {
    if (exercise.lecture() != card.lecture || summary.passes(exercise)) continue;
    const bool is_problem = exercise.entry->is_problem();
    (is_problem ? problems : exercises).push_back(exercise.name());
    minutes[is_problem ? 1 : 0] += static_cast<std::size_t>(exercise.entry->minutes);
  }
  if (exercises.empty() && problems.empty()) return "";
  std::string text = "\n" + console.styled("Plan for " + card.lecture, Style::strong) + "\n";
  const auto row = [&](const char* what, std::size_t time, const std::string& words_of_it) {
    if (time == 0) return;
    const std::string body = console.wrapped(words_of_it, 24);
    text += fmt::format("  {:<10}{:>10}  {}\n", what, hours_and_minutes(std::chrono::minutes(time)),
                        body.substr(std::min<std::size_t>(body.size(), 24)));
  };
  row("read", (words + words_in_a_minute - 1) / words_in_a_minute, course.in_course(course.notes_file(card)));
  row("predict", figures * minutes_for_a_figure, plural(figures, "live figure") + ": say what will happen, then start");
  row("exercises", minutes[0], listed(exercises));
  row("problems", minutes[1], listed(problems));
  return text;
}

/// What is planned: the lectures of the assignment, or else that of the next exercise; and a review that is due.
std::string plans(const Course& course, const Progress& progress, const ProgressSummary& summary) {
  const fs::path file = course.lectures() / "assignment.json";
  const bool has_assignment = fs::exists(file);
  const Assignment assignment(course, has_assignment ? std::optional(file) : std::nullopt);
  std::string text;
  for (const Card& card : course.cards())
    if (has_assignment || (summary.next() != nullptr && summary.next()->card == &card))
      text += plan(course, summary, card, assignment.exercises());
  if (const std::string due = due_for_review(course, progress); !due.empty())
    text += fmt::format("{}  {:<10}{:>10}  {}, by `{}`\n", text.empty() ? "\n" : "", "review", "10 min", due,
                        command("review"));
  return text;
}

int list(const Course& course) {
  const Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  fmt::print("{}", exercise_list(course, progress, summary, Console::of_standard_output()));
  fmt::print("{}", plans(course, progress, summary));
  if (const Exercise* next = summary.next()) fmt::print("\nNext: {}\n", next->name());
  print_exam(course);
  print_remarks(course, progress);
  return all_passed;
}

}  // namespace

int status(const Course& course) {
  const Console console = Console::of_standard_output();
  const Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  fmt::print("{}\n", overview(course, summary, console));
  std::string matters;
  const auto& [last, verdict, day] = progress.last();
  if (!last.empty())
    matters +=
        fmt::format("Last: {}, {}, {}.\n", last, in_words(verdict), day == current_day() ? "today" : "on " + day);
  if (const std::string due = due_for_review(course, progress); !due.empty())
    matters += fmt::format("Due for review: {}, by `{}`.\n", due, command("review"));
  if (fs::exists(course.lectures() / "assignment.json")) matters += assignment_state(course, summary) + "\n";
  if (!matters.empty()) say("{}\n", matters);
  if (const Exercise* next = summary.next()) {
    const State state = state_of(course, progress, *next);
    fmt::print("{}", introduction(course, *next, console));
    if (!progress.of(next->name()).verdict.empty())
      fmt::print("  state  {}\n", console.styled(state.words, state.style));
    fmt::print("  check  {}\n  hint   {}\n  watch  {}\n", command("check " + next->name()),
               command("hint " + next->name()), command("watch"));
  } else {
    say("All {} exercises pass. You have written the library; `{}` runs the "
        "worked examples of a lecture on it, `{}` draws its figures.",
        summary.exercises.size(), command("examples 03"), command("figures 03"));
  }
  print_exam(course);
  print_remarks(course, progress);
  return all_passed;
}

Command list_command() { return {"list", students, "Show every exercise with its state", {}, {}, list}; }

}  // namespace workbook
