/// @file
/// Commands that no first check waits for. They are in the program all_commands, which has all commands and is built
/// when one of these is typed for the first time, or after a change; the checker goes on as that program.
#include "checker/commands/on_demand/options.hpp"

#include <fstream>

namespace workbook {

namespace {

int run_on_demand(const Course& course) {
  std::vector<std::string> words;
  std::ifstream typed("/proc/self/cmdline");
  for (std::string word; std::getline(typed, word, '\0');) words.push_back(word);
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "all_commands";
  // --course may name another course than that of this build.
  std::error_code ignored;
  const bool is_own = fs::equivalent(course.build().directory / "checker", program.parent_path(), ignored);
  const std::string trouble =
      is_own ? course.trouble_to_build("all_commands", program, {course.root() / "checker"}) : "";
  if (!trouble.empty()) throw std::runtime_error("This command could not be built; " + trouble);
  words.at(0) = program.string();
  exec_program(std::move(words));
}

}  // namespace

int debug(const Course& course, const DebugOptions& /*options*/) { return run_on_demand(course); }
int examples(const Course& course, const std::string& /*lecture*/) { return run_on_demand(course); }
int export_recipe(const Course& course, const ExportOptions& /*options*/) { return run_on_demand(course); }
int figures(const Course& course, const FiguresOptions& /*options*/) { return run_on_demand(course); }
int grade(const Course& course, const GradeOptions& /*options*/) { return run_on_demand(course); }
int handout(const Course& course, const HandoutOptions& /*options*/) { return run_on_demand(course); }
int live(const Course& course, const std::string& /*lecture*/) { return run_on_demand(course); }
int new_exercise(const Course& course, const NewOptions& /*options*/) { return run_on_demand(course); }
int new_lecture(const Course& course, const NewOptions& /*options*/) { return run_on_demand(course); }
int report(const Course& course, const ReportOptions& /*options*/) { return run_on_demand(course); }
int self_check(const Course& course, const SelfCheckOptions& /*options*/) { return run_on_demand(course); }
int try_out(const Course& course, const TryOptions& /*options*/) { return run_on_demand(course); }

}  // namespace workbook
