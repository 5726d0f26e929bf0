#include "checker/commands/commands.hpp"
#include "checker/course/exam.hpp"

#include <algorithm>

namespace workbook {

namespace {

/// The name for what was typed, which may be the path of an exercise's own file or of a lecture's folder. All else as
/// it is. @throws UsageError for a file that is no exercise's own
std::string known_name(const Course& course, const fs::path& typed) {
  if (typed.extension() != ".cpp") return (typed.has_filename() ? typed : typed.parent_path()).filename();
  const bool is_there = fs::exists(typed);
  if (!is_there && !typed.has_parent_path()) return typed.stem();
  if (!is_there) throw UsageError(fmt::format("There is no file {}.", printable(typed.string())));
  std::string named = "EXERCISE";
  for (const Exercise& exercise : course.exercises()) {
    if (exercise.name() != typed.stem()) continue;
    named = exercise.name();
    std::error_code ignored;
    if (fs::equivalent(typed, course.student_file(exercise), ignored)) return named;
  }
  const std::string file = printable(typed.string());
  throw UsageError(fmt::format("{} is not an exercise's own file. To check it: `{}`.", file,
                               command("check " + named + " --file " + shell_quoted(file))));
}

/// The name of an exercise or a lecture.
Requirement requirement_of(std::string& name) {
  return [&name](const Course& course) {
    name = known_name(course, name);
    course.find(name);
  };
}

}  // namespace

Parameter names_parameter(std::vector<std::string>& names) {
  return {"NAME", "", &names, "exercises or lectures, by name or number; none: all", false, [&](const Course& course) {
            for (std::string& name : names) name = known_name(course, name);
            course.choose(names);
          }};
}

Parameter name_parameter(std::string& name) {
  return {"NAME", "", &name, "an exercise or a lecture", false, requirement_of(name)};
}

Parameter exercise_parameter(std::string& name, const char* help, bool is_required) {
  return {"EXERCISE",  "",
          &name,       help,
          is_required, [&](const Course& course) {
            name = course.find_exercise(known_name(course, name)).name(); }};
}

Parameter lecture_parameter(std::string& name) {
  return {"LECTURE", "",
          &name,     "its name, number or topic",
          true,      [&](const Course& course) {
            name = course.find(known_name(course, name)).front().lecture(); }};
}

Parameter own_file_parameter(std::optional<fs::path>& file, const bool* is_for_a_program) {
  return {
      "--file", "FILE", &file, "check this file instead of the exercise's own", false, [&, is_for_a_program](auto&) {
        if (is_for_a_program == nullptr || !*is_for_a_program) require_file(*file, "the function of an exercise");
      }};
}

Parameter seed_parameter(std::optional<std::uint64_t>& seed) {
  return {"--seed", "NUMBER", &seed, "draw other random cases"};
}

Parameter place_parameter(const char* name, const char* type, std::optional<fs::path>& place, const char* help,
                          bool is_required) {
  return {name, type, &place, help, is_required, [&](const Course&) {
            if (const std::string trouble = place_trouble(*place); !trouble.empty())
              throw UsageError(fmt::format("{} cannot be written ({}); name a place that is writable.",
                                           printable(place->string()), trouble));
          }};
}

void require_file(const fs::path& file, const char* what) {
  std::error_code ignored;
  if (fs::exists(file, ignored) && !fs::is_directory(file, ignored)) return;
  throw UsageError(fmt::format(
      fmt::runtime(fs::exists(file, ignored) ? "{} is no file: {} is meant." : "There is no file {}: {} is meant."),
      printable(file.string()), what));
}

Requirement no_help_in_exam(const std::vector<std::string>& names) {
  return [&](const Course& course) { refuse_in_exam(course, course.choose(names)); };
}

Requirement no_help_in_exam(const std::string& name) {
  return [&](const Course& course) { refuse_in_exam(course, {course.find_exercise(name)}); };
}

void warn(const Progress& progress) {
  if (!progress.warning().empty()) fmt::print(stderr, "{}\n", progress.warning());
}

std::string remember(Progress& progress, const CheckResult& checked) {
  const Verdict verdict = checked.judgement.verdict;
  const std::string values = has_values(verdict) ? checked.fingerprint_of_values() : "";
  if (!progress.remember(checked.name(), to_string(verdict), checked.source, values)) return "";
  return fmt::format("Your change has changed no value. `{}` shows the next hint.", command("hint " + checked.name()));
}

std::vector<CheckTask> tasks_of(const Course& course, const Chosen& chosen, bool is_drawn) {
  const std::vector<Exercise> exercises = course.choose(chosen.names);
  if ((chosen.file || chosen.case_name) && exercises.size() != 1)
    throw UsageError(
        fmt::format("--file and --case need one exercise, for example `{}`.", command("check EXERCISE --file FILE")));
  std::vector<CheckTask> tasks;
  for (const Exercise& exercise : exercises) {
    tasks.push_back(check_task(course, exercise, chosen.seed.value_or(course.seed()), chosen.file));
    tasks.back().is_always_drawn = is_drawn;
  }
  return tasks;
}

void set_stage(CheckTask& task, const Progress& progress) {
  if (!task.exercise.entry->is_problem() || task.is_elsewhere || progress.of(task.exercise.name()).hints_shown > 0)
    return;
  const int tries = progress.wrong_tries_before(task.exercise.name(), file_fingerprint(task.file));
  task.stage = std::min(1 + tries, CheckTask::last_stage);
}

std::size_t find_case(const ExerciseReference& exercise, const std::string& asked) {
  const std::vector<Case>& cases = exercise.cases;
  const std::string number = asked.substr(std::min(asked.find_first_not_of('0'), asked.size()));
  std::vector<std::string> known;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (number == std::to_string(i + 1) || asked == cases[i].name) return i;
    if (i < exercise.described_cases()) known.push_back(cases[i].name);
  }
  const std::string proposal = did_you_mean(asked, known);
  throw UsageError(fmt::format("{} has no case '{}'. {}", exercise.name, printable(asked),
                               proposal.empty() ? fmt::format("Its cases have the numbers 1 to {}; the first are: {}.",
                                                              cases.size(), fmt::join(known, "; "))
                                                : fmt::format("Did you mean '{}'?", proposal)));
}

void require_pictures(const fs::path& directory) {
  if (program_on_path("gnuplot").empty()) throw std::runtime_error(gnuplot_is_missing);
  if (const std::string trouble = folder_trouble(directory); !trouble.empty())
    throw UsageError(fmt::format("Pictures cannot be written into {} ({}); give another folder with --out.",
                                 shown_path(directory), trouble));
}

std::size_t copy_figures(const Course& course, const std::string& lecture, const fs::path& to) {
  const fs::path from = course.build().directory / "figures" / lecture;
  std::size_t count = 0;
  if (!fs::exists(from)) return count;
  fs::create_directories(to);
  for (const auto& picture : fs::directory_iterator(from)) {
    if (picture.path().filename() == "drawn") continue;  // the build's own mark
    fs::copy_file(picture.path(), to / picture.path().filename(), fs::copy_options::overwrite_existing);
    count += picture.path().extension() == ".svg" ? 1 : 0;
  }
  return count;
}

std::string draw(const Course& course, const CheckResult& checked, bool is_shown, const Console& console) {
  if (checked.observation.sweep.empty()) return "";
  try {
    const Overlay overlay = overlay_of(checked);
    const auto files = draw_overlay(overlay, course.plots(), checked.name());
    return fmt::format("{}  Plot   {}\n", is_shown ? terminal_picture(overlay, files.back(), console) : "",
                       shown_path(files.front()));
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return "";
  }
}

}  // namespace workbook
