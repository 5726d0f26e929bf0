/// @file
/// Why a function failed: from the evidence to the reasons. What it says is a help and never a grade: no verdict
/// depends on it, and one that throws costs a reason.
#pragma once

#include "checker/compile/compile.hpp"
#include "checker/explain/diagnostic_run.hpp"
#include "checker/explain/values/diagnosis.hpp"

namespace workbook {

/// A file that was compiled, run and judged, and what it can be asked with.
struct Evidence {
  DiagnosticTask task;
  CompileTask compile_task;
  const Compilation& compilation;
  const Ask& ask;
  const Toolchain& toolchain;
  std::filesystem::path cache;
};

/// True where values came back of which some are wrong.
bool has_values(Verdict verdict);

/// The reasons, those in the code first.
/// @throws std::exception where what it needs cannot be had
std::vector<Reason> explain(const Evidence& evidence);

/// Of the reasons for a wrong answer to a problem leaves what a first try should be told, 1: where it fails, and what a
/// limit shows; a second one, 2: which components, inputs or regions. What names a term, a mistake or the
/// line is left for later tries. Slips of C++ stay.
void hold_back(std::vector<Reason>& reasons, int stage, const ExerciseReference& exercise, const Answers& answers);

/// A symptom: at how many cases, with a limit among them, or where it is right.
Reason where_it_fails(const ExerciseReference& exercise, const Answers& answers);

}  // namespace workbook
