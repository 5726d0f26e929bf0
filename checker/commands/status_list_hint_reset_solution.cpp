// Where the student stands, exercise by exercise: the commands status (the one without a name), list, hint and reset.
#include "checker/base/formulas.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/assignment.hpp"
#include "checker/course/exam.hpp"
#include "checker/course/locked_text.hpp"

#include <algorithm>
#include <cmath>
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
  const auto passed = std::ranges::count_if(assignment.exercises(), [&](const Exercise& exercise) {
    const auto same = std::ranges::find(summary.exercises, exercise.name(), &Exercise::name);
    return summary.passed[static_cast<std::size_t>(same - summary.exercises.begin())];
  });
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
    const auto same = std::ranges::find(summary.exercises, exercise.name(), &Exercise::name);
    if (exercise.lecture() != card.lecture ||
        summary.passed[static_cast<std::size_t>(same - summary.exercises.begin())])
      continue;
    const bool is_problem = same->entry->is_problem();
    (is_problem ? problems : exercises).push_back(exercise.name());
    minutes[is_problem ? 1 : 0] += static_cast<std::size_t>(same->entry->minutes);
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

/// What comes out in the limits of the exercise, and why.
std::string limits_text(const Course& course, const Exercise& exercise) {
  const ExerciseReference reference =
      course.reference(exercise.lecture(), course.seed(), exercise.name()).exercises.front();
  std::string text = reference.limits.empty() ? "" : "\nLimits:\n";
  for (const Limit& limit : reference.limits) {
    const Case& one = reference.cases[limit.case_index];
    Value value = one.expected;  // without what rounding leaves of zeros
    for (std::size_t n = 0; n < value.numbers.size(); ++n)
      if (std::abs(value.numbers[n]) <= one.tolerance * scale_at(one, n)) value.numbers[n] = 0;
    const std::string line = fmt::format("- {}: {} = {}. {}", one.name, reference.result_name,
                                         format_value(value, reference.result_kind, 4), limit.reason);
    text += Console::of_standard_output().wrapped(line, 2) + "\n";
  }
  return text;
}

/// Code, then another route or the derivation, which a heading begins, as a terminal shows them.
int show_solution(const Course& course, const Exercise& exercise, const std::string& text) {
  const Console console = Console::of_standard_output();
  const std::size_t heading = std::min(text.find("\n# "), text.size());
  fmt::print("{}\n", text.substr(0, heading));
  for (const std::string& line : lines_of(with_readable_formulas(text.substr(heading))))
    fmt::print("{}\n", line.starts_with("    ") ? line
                       : line.starts_with("# ") ? console.styled(line.substr(2), Style::strong)
                                                : console.wrapped(line));
  const fs::path page = course.notes_folder() / ("exercise_" + exercise.name() + ".html");
  if (fs::exists(page)) fmt::print("Page: {}\n", console.linked(page.filename().string(), file_address(page)));
  fmt::print("{}", limits_text(course, exercise));
  return all_passed;
}

/// What the copy for students keeps locked, opened by the student's own function.
int unlock(const Course& course, const Exercise& exercise, const std::string& locked) {
  CheckContext context(course);
  CheckTask task = check_task(course, exercise);
  task.further = calls_of_locked(locked);
  const CheckResult checked = check_exercise(context, task);
  if (checked.judgement.passed())
    if (const std::optional<std::string> text = unlocked_text(locked, checked.observation.further))
      return show_solution(course, exercise, *text);
  return stop("Your {} does not pass yet; its solution and derivation open once it does.", exercise.name());
}

}  // namespace

int list(const Course& course, const Options& /*options*/) {
  const Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  fmt::print("{}", exercise_list(course, progress, summary, Console::of_standard_output()));
  fmt::print("{}", plans(course, progress, summary));
  if (const Exercise* next = summary.next()) fmt::print("\nNext: {}\n", next->name());
  print_exam(course);
  print_remarks(course, progress);
  return all_passed;
}

int status(const Course& course, const Options& /*options*/) {
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

/// What was checked last, or else the next exercise, if that does not pass.
static Exercise at_hand(const ProgressSummary& summary, const Progress& progress) {
  const auto last = std::ranges::find(summary.exercises, progress.last()[0], &Exercise::name);
  const bool is_open =
      last != summary.exercises.end() && !summary.passed[static_cast<std::size_t>(last - summary.exercises.begin())];
  return is_open ? *last : *summary.next();
}

int prepare(const Course& course, const Options& /*options*/) {
  struct Part {
    const char* what;
    std::vector<std::string> targets;
  };
  std::vector<Part> parts = {{"checks", {"toolchain", "toolchain_diagnostic"}},
                             {"commands", {"all_commands"}},
                             {"notes", {"notes"}},
                             {"examples and figures", {}}};
  for (const Card& card : course.cards()) {
    if (course.has_solutions()) parts[0].targets.push_back("reference_results_" + card.lecture);
    for (const char* objects : {"worked_examples_objects_", "figures_objects_"})
      parts[3].targets.push_back(objects + card.lecture);
  }
  say("This builds what commands build when they are first used, so that nothing is left to build on the way. Ctrl-C "
      "stops it; what is built by then stays.");
  const Console console = Console::of_standard_output();
  int status = all_passed;
  for (const Part& part : parts) {
    const FinishedProgram built = make(course.build(), part.targets);
    if (!built.succeeded()) status = something_failed;
    fmt::print("{}{}{}\n", built.succeeded() ? console.mark("✓", Style::good) : console.mark("✗", Style::bad),
               part.what, built.succeeded() ? "" : ": " + built.output);
    std::fflush(stdout);
  }
  if (status == all_passed) {
    const Toolchain toolchain = read_toolchain(course.toolchain_file());
    for (const Exercise& exercise : course.exercises()) require_complete(toolchain, exercise.name());
  }
  return status;
}

int hint(const Course& course, const Options& options) {
  const Console console = Console::of_standard_output();
  Progress progress(course.progress_file());
  const ProgressSummary summary = summary_of(course, progress);
  if (options.name.empty() && summary.next() == nullptr) {
    say("Every exercise passes, so there is no next one. `{}` shows the hints of one.", command("hint EXERCISE"));
    return all_passed;
  }
  const Exercise exercise = options.name.empty() ? at_hand(summary, progress) : course.find_exercise(options.name);
  refuse_in_exam(course, {exercise});
  const std::vector<std::string> hints = read_hints(course.hints_file(exercise));
  const std::size_t shown_before = progress.of(exercise.name()).hints_shown;
  const std::size_t first = options.all ? 0 : std::min(shown_before, hints.size() - 1);
  const std::size_t last = options.all ? hints.size() - 1 : first;
  for (std::size_t i = first; i <= last; ++i) {
    const std::string heading = fmt::format("Hint {} of {} for {}", i + 1, hints.size(), exercise.name());
    fmt::print("{}\n{}\n\n", console.styled(heading, Style::strong), console.wrapped(hints[i], 2));
  }
  if (last + 1 < hints.size()) {
    fmt::print("For the next hint, type the same again.\n");
  } else {
    fmt::print("That was the last hint. Read on in\n  {}\n",
               notes_place(course, exercise, exercise.entry->notes, console, 2));
  }
  progress.remember_hints(exercise.name(), std::max(shown_before, last + 1));
  warn(progress);
  return all_passed;
}

int reset(const Course& course, const Options& options) {
  const Exercise exercise = course.find_exercise(options.name);
  const auto refuse = [&](const std::string& reason) {
    fmt::print(stderr, "{} was not reset: {}.\n", exercise.name(), reason);
    return checker_failed;
  };
  const std::string signature = declared_signature(course, exercise);
  if (signature.empty()) return refuse(shown_path(course.contract_file(*exercise.card)) + " does not declare it");
  const fs::path file = course.student_file(exercise);
  std::error_code problem;
  if (fs::exists(file, problem)) {
    const auto kept = free_name(course.progress_file().parent_path() / "kept" / (exercise.name() + ".cpp"));
    fs::create_directories(kept.parent_path(), problem);
    if (!fs::copy_file(file, kept, problem))
      return refuse(fmt::format("your version could not be kept as {} ({})", shown_path(kept), problem.message()));
    fmt::print("Your version is kept as {}.\n", shown_path(kept));
  }
  const std::string failure = write_file(file, stub_text(exercise, signature));
  if (!failure.empty()) return refuse(fmt::format("{} cannot be written ({})", shown_path(file), failure));
  Progress(course.progress_file()).forget(exercise.name());
  fmt::print("{} is as it was at the beginning.\n", shown_path(file));
  return all_passed;
}

int solution(const Course& course, const Options& options) {
  const Exercise exercise = course.find_exercise(options.name);
  const std::optional<std::string> locked = read_file(course.locked_file(exercise));
  if (locked) return unlock(course, exercise, *locked);
  const std::optional<std::string> code = read_file(course.solution_file(exercise));
  if (!code) return stop("This copy of the workbook does not have this solution; your instructor has it.");
  const Progress progress(course.progress_file());
  if (!options.now && !progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
    return stop("Your {} does not pass yet; its solution is shown once it does, or now by `{}`.", exercise.name(),
                command("solution " + exercise.name() + " --now"));
  return show_solution(course, exercise, *code + "\n" + read_file(course.derivation_file(exercise)).value_or(""));
}

}  // namespace workbook
