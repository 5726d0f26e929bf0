/// @file
/// Why a function failed, found out by running it again. The student's file is compiled once more, with the compiler's
/// sanitizers, and called with the inputs of a failing case. What that shows explains a verdict and never makes one.
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/judging/judge.hpp"
#include "checker/source/submission.hpp"

namespace workbook {

/// A file that was compiled, run and judged.
struct DiagnosticTask {
  const Submission& submission;
  const ExerciseReference& reference;
  const Observation& observation;
  const Judgement& judgement;
};

bool can_be_explained_by_a_run(const Judgement& judgement);

/// "" or what this machine lacks. Without Landlock and seccomp, a program that may read its libraries could read all
/// files.
std::string missing_for_diagnostic_runs(const Toolchain& toolchain);

/// What a run shows; nothing where it fails for whatever reason. Never throws.
/// @param scratch  a folder to work in; nothing is left there
std::vector<Reason> diagnostic_run(const DiagnosticTask& task, const Toolchain& toolchain,
                                   const std::filesystem::path& scratch);

/// The same with a program that was compiled for it. @throws LaunchError
std::vector<Reason> diagnostic_run_of(const std::filesystem::path& program, const DiagnosticTask& task,
                                      const Toolchain& toolchain);

/// Something that happened in the student's process.
struct DiagnosticEvent {
  std::string text;             ///< "NAME|FACT|…"
  std::vector<int> lines = {};  ///< of the student's file in the chain of calls, innermost first
  bool in_c_library = false;    ///< the innermost call is a function of C

  bool is(const std::string& name) const { return text == name || text.starts_with(name + "|"); }
  int line() const { return lines.empty() ? 0 : lines.front(); }
};

/// What the worker printed. @param file_name  under which the student's file was compiled
std::vector<DiagnosticEvent> read_report(const std::string& text, const std::string& file_name);

}  // namespace workbook
