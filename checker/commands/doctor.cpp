#include "checker/commands/commands.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/messages/machine.hpp"
#include "checker/report/console.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace workbook {

namespace {

bool report(const Console& console, bool good, const std::string& what, const std::string& detail) {
  const std::string mark = console.plain() ? (good ? messages::good_mark() : messages::bad_mark())
                                           : console.mark(good ? "✓" : "✗", good ? Style::good : Style::bad);
  fmt::print("{}{} {}\n", mark, padded(what, 12), detail);
  return good;
}

}  // namespace

int doctor(const Course& course) {
  const Console console = Console::of_standard_output();
  bool well = true;

  try {
    const Toolchain toolchain = read_toolchain(course.toolchain_file());
    for (const Exercise& exercise : course.exercises()) require_complete(toolchain, exercise.name());
    report(console, true, messages::about_compiler(), toolchain.compiler.string());
  } catch (const ToolchainError& problem) {
    well = report(console, false, messages::about_compiler(), problem.what());
  }

  try {
    for (const Card& card : course.cards()) course.reference(card.lecture, 1);
    report(console, true, messages::about_reference(),
           messages::results_are_there(course.cards().size(), course.exercises().size()));
  } catch (const ReferenceError& problem) {
    well = report(console, false, messages::about_reference(), problem.what());
  }

  const SandboxStrength sandbox = sandbox_strength();
  report(console, sandbox.filters_system_calls, messages::about_sandbox(), sandbox.sentence);

  const std::string gnuplot = gnuplot_program();
  report(console, !gnuplot.empty(), messages::about_gnuplot(),
         gnuplot.empty() ? messages::gnuplot_is_missing() : gnuplot);

  const std::string root = course.root().string();
  const bool writable = access(root.c_str(), W_OK) == 0;
  report(console, writable, messages::about_folder(),
         writable ? messages::folder_is_writable(root) : messages::folder_is_not_writable(root));

  const auto notes = course.cards().empty() ? std::nullopt : course.notes_page(course.cards().front().lecture);
  report(console, notes.has_value(), messages::about_notes(),
         notes ? notes->parent_path().string() : messages::notes_are_not_built());

  report(console, true, messages::about_terminal(), messages::terminal_is(console.width(), console.color()));
  return well ? all_passed : checker_failed;
}

}  // namespace workbook
