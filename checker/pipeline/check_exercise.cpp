#include "checker/pipeline/check_exercise.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"
#include "checker/compile/compile.hpp"
#include "checker/compile/source_findings.hpp"
#include "checker/explain/repair.hpp"
#include "checker/sandbox/diagnostic_run.hpp"
#include "checker/sandbox/run_exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace workbook {

namespace {

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

/// Adds findings, but no second one about a line that has been spoken of.
void add(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) {
    const bool is_new = std::ranges::none_of(findings, [&](const Finding& each) {
      return finding.line > 0 ? each.line == finding.line : each.sentence == finding.sentence;
    });
    if (is_new) findings.push_back(std::move(finding));
  }
}

/// True, but a consequence: of a reason that it does not name.
bool is_symptom(const Diagnosis& diagnosis) {
  return diagnosis.kind == DiagnosisKind::place || diagnosis.kind == DiagnosisKind::property ||
         diagnosis.kind == DiagnosisKind::dimension;
}

bool has_values(Verdict verdict) { return verdict == Verdict::wrong_value || verdict == Verdict::non_finite_value; }

Explanation explain(const CheckResult& checked, const CompileTask& compile_task, const Compilation& compilation,
                    const Toolchain& toolchain, const std::filesystem::path& cache, ExerciseRunner& runner) {
  Explanation explanation{checked.observation.findings, {}};
  const Verdict verdict = checked.judgement.verdict;
  if (verdict == Verdict::passed || verdict == Verdict::not_started || verdict == Verdict::checker_error)
    return explanation;
  const ExerciseReference& reference = *checked.reference;
  std::vector<Finding> in_code = source_findings(compile_task, compilation, toolchain, cache);
  const DiagnosticTask task{compile_task.submission, reference, checked.observation, checked.judgement};
  if (!has_values(verdict)) {
    add(explanation.findings, diagnostic_run(task, toolchain, cache));
    std::erase_if(in_code, is_remark);
    add(explanation.findings, std::move(in_code));
    return explanation;
  }
  // A slip of C++ that explains everything is not explained as physics.
  if (const auto decisive = decisive_finding(task, in_code, toolchain, cache)) {
    explanation.findings = {*decisive};
    return explanation;
  }
  explanation.diagnoses =
      diagnose(reference, answers_of(reference, checked.observation.replies),
               verdict == Verdict::wrong_value ? take_probes(runner, reference) : std::vector<UnitProbe>{});
  for (Diagnosis& diagnosis : explanation.diagnoses)
    if (diagnosis.notes.empty()) diagnosis.notes = checked.task.exercise.entry->notes;
  if (!std::ranges::all_of(explanation.diagnoses, is_symptom)) {
    add(explanation.findings, std::move(in_code));
    return explanation;
  }
  std::vector<Finding> deeper = diagnostic_run(task, toolchain, cache);
  if (!deeper.empty()) {
    explanation.diagnoses.clear();
  } else if (verdict == Verdict::wrong_value) {
    if (auto slip = slip_of_one_token(task, toolchain, cache)) deeper.push_back(std::move(*slip));
    if (!deeper.empty())
      std::erase_if(explanation.diagnoses, [](const Diagnosis& each) { return each.kind != DiagnosisKind::place; });
  }
  add(explanation.findings, std::move(deeper));
  add(explanation.findings, std::move(in_code));
  return explanation;
}

}  // namespace

std::string CheckResult::next_step() const {
  const bool is_explained = has_values(judgement.verdict) && !explanation.is_empty();
  return is_explained ? "Fix what the reason names, and check again." : judgement.next_step;
}

CheckTask check_task(const Course& course, const Exercise& exercise, std::uint64_t seed,
                     const std::optional<std::filesystem::path>& file) {
  const std::filesystem::path own = course.student_file(exercise);
  return {exercise, file.value_or(own), seed, file && *file != own};
}

CheckResult failed_check(const CheckTask& task, const std::string& reason) {
  CheckResult checked;
  checked.task = task;
  checked.observation.refusal = Refusal::checker_error;
  checked.observation.refusal_message = reason;
  checked.judgement = judge({}, checked.observation);
  return checked;
}

CheckResult check_exercise(const Course& course, const Toolchain& toolchain, const CheckTask& task,
                           const ExerciseReference& reference,
                           const std::function<void(const CheckResult&)>& on_verdict) {
  try {
    CheckResult checked;
    checked.task = task;
    checked.reference = &reference;
    const std::filesystem::path cache = course.scratch() / "compiled";
    if (!task.is_elsewhere && !std::filesystem::exists(task.file)) {
      checked.observation.replies.assign(reference.cases.size(), Reply{.ending = Ending::not_started});
      checked.judgement = judge(reference, checked.observation);
      checked.judgement.message = "You have not started this exercise: its file is missing.";
      checked.judgement.next_step = fmt::format("The file {} is missing: `{}` writes it.", shown_path(task.file),
                                                command("reset " + checked.name()));
      return checked;
    }
    const Submission submission = read_submission(task.file);
    checked.source = submission.text;
    const CompileTask compile_task{
        .submission = submission, .exercise = reference.name, .signature = reference.signature};
    const Compilation compilation = compile(compile_task, toolchain, cache);
    if (!compilation.executable) {
      checked.observation = refused(compilation);
      checked.judgement = judge(reference, checked.observation);
      checked.explanation.findings = checked.observation.findings;
      return checked;
    }
    checked.executable = *compilation.executable;
    ExerciseRunner runner(checked.executable);
    checked.observation = runner.observe(reference.cases, plan_repeats(reference));
    checked.observation.compile_seconds = compilation.seconds;
    checked.judgement = judge(reference, checked.observation);
    if (on_verdict && !checked.judgement.passed()) on_verdict(checked);
    checked.explanation = explain(checked, compile_task, compilation, toolchain, cache, runner);
    return checked;
  } catch (const RejectedFile& reason) {
    CheckResult checked = failed_check(task, reason.what());
    checked.observation.refusal = Refusal::rejected_file;
    checked.judgement = judge(reference, checked.observation);
    return checked;
  } catch (const std::exception& problem) {
    return failed_check(task, problem.what());
  }
}

}  // namespace workbook
