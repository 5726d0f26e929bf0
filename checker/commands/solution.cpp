#include "checker/base/console.hpp"
#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/progress.hpp"

#include <fmt/format.h>

namespace workbook {

int solution(const Course& course, const Options& options) {
  const Exercise exercise = course.find_exercise(options.name);
  const Console console = Console::of_standard_output();
  const auto say = [&](const std::string& sentence) {
    fmt::print("{}\n", console.wrapped(sentence));
    return something_failed;
  };
  const std::optional<std::string> code = read_file(course.solution_file(exercise));
  if (!code) return say("This copy of the workbook has no solutions; your instructor has them.");
  const Progress progress(course.progress_file());
  if (!options.now && !progress.passed(exercise.name(), file_fingerprint(course.student_file(exercise))))
    return say(fmt::format("Your {} does not pass yet; its solution is shown once it does, or now by `{}`.",
                           exercise.name(), command("solution " + exercise.name() + " --now")));
  fmt::print("{}\n", *code);
  const std::filesystem::path derivation = course.derivation_file(exercise);
  if (std::filesystem::exists(derivation)) {
    const std::filesystem::path page = course.notes_folder() / ("exercise_" + exercise.name() + ".html");
    fmt::print("Derivation: {}\n", shown_path(std::filesystem::exists(page) ? page : derivation));
  }
  return all_passed;
}

}  // namespace workbook
