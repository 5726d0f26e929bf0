#include "checker/commands/on_demand/student_programs.hpp"

namespace workbook {

int debug(const Course& course, const DebugOptions& options) {
  const std::string gdb = options.build_only ? "" : path_of_gdb();
  const Exercise exercise = course.find_exercise(options.name);
  CheckContext context(course);
  const CheckTask task = check_task(course, exercise);
  std::size_t index = 0;
  if (options.case_name) {
    index = find_case(context.reference(task), *options.case_name);
  } else {
    const CheckResult checked = check_exercise(context, task);
    if (checked.observation.replies.empty() || !checked.is_started()) {
      fmt::print("{}", terminal_report(checked, course, Console::of_standard_output(), {}));
      return something_failed;
    }
    if (!checked.judgement.failing.empty()) index = checked.judgement.failing.front();
  }
  const fs::path program = case_program(course, context, task, index);
  if (program.empty()) return something_failed;
  if (options.build_only) return all_passed;
  std::vector<std::string> words = debugger(context, gdb);
  words.insert(words.end(), {"-ex", "break rigid::" + exercise.name(), "-ex", "run", program.string()});
  exec_program(words);
}

}  // namespace workbook
