// The command exam.
#include "checker/course/exam.hpp"
#include "checker/commands/commands.hpp"

#include <algorithm>
#include <ctime>
#include <random>

namespace workbook {

namespace {

std::vector<Exercise> problems_of(const Course& course, const Exam& exam) {
  std::vector<Exercise> problems;
  for (const Exercise& exercise : course.exercises())
    if (std::ranges::count(exam.problems, exercise.name()) > 0) problems.push_back(exercise);
  return problems;
}

void show(const Course& course, const Exam& exam) {
  const Console console = Console::of_standard_output();
  fmt::print("{}\n\n",
             console.styled(
                 fmt::format("Exam of {}: {}", hours_and_minutes(std::chrono::minutes(exam.minutes)), time_text(exam)),
                 Style::strong));
  for (const Exercise& problem : problems_of(course, exam))
    fmt::print("{}{}\n{}\n    {}\n", console.mark(is_begun(course.student_file(problem)) ? "?" : "·", Style::quiet),
               fmt::format("{}, {}, about {} min", problem.name(),
                           problem.entry->points == 1 ? "1 point" : fmt::format("{} points", problem.entry->points),
                           problem.entry->minutes),
               console.wrapped(problem.entry->task, 4), shown_path(course.student_file(problem)));
  say("\nNo hints, no checks: compile and run what you write by `{}`. `{}` grades it.", command("try"),
      command("exam --finish"));
}

/// Grades as the files stand, keeps the verdicts and ends the exam.
int finish(const Course& course, const Exam& exam) {
  const Console console = Console::of_standard_output();
  CheckContext context(course);
  std::vector<CheckTask> tasks;
  for (const Exercise& problem : problems_of(course, exam)) {
    tasks.push_back(check_task(course, problem));
    tasks.back().is_explained = false;
  }
  Progress progress(course.progress_file());
  const auto left = exam.time_left();
  double points = 0, all_points = 0;
  bool is_judged = true;
  std::string table;
  ProgressBar progress_bar;
  std::size_t done = 0;
  check_all(context, tasks, [&](const CheckResult& checked) {
    progress_bar.show(done++, tasks.size(), checked.name());
    is_judged = is_judged && checked.is_judged();
    if (checked.is_judged()) remember(progress, checked);
    points += checked.score();
    all_points += checked.points();
    table += fmt::format(
        "  {}{}  {} of {}  {}\n",
        console.mark(checked.judgement.passed() ? "✓" : "✗", checked.judgement.passed() ? Style::good : Style::bad),
        padded(checked.name(), 34), checked.score(), checked.points(), in_words(to_string(checked.judgement.verdict)));
  });
  progress_bar.clear();
  const auto taken = std::chrono::minutes(exam.minutes) - left;
  fmt::print("{}", table);
  say("\n{} of {} points, in {} of {}{}.", points, all_points, hours_and_minutes(taken),
      hours_and_minutes(std::chrono::minutes(exam.minutes)), left.count() < 0 ? ": over time" : "");
  warn(progress);
  if (!is_judged) {
    say("Not everything could be judged, so the exam goes on; `{}` says what is wrong.", command("doctor"));
    return checker_failed;
  }
  std::error_code problem;
  if (!fs::remove(exam_file(course), problem))
    throw std::runtime_error(fmt::format("{} cannot be removed ({}), so the exam is not over.",
                                         shown_path(exam_file(course)), problem.message()));
  fmt::print("The exam is over; `{}` and `{}` help again.\n", command("check"), command("hint"));
  return points == all_points ? all_passed : something_failed;
}

struct ExamOptions {
  std::string lectures;
  int minutes = 0;  ///< that it may take; 0: what its problems take together
  bool finish = false;
  std::optional<std::uint64_t> seed;
};

int exam(const Course& course, const ExamOptions& options) {
  const std::optional<Exam> running = running_exam(course);
  if (options.finish && !options.lectures.empty())
    throw UsageError("--finish grades the exam that is running; leave out the lectures.");
  if (running && !options.lectures.empty())
    throw UsageError(fmt::format("An exam is running already; `{}` grades it.", command("exam --finish")));
  if (running && options.minutes > 0)
    throw UsageError(fmt::format("The exam that is running has {}; --minutes is for a new one.",
                                 hours_and_minutes(std::chrono::minutes(running->minutes))));
  if (!running && options.lectures.empty())
    throw UsageError(fmt::format("No exam is running; `{}` draws one from these lectures.", command("exam 01-03")));
  if (options.finish) return finish(course, *running);
  if (running) {
    show(course, *running);
    return all_passed;
  }
  Exam drawn;
  drawn.seed = options.seed.value_or(std::random_device{}());
  const Progress progress(course.progress_file());
  int minutes = 0;
  for (const Exercise& problem : drawn_problems(course, progress, options.lectures, drawn.seed)) {
    drawn.problems.push_back(problem.name());
    minutes += problem.entry->minutes;
  }
  drawn.minutes = options.minutes > 0 ? options.minutes : minutes;
  drawn.started = std::time(nullptr);
  write_exam(course, drawn);
  show(course, drawn);
  warn(progress);
  return all_passed;
}

}  // namespace

Command exam_command() {
  const auto options = std::make_shared<ExamOptions>();
  return {
      "exam",
      students,
      "Draw an exam of six problems that you have not seen, and grade it\n\nThe problems come from the lectures that "
      "you name. Until they are graded there are no hints, checks, plots or solutions of them. Without an argument it "
      "shows the problems and the time that is left; --finish grades what is written by then.",
      {"exam 01-03", "exam 09 --minutes 90", "exam", "exam --finish"},
      {{"LECTURES", "", &options->lectures, "a lecture or a range of them, 01-03; none: the exam that is running"},
       {"--minutes", "NUMBER", &options->minutes, "the time; 0: what the problems take together", false, {}, {0, 1440}},
       {"--finish", "", &options->finish, "grade the exam and end it"},
       {"--seed", "NUMBER", &options->seed, "draw the problems by this number, to get the same ones again"}},
      with_options(options, &exam)};
}

}  // namespace workbook
