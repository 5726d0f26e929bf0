#include "checker/commands/commands.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/report/console.hpp"
#include "checker/report/gnuplot_program.hpp"
#include "checker/worker/sandbox.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace workbook {

namespace {

bool report(const Console& console, bool good, const std::string& what, const std::string& detail) {
  const std::string mark = console.plain() ? (good ? "good: " : "not good: ")
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
    report(console, true, "compiler", toolchain.compiler.string());
  } catch (const ToolchainError& problem) {
    well = report(console, false, "compiler", problem.what());
  }

  try {
    for (const Card& card : course.cards()) course.reference(card.lecture, 1);
    report(console, true, "reference",
           fmt::format("results of {} lectures, {} exercises", course.cards().size(), course.exercises().size()));
  } catch (const ReferenceError& problem) {
    well = report(console, false, "reference", problem.what());
  }

  const SandboxStrength sandbox = sandbox_strength();
  report(console, sandbox.filters_system_calls, "sandbox", sandbox.sentence);

  const std::string gnuplot = gnuplot_program();
  report(console, !gnuplot.empty(), "gnuplot",
         gnuplot.empty() ? "missing: checks work, plots do not (on Debian: apt-get install gnuplot-nox)" : gnuplot);

  const bool writable = access(course.root().c_str(), W_OK) == 0;
  report(console, writable, "folder",
         fmt::format("{} {}", course.root().string(),
                     writable ? "is writable" : "is not writable: progress and resets cannot be saved"));

  const auto notes = course.cards().empty() ? std::nullopt : course.notes_page(course.cards().front().lecture);
  report(console, notes.has_value(), "notes",
         notes ? notes->parent_path().string()
               : "not built as pages; read lectures/*/notes.md, or build the target `notes`");

  report(console, true, "terminal",
         fmt::format("{} columns, {}", console.width(), console.color() ? "colour" : "no colour"));
  return well ? all_passed : checker_failed;
}

}  // namespace workbook
