/// @file
/// Commands that no first check waits for. They are in the program all_commands, which has all commands and is built
/// when one of these is typed for the first time, or after a change; the checker goes on as that program.
#include "checker/commands/commands.hpp"

namespace workbook {

namespace {

int run_on_demand(const Course& course, const Options& options) {
  const fs::path program = options.program.parent_path() / "all_commands";
  // --course may name another course than that of this build.
  std::error_code ignored;
  const bool is_own = fs::equivalent(course.build().directory / "checker", program.parent_path(), ignored);
  const std::string trouble =
      is_own ? course.trouble_to_build("all_commands", program, {course.root() / "checker"}) : "";
  if (!trouble.empty()) throw std::runtime_error("This command could not be built; " + trouble);
  std::vector<std::string> words = options.typed;
  words.insert(words.begin(), program.string());
  exec_program(std::move(words));
}

}  // namespace

int debug(const Course& course, const Options& options) { return run_on_demand(course, options); }
int examples(const Course& course, const Options& options) { return run_on_demand(course, options); }
int export_recipe(const Course& course, const Options& options) { return run_on_demand(course, options); }
int figures(const Course& course, const Options& options) { return run_on_demand(course, options); }
int grade(const Course& course, const Options& options) { return run_on_demand(course, options); }
int handout(const Course& course, const Options& options) { return run_on_demand(course, options); }
int live(const Course& course, const Options& options) { return run_on_demand(course, options); }
int new_exercise(const Course& course, const Options& options) { return run_on_demand(course, options); }
int new_lecture(const Course& course, const Options& options) { return run_on_demand(course, options); }
int report(const Course& course, const Options& options) { return run_on_demand(course, options); }
int self_check(const Course& course, const Options& options) { return run_on_demand(course, options); }
int try_out(const Course& course, const Options& options) { return run_on_demand(course, options); }

}  // namespace workbook
