#include "checker/commands/check_exercise.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"
#include "checker/report/console.hpp"
#include "checker/report/json_report.hpp"
#include "checker/report/overlay.hpp"
#include "checker/report/terminal_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <map>

namespace workbook {

namespace {

std::vector<Exercise> chosen(const Course& course, const std::vector<std::string>& names) {
  if (names.empty()) return course.exercises();
  std::vector<Exercise> all;
  for (const std::string& name : names) {
    for (const Exercise& exercise : course.find(name)) {
      const bool already =
          std::any_of(all.begin(), all.end(), [&](const Exercise& each) { return each.entry == exercise.entry; });
      if (!already) all.push_back(exercise);
    }
  }
  return all;
}

/// What is being done, while it takes longer than a blink; written over by what comes next.
class Ticker {
 public:
  explicit Ticker(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO) != 0) {}
  ~Ticker() { clear(); }
  void show(std::size_t number, std::size_t total, const std::string& name) const {
    if (wanted_) fmt::print(stderr, "\r\033[K[{} of {}] {} ...", number, total, name);
  }
  void clear() const {
    if (wanted_) fmt::print(stderr, "\r\033[K");
  }

 private:
  bool wanted_;
};

/// Verdicts on a file elsewhere, or with another seed, are no progress.
bool counts_as_progress(const CheckOptions& options) { return !options.file && options.seed == 1; }

void draw(const Course& course, const Checked& checked, bool to_terminal) {
  if (!checked.executable) return;
  try {
    const auto files = draw_overlay(overlay_of(checked), course.scratch() / "plots", checked.exercise.name());
    if (to_terminal) fmt::print("  Plot   {}\n", files.front().string());
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
  }
}

}  // namespace

int check(const Course& course, const CheckOptions& options) {
  const std::vector<Exercise> exercises = chosen(course, options.names);
  if (options.file && exercises.size() != 1) {
    fmt::print(stderr, "--file needs the one exercise that the file is for: checker check EXERCISE --file FILE.\n");
    return wrong_usage;
  }
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  const Console console = Console::of_standard_output();
  Progress progress(course.progress_file());
  std::map<std::string, LectureReference> references;
  std::vector<Checked> results;
  {
    const Ticker ticker(!options.json);
    for (std::size_t i = 0; i < exercises.size(); ++i) {
      const Exercise& exercise = exercises[i];
      ticker.show(i + 1, exercises.size(), exercise.name());
      if (!references.contains(exercise.lecture())) {
        references.emplace(exercise.lecture(), course.reference(exercise.lecture(), options.seed));
      }
      const ExerciseReference& reference = references.at(exercise.lecture()).exercise(exercise.name());
      const std::filesystem::path file = options.file.value_or(course.student_file(exercise));
      const std::string source = fingerprint(file);
      results.push_back(check_exercise(course, toolchain, exercise, reference, file));
      const Checked& checked = results.back();
      if (counts_as_progress(options) && checked.judgement.verdict != Verdict::checker_error) {
        progress.remember(exercise.name(), {to_string(checked.judgement.verdict), source});
      }
      ticker.clear();
      if (!options.json) fmt::print("{}", terminal_report(course, checked, console));
      if (options.plot) draw(course, checked, !options.json);
      if (!options.json) std::fflush(stdout);
    }
  }

  if (options.json) {
    // What the student printed may hold bytes that are no text; they are replaced, not fatal.
    fmt::print("{}\n",
               json_report(results, options.seed).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (results.size() > 1) {
    fmt::print("\n{}\n", summary_line(results));
  }
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());

  const auto any = [&](auto condition) { return std::any_of(results.begin(), results.end(), condition); };
  if (any([](const Checked& checked) { return checked.judgement.verdict == Verdict::checker_error; }))
    return checker_failed;
  if (any([](const Checked& checked) { return !checked.judgement.passed(); })) return something_failed;
  return all_passed;
}

}  // namespace workbook
