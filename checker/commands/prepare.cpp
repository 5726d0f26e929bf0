#include "checker/commands/commands.hpp"

namespace workbook {

namespace {

int prepare(const Course& course) {
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

}  // namespace

Command prepare_command() {
  return {
      "prepare",
      students,
      "Build all that is otherwise built when it is first needed\n\nReference results, the commands, the notes, and "
      "the examples and figures of all lectures: before a journey, for example. It takes minutes.",
      {"prepare"},
      {},
      prepare};
}

}  // namespace workbook
