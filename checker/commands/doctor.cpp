#include "checker/commands/commands.hpp"
#include "checker/explain/diagnostic_run.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <nlohmann/json.hpp>

#include <tuple>

namespace workbook {

namespace {

int doctor(const Course& course, const bool& is_json) {
  const Console console = Console::of_standard_output();
  bool can_check = true;
  nlohmann::json document = {{"format", 1}};
  const auto report = [&](bool good, const std::string& what, const std::string& detail) {
    document[what] = {{"good", good}, {"detail", detail}};
    if (is_json) return;
    const std::string mark = console.plain() ? (good ? "good: " : "not good: ")
                                             : console.mark(good ? "✓" : "✗", good ? Style::good : Style::bad);
    constexpr std::size_t indent = 15;
    fmt::print("{}{} {}\n", mark, padded(what, 12), console.wrapped(detail, indent).substr(indent));
  };

  try {
    const Toolchain toolchain = read_toolchain(course.toolchain_file());
    if (!course.exercises().empty()) require_complete(toolchain, course.exercises().front().name());
    const bool is_clang = toolchain.compiler.filename().string().find("clang") != std::string::npos;
    report(true, "compiler",
           toolchain.compiler.string() +
               (is_clang ? ": verdicts are the same; only its commonest messages are explained" : ""));
    const std::string missing = missing_for_diagnostic_runs(toolchain);
    report(missing.empty(), "reasons",
           missing.empty() ? "a function that fails is run again under the compiler's sanitizers to find its line"
                           : "a function that fails is not run again to find its line: missing are " + missing);
  } catch (const ToolchainError& problem) {
    can_check = false;
    report(false, "compiler", problem.what());
  }

  try {
    std::size_t made = 0;
    for (const Card& card : course.cards()) {
      if (course.has_solutions() && !fs::exists(course.reference_file(card.lecture))) continue;
      read_reference_results(course.reference_file(card.lecture));
      ++made;
    }
    report(true, "reference",
           fmt::format("results of {} of {}{}", made, plural(course.cards().size(), "lecture"),
                       made < course.cards().size() ? "; the others are made at their first check" : ""));
  } catch (const ReferenceError& problem) {
    can_check = false;
    report(false, "reference", problem.what());
  }

  const SandboxStrength sandbox = probe_sandbox();
  const bool is_full = sandbox.tier() >= SandboxTier::full;
  report(
      sandbox.tier() >= SandboxTier::reduced, "sandbox",
      sandbox.sentence() + (is_full ? "; this is for `grade`, single checks start quicker in the tier reduced" : ""));
  document["sandbox"].update({{"tier", to_string(sandbox.tier())},
                              {"filters_system_calls", sandbox.filters_system_calls},
                              {"landlock", sandbox.landlock},
                              {"namespaces", !sandbox.namespaces.empty()},
                              {"control_groups", !sandbox.control_groups.empty()}});

  for (const auto& [program, purpose, package] : {std::tuple{"gnuplot", "plots", "gnuplot-nox"},
                                                  {"gdb", "debug and try --case", "gdb"},
                                                  {"em++", "live figures", "emscripten"}}) {
    const std::string path = program_on_path(program);
    report(!path.empty(), program,
           path.empty()
               ? fmt::format("missing: checks work, {} do not (on Debian: apt-get install {})", purpose, package)
               : path);
  }

  const std::string root = course.root().string();
  const bool writable = access(root.c_str(), W_OK) == 0;
  report(writable, "folder",
         root + (writable ? " is writable" : " is not writable: progress and resets cannot be saved"));

  const auto notes = course.cards().empty() ? std::nullopt : course.notes_page(course.cards().front().lecture);
  report(notes.has_value(), "notes",
         notes ? notes->parent_path().string()
               : "not built as pages; read lectures/*/notes.md, or type: cmake --workflow --preset notes");

  report(true, "terminal", fmt::format("{} columns, {}", console.width(), console.color() ? "colour" : "no colour"));
  document["can_check"] = can_check;
  if (is_json) fmt::print("{}\n", document.dump(1));
  return can_check ? all_passed : checker_failed;
}

}  // namespace

Command doctor_command() {
  const auto options = std::make_shared<bool>();
  return {"doctor",
          students,
          "Check what is installed and writable on this machine",
          {},
          {{"--json", "", options.get(), "print one JSON document and nothing else"}},
          with_options(options, &doctor)};
}

}  // namespace workbook
