#include "checker/explain/explain.hpp"

#include "checker/explain/repair.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace workbook {

namespace {

/// What the function returns when the same inputs are given in smaller units.
std::vector<UnitProbe> take_probes(const Ask& ask, const ExerciseReference& reference) {
  std::vector<UnitProbe> probes = plan_probes(reference);
  for (UnitProbe& probe : probes) {
    std::vector<PlannedCall> calls;
    for (const std::size_t index : probe.case_indices) {
      const Case& probed = reference.cases[index];
      calls.push_back({probe_inputs(reference, probe, index), probed.expected.rows, probed.expected.cols});
    }
    probe.replies = ask(calls);
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

/// The inputs of which further calls confirm that they never change the result: at other cases, by other amounts.
std::vector<IndependentInput> confirmed(std::vector<IndependentInput> inputs, const Ask& ask,
                                        const ExerciseReference& reference, const Answers& answers) {
  constexpr std::size_t most_cases = 12;
  std::vector<std::size_t> all(reference.described_cases());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<std::size_t> cases = evenly_spaced(all, most_cases);
  std::erase_if(inputs, [&](const IndependentInput& input) {
    return std::ranges::any_of(cases, [&](std::size_t index) {
      if (!answers[index] || !answers[index]->is_finite()) return true;
      const Case& one = reference.cases[index];
      if (input.entry >= one.inputs[input.argument].numbers.size()) return false;  // a shorter list
      std::vector<PlannedCall> calls;
      for (const double factor : {0.0, -0.6, 1e-2, 1.9, 40.0}) {
        calls.push_back({one.inputs, one.expected.rows, one.expected.cols});
        std::vector<double>& numbers = calls.back().inputs[input.argument].numbers;
        const double number = numbers[input.entry], changed = number == 0 ? factor : number * factor;
        // A symmetric matrix stays one.
        if (const std::size_t mirror = input.entry % 3 * 3 + input.entry / 3;
            reference.arguments[input.argument].kind == Kind::matrix3 && numbers[mirror] == number)
          numbers[mirror] = changed;
        numbers[input.entry] = changed;
      }
      return std::ranges::any_of(ask(calls), [&](const Reply& reply) {
        return reply.ending == Ending::returned && reply.value.numbers != answers[index]->numbers;
      });
    });
  });
  return inputs;
}

/// Why finite values are wrong, where others are not finite: one cause of the former is not silenced by the latter.
/// Empty where values that are finite are right, or too few, or where nothing is certain.
std::vector<Diagnosis> diagnose_finite(ExerciseReference exercise, Answers answers) {
  std::size_t finite = 0, wrong = 0;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (answers[i] && answers[i]->is_finite()) {
      ++finite;
      wrong += passes(exercise, i, *answers[i]) ? 0 : 1;
    } else {
      exercise.cases[i].deciding = false;
      answers[i].reset();
    }
  }
  if (2 * finite < exercise.cases.size() || 4 * wrong < finite) return {};
  std::vector<Diagnosis> found = diagnose(exercise, answers, {});
  if (std::ranges::all_of(found, &Diagnosis::is_symptom)) found.clear();
  return found;
}

/// Findings that explain a few cases only.
std::vector<Finding> besides(std::vector<Finding> findings) {
  for (Finding& finding : findings)
    finding.sentence = "Besides, at the cases without a finite number: " + finding.sentence;
  return findings;
}

/// Where the values tell symptoms only.
void explain_deeper(Explanation& explanation, const Evidence& evidence, bool has_mistake_in_code,
                    const Answers& answers) {
  const DiagnosticTask& task = evidence.task;
  std::vector<Diagnosis>& diagnoses = explanation.diagnoses;
  std::vector<Finding> deeper = diagnostic_run(task, evidence.toolchain, evidence.cache);
  if (!deeper.empty()) {
    diagnoses.clear();
    return add(explanation.findings, std::move(deeper));
  }
  // Where a mistake in the code is known, its consequences are none of physics.
  const auto is_place = [](const Diagnosis& each) { return each.kind == DiagnosisKind::place; };
  if (has_mistake_in_code) std::erase_if(diagnoses, std::not_fn(is_place));
  if (task.judgement.verdict != Verdict::wrong_value) return;
  const auto slip = slip_or_branch(task, evidence.toolchain, evidence.cache);
  if (slip) {
    std::erase_if(diagnoses, [&](const Diagnosis& each) {
      return each.kind != DiagnosisKind::split && (slip->name == "branch" || !is_place(each));
    });
    add(explanation.findings, {*slip});
  } else if (!has_mistake_in_code) {
    const auto inputs = confirmed(independent_inputs(task.reference, answers), evidence.ask, task.reference, answers);
    const auto found = inputs.size() <= 6 ? independence(task.reference, inputs) : std::nullopt;
    if (found) diagnoses.insert(diagnoses.begin(), *found);
  }
}

}  // namespace

bool has_values(Verdict verdict) { return verdict == Verdict::wrong_value || verdict == Verdict::non_finite_value; }

Explanation explain(const Evidence& evidence) {
  const DiagnosticTask& task = evidence.task;
  const Toolchain& toolchain = evidence.toolchain;
  const std::filesystem::path& cache = evidence.cache;
  Explanation explanation{task.observation.findings, {}};
  std::vector<Finding> in_code = source_findings(evidence.compile_task, evidence.compilation, toolchain, cache);
  if (!has_values(task.judgement.verdict)) {
    add(explanation.findings, diagnostic_run(task, toolchain, cache));
    std::erase_if(in_code, is_remark);
    add(explanation.findings, std::move(in_code));
    return explanation;
  }
  // A slip of C++ is not explained as physics.
  const CodeReasons code = code_reasons(task, in_code, toolchain, cache);
  if (!code.findings.empty()) {
    explanation.findings = code.findings;
    if (!code.are_all) add(explanation.findings, std::move(in_code));
    return explanation;
  }
  const bool has_mistake_in_code = !std::ranges::all_of(in_code, is_remark);
  const bool has_no_value = std::ranges::count(in_code, "uninitialized_variable", &Finding::name) > 0;
  const Answers answers = answers_of(task.reference, task.observation.replies);
  if (task.judgement.verdict == Verdict::non_finite_value && !has_no_value) {
    explanation.diagnoses = diagnose_finite(task.reference, answers);
    if (!explanation.diagnoses.empty()) add(explanation.findings, besides(diagnostic_run(task, toolchain, cache)));
  } else if (!has_no_value) {
    explanation.diagnoses = diagnose(task.reference, answers, take_probes(evidence.ask, task.reference));
  }
  if (std::ranges::all_of(explanation.diagnoses, &Diagnosis::is_symptom))
    explain_deeper(explanation, evidence, has_mistake_in_code, answers);
  add(explanation.findings, std::move(in_code));
  return explanation;
}

}  // namespace workbook
