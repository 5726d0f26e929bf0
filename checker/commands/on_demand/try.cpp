#include "checker/commands/on_demand/student_programs.hpp"
#include "checker/course/exam.hpp"

namespace workbook {

namespace {

/// Every variable of the student's function at one case, as the debugger sees them.
int try_case(const Course& course, const TryOptions& options) {
  constexpr std::chrono::seconds longest(60);
  constexpr std::size_t most_output = 1 << 20;
  const Exercise exercise = course.find_exercise(options.file->string());
  refuse_in_exam(course, {exercise});
  const std::string gdb = path_of_gdb();
  CheckContext context(course);
  const CheckTask task = check_task(course, exercise);
  const std::size_t index = find_case(context.reference(task), *options.case_name);
  const fs::path program = case_program(course, context, task, index);
  if (program.empty()) return something_failed;
  std::vector<std::string> words = debugger(context, gdb);
  words.insert(words.end(), {"-batch-silent", "-ex", "intermediate rigid::" + exercise.name(), program.string()});
  Launch launch;
  launch.program = gdb;
  launch.arguments = {words.begin() + 1, words.end()};
  launch.environment = {"HOME=" + program.parent_path().string()};  // where gdb keeps its index of symbols
  const FinishedProgram shown = run_program(launch, longest, most_output);
  fmt::print("{}", printable(shown.output));
  if (shown.out_of_time)
    return stop("Your function had not ended after {} s: a loop never ends, perhaps.", longest.count());
  return shown.succeeded() ? all_passed : something_failed;
}

}  // namespace

int try_out(const Course& course, const TryOptions& options) {
  if (options.case_name) return try_case(course, options);
  const fs::path file = fs::absolute(options.file.value_or(course.lectures() / "try.cpp"));
  if (!options.file && !fs::exists(file)) {
    write_or_throw(file, from_skeleton("try.cpp"));
    fmt::print("A first experiment is in {}: change it as you like.\n\n", shown_path(file));
  }
  const Submission experiment = read_submission(file);
  const fs::path program = folder_of(course, "try") / "program";
  const auto files = own_functions(experiment.text, course.exercises(),
                                   [&](const Exercise& exercise) { return course.student_file(exercise); });
  if (!build_program(course, file, files, {}, program)) return something_failed;
  exec_program({program.string()});
}

}  // namespace workbook
