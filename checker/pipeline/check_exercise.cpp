#include "checker/pipeline/check_exercise.hpp"

#include "checker/compile/compile.hpp"
#include "checker/compile/source_findings.hpp"
#include "checker/judging/dimensions.hpp"
#include "checker/judging/judge.hpp"
#include "checker/judging/sampling.hpp"
#include "checker/sandbox/diagnostic_run.hpp"

#include <algorithm>
#include <exception>
#include <iterator>

namespace workbook {

namespace {

Observation our_own_trouble(const std::string& sentence) {
  Observation observation;
  observation.refusal = Refusal::checker_error;
  observation.refusal_message = sentence;
  return observation;
}

/// What the function returns when the same inputs are given in smaller units.
std::vector<UnitProbe> take_probes(ExerciseRunner& runner, const ExerciseReference& reference) {
  std::vector<UnitProbe> probes = plan_probes(reference);
  for (UnitProbe& probe : probes) {
    std::vector<PlannedCall> calls;
    for (const std::size_t index : probe.case_indices) {
      const Case& probed = reference.cases[index];
      calls.push_back({probe_inputs(reference, probe, index), probed.expected.rows, probed.expected.cols});
    }
    probe.replies = runner.evaluate(calls);
  }
  return probes;
}

/// True if the function ran and something was wrong with it.
bool has_failed(const Checked& checked) {
  const Verdict verdict = checked.judgement.verdict;
  return checked.executable && verdict != Verdict::passed && verdict != Verdict::not_started &&
         verdict != Verdict::checker_error;
}

Observation observe(ExerciseRunner& runner, const ExerciseReference& reference) {
  Observation observation = runner.observe(reference.cases, plan_repeats(reference));
  if (judge(reference, observation).verdict == Verdict::wrong_value)
    observation.probes = take_probes(runner, reference);
  return observation;
}

/// Adds findings, but no second one about a line that has been spoken of.
void add(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) {
    const bool is_new = std::ranges::none_of(findings, [&](const Finding& each) {
      return finding.line > 0 ? each.line == finding.line : each.sentence == finding.sentence;
    });
    if (is_new) findings.push_back(std::move(finding));
  }
}

/// What can be found out about a failure beyond the verdict: first where it happens, then what in the file is suspect.
void look_closer(Checked& checked, const CompileTask& task, const Toolchain& toolchain,
                 const std::filesystem::path& compiled) {
  std::vector<Finding>& findings = checked.observation.findings;
  if (deserves_second_look(checked.judgement))
    add(findings,
        second_look({checked.file, *checked.reference, checked.observation, checked.judgement}, toolchain, compiled));
  if (has_failed(checked)) {
    const Depth depth = checked.judgement.diagnoses.empty() ? Depth::compiler : Depth::text;
    add(findings, source_findings(task, toolchain, compiled, depth));
  }
}

}  // namespace

Checked check_exercise(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                       const ExerciseReference& reference, const std::filesystem::path& file, const RunLimits& limits) {
  Checked checked{.exercise = exercise,
                  .file = file,
                  .is_elsewhere = file != course.student_file(exercise),
                  .seed = 1,
                  .reference = &reference,
                  .observation = {},
                  .judgement = {},
                  .executable = {}};
  const CompileTask task{.file = file, .exercise = exercise.name(), .signature = reference.signature};
  const std::filesystem::path compiled = course.scratch() / "compiled";
  try {
    const Compilation compilation = compile(task, toolchain, compiled);
    checked.executable = compilation.executable;
    if (compilation.executable) {
      ExerciseRunner runner(*compilation.executable, limits);
      checked.observation = observe(runner, reference);
      checked.observation.compile_seconds = compilation.seconds;
    } else {
      checked.observation = refused(compilation);
    }
  } catch (const std::exception& problem) {
    checked.observation = our_own_trouble(problem.what());
  }
  checked.judgement = judge(reference, checked.observation);
  look_closer(checked, task, toolchain, compiled);
  for (Diagnosis& diagnosis : checked.judgement.diagnoses) {
    if (diagnosis.notes.empty()) diagnosis.notes = exercise.entry->notes;  // the exercise's own paragraph
  }
  return checked;
}

}  // namespace workbook
