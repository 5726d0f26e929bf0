#include "checker/explain/explain.hpp"

#include "checker/base/text.hpp"
#include "checker/explain/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

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

/// A mistake after which a statement does something else than it seems to: what comes of it is no physics.
bool spoils_values(const Finding& finding) {
  static const std::set<std::string> names = {
      "always_true",  "assignment_in_condition", "chained_comparison", "comma_in_number",  "degrees_literal",
      "empty_body",   "discarded_result",        "fall_through",       "integer_division", "misleading_indentation",
      "unused_value", "shadowed_variable",       "unclear_order",      "whole_sum",        "xor_for_power",
      "rounded_pi",   "uninitialized_variable"};
  return names.contains(finding.name);
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

/// Does what tells wrong cases from right ones also tell the points of the plot from each other? By coincidence of the
/// cases it would not.
bool is_confirmed(const Diagnosis& split, const Ask& ask, ExerciseReference exercise, Answers answers) {
  const auto claim = [](const std::string& message) { return message.substr(0, message.find(" (")); };
  std::vector<PlannedCall> calls;
  double size = 0;
  for (std::size_t i = 0; i < exercise.sweep.x.size(); ++i) {
    const Value& expected = exercise.sweep.expected[i];
    calls.push_back({exercise.sweep.inputs[i], expected.rows, expected.cols});
    size = std::max(size, as_matrix(expected).cwiseAbs().maxCoeff());
  }
  const std::vector<Reply> replies = calls.empty() ? std::vector<Reply>() : ask(calls);
  for (std::size_t i = 0; i < replies.size(); ++i) {
    Case point = exercise.cases.front();
    point.inputs = exercise.sweep.inputs[i];
    point.expected = exercise.sweep.expected[i];
    point.scale = {size};
    if (!has_usable_value(replies[i], point)) continue;
    exercise.cases.push_back(point);
    answers.push_back(replies[i].value);
  }
  const std::optional<Diagnosis> again = diagnose_split(exercise, answers);
  return again && claim(again->message) == claim(split.message);
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

bool are_zero(const Answers& answers) {
  return std::ranges::all_of(answers, [](const std::optional<Value>& answer) {
    return answer && std::ranges::all_of(answer->numbers, [](double number) { return number == 0; });
  });
}

/// With which elements of a list the result never changes, although the right one does: further calls tell.
std::optional<Diagnosis> elements_without_effect(const Ask& ask, const ExerciseReference& reference,
                                                 const Answers& answers) {
  struct Pattern {
    const char* words;
    bool (*has_effect)(std::size_t element, std::size_t count);
  };
  static constexpr Pattern patterns[] = {
      {"any entry of {} but the first", [](std::size_t k, std::size_t) { return k == 0; }},
      {"any entry of {} but the first two", [](std::size_t k, std::size_t) { return k < 2; }},
      {"any entry of {} but the last", [](std::size_t k, std::size_t n) { return k + 1 == n; }},
      {"any entry of {} but the first and the last", [](std::size_t k, std::size_t n) { return k == 0 || k + 1 == n; }},
      {"the first entry of {}", [](std::size_t k, std::size_t) { return k > 0; }},
      {"the last entry of {}", [](std::size_t k, std::size_t n) { return k + 1 < n; }}};
  constexpr std::size_t fewest = 3, most = 40, most_cases = 3;
  for (std::size_t a = 0; a < reference.arguments.size(); ++a) {
    const auto columns = [&](std::size_t i) -> std::size_t {
      const Value& list = reference.cases[i].inputs[a];
      const Kind kind = reference.arguments[a].kind;
      return kind == Kind::vector     ? list.numbers.size()
             : kind == Kind::points   ? static_cast<std::size_t>(list.cols)
             : kind == Kind::matrices ? static_cast<std::size_t>(list.cols) / 3
                                      : 0;
    };
    std::vector<Pattern> fitting(std::begin(patterns), std::end(patterns));
    std::size_t looked_at = 0;
    for (std::size_t i = 0; i < reference.described_cases() && looked_at < most_cases; ++i) {
      const Case& one = reference.cases[i];
      const std::size_t count = columns(i), stride = count > 0 ? one.inputs[a].numbers.size() / count : 0;
      if (count < fewest || count > most || !answers[i] || passes(reference, i, *answers[i]) ||
          std::ranges::count(one.inputs[a].numbers, 0) > 0)  // what is 0 stays so
        continue;
      ++looked_at;
      std::vector<PlannedCall> calls(count, {one.inputs, one.expected.rows, one.expected.cols});
      for (std::size_t k = 0; k < count * stride; ++k) calls[k / stride].inputs[a].numbers[k] *= 1.01;
      const std::vector<Reply> replies = ask(calls);
      std::erase_if(fitting, [&](const Pattern& pattern) {
        for (std::size_t k = 0; k < count; ++k) {
          const bool is_same = replies[k].ending == Ending::returned && replies[k].value.numbers == answers[i]->numbers;
          if (is_same == pattern.has_effect(k, count)) return true;
        }
        return false;
      });
    }
    const auto right_one_changes = [&](const Case& changed) {
      if (changed.base < 0 || changed.argument != static_cast<int>(a)) return false;
      const auto base = static_cast<std::size_t>(changed.base);
      return !is_same_answer(reference, base, changed.expected, reference.cases[base].expected);
    };
    if (looked_at > 0 && !fitting.empty() && std::ranges::any_of(reference.cases, right_one_changes))
      return Diagnosis{DiagnosisKind::independence, "elements",
                       fmt::format("Your result never changes with {}; the right one does.",
                                   fmt::format(fmt::runtime(fitting.front().words), reference.arguments[a].name))};
  }
  return std::nullopt;
}

/// Findings that explain a few cases only.
std::vector<Finding> besides(std::vector<Finding> findings) {
  for (Finding& finding : findings)
    finding.sentence = "Besides, at the cases without a finite number: " + finding.sentence;
  return findings;
}

/// A limit at which it fails, or else the first case; and where it is right.
Diagnosis where_it_fails(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t most_named = 3;
  const Outcomes outcomes = outcomes_of(exercise, answers);
  std::vector<std::string> right;
  for (const std::size_t index : outcomes.right)
    if (const std::string name = fmt::format("“{}”", exercise.cases[index].name);
        index < exercise.described_cases() && right.size() < most_named && std::ranges::count(right, name) == 0)
      right.push_back(name);
  std::string sentence = fmt::format("It is wrong at {} of {}", outcomes.wrong.size(),
                                     plural(outcomes.wrong.size() + outcomes.right.size(), "case"));
  const auto limit = std::ranges::find_if(
      exercise.limits, [&](const Limit& each) { return std::ranges::count(outcomes.wrong, each.case_index) > 0; });
  if (limit != exercise.limits.end())
    sentence += fmt::format(", the limit “{}” among them: what must come out there without any formula?",
                            exercise.cases[limit->case_index].name);
  else
    sentence += right.empty() ? "." : ", and right at " + listed(right) + ".";
  return {DiagnosisKind::place, "where",
          sentence + " The reason is named at the third try with a changed file, or after a hint."};
}

/// Where the values tell symptoms only.
void explain_deeper(Explanation& explanation, const Evidence& evidence, bool has_mistake_in_code,
                    const Answers& answers) {
  const DiagnosticTask& task = evidence.task;
  std::vector<Diagnosis>& diagnoses = explanation.diagnoses;
  const auto is_place = [](const Diagnosis& each) { return each.kind == DiagnosisKind::place; };
  const bool is_inaccurate = std::ranges::any_of(
      diagnoses, [](const Diagnosis& each) { return each.kind == DiagnosisKind::accuracy && each.name != "near"; });
  if (task.judgement.verdict == Verdict::wrong_value) {
    if (const auto slip = slip_or_branch(task, evidence.toolchain, evidence.cache, is_inaccurate)) {
      std::erase_if(diagnoses, [&](const Diagnosis& each) {
        return each.kind != DiagnosisKind::split && (each.kind != DiagnosisKind::accuracy || each.name == "near");
      });
      return add(explanation.findings, {*slip});
    }
  }
  if (is_inaccurate) {
    // A float or a π of few digits is reason enough.
    if (has_mistake_in_code) diagnoses.clear();
    return;
  }
  std::vector<Finding> deeper = diagnostic_run(task, evidence.toolchain, evidence.cache);
  if (!deeper.empty()) {
    diagnoses.clear();
    return add(explanation.findings, std::move(deeper));
  }
  // Where a mistake in the code is known, its consequences are none of physics.
  if (has_mistake_in_code) std::erase_if(diagnoses, std::not_fn(is_place));
  if (task.judgement.verdict != Verdict::wrong_value || has_mistake_in_code) return;
  if (are_zero(answers)) return;
  const auto inputs = confirmed(independent_inputs(task.reference, answers), evidence.ask, task.reference, answers);
  const auto found = inputs.size() <= 6 ? independence(task.reference, inputs) : std::nullopt;
  if (found) diagnoses.insert(diagnoses.begin(), *found);
  if (const auto list = elements_without_effect(evidence.ask, task.reference, answers))
    diagnoses.insert(diagnoses.begin(), *list);
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
    std::erase_if(in_code, is_remark);
    // Of a line that is known to be wrong, the run may only tell what comes of it.
    std::vector<Finding> met = diagnostic_run(task, toolchain, cache);
    std::erase_if(met, [&](const Finding& finding) {
      if (finding.name == "missing_return") return std::ranges::count(in_code, finding.name, &Finding::name) > 0;
      return finding.name == "endless_loop" && std::ranges::count(in_code, finding.line, &Finding::line) > 0;
    });
    add(explanation.findings, std::move(met));
    add(explanation.findings, std::move(in_code));
    return explanation;
  }
  // A slip of C++ is not explained as physics.
  const Answers answers = answers_of(task.reference, task.observation.replies);
  CodeReasons code = code_reasons(task, in_code, toolchain, cache);
  if (code.findings.empty()) {
    code = code_reasons(task, whole_quotients(SourceText(task.submission.text), task.reference), toolchain, cache);
    // Many a quotient of whole numbers is meant so: it is a mistake where all is right without it, or all zero with it.
    if (!code.are_all && !are_zero(answers)) code.findings.clear();
  }
  if (!code.findings.empty()) {
    explanation.findings = code.findings;
    if (!code.are_all) add(explanation.findings, std::move(in_code));
    return explanation;
  }
  // Values that are the same in a new process do not depend on earlier calls.
  std::erase_if(in_code, [](const Finding& finding) { return finding.name == "static_variable"; });
  if (std::ranges::any_of(in_code, spoils_values)) {
    explanation.findings = std::move(in_code);
    return explanation;
  }
  const bool has_mistake_in_code = !std::ranges::all_of(in_code, is_remark);
  if (task.judgement.verdict == Verdict::non_finite_value) {
    explanation.diagnoses = diagnose_finite(task.reference, answers);
    if (!explanation.diagnoses.empty()) add(explanation.findings, besides(diagnostic_run(task, toolchain, cache)));
  } else {
    explanation.diagnoses = diagnose(task.reference, answers, take_probes(evidence.ask, task.reference));
  }
  std::erase_if(explanation.diagnoses, [&](const Diagnosis& each) {
    return each.kind == DiagnosisKind::split && each.name == "split" &&
           !is_confirmed(each, evidence.ask, task.reference, answers);
  });
  if (std::ranges::all_of(explanation.diagnoses, &Diagnosis::is_symptom))
    explain_deeper(explanation, evidence, has_mistake_in_code, answers);
  add(explanation.findings, std::move(in_code));
  return explanation;
}

void hold_back(Explanation& explanation, int stage, const ExerciseReference& exercise, const Answers& answers) {
  using enum DiagnosisKind;
  const std::set<DiagnosisKind> at_once = {dimension, accuracy, property, learnt};
  const std::set<DiagnosisKind> second = {split, independence, entry, place};
  const auto is_told = [&](DiagnosisKind kind) {
    return at_once.contains(kind) || (stage > 1 && second.contains(kind));
  };
  const std::size_t found = explanation.findings.size() + explanation.diagnoses.size();
  // An argument without effect is a region too.
  std::erase_if(explanation.findings,
                [&](const Finding& each) { return each.name.starts_with("slip_") || (stage == 1 && is_remark(each)); });
  std::erase_if(explanation.diagnoses, [&](const Diagnosis& each) { return !is_told(each.kind); });
  if (explanation.findings.size() + explanation.diagnoses.size() == found) return;
  const auto tells_nothing = [&] {
    return explanation.diagnoses.empty() && std::ranges::all_of(explanation.findings, is_remark);
  };
  if (stage > 1 && tells_nothing())
    for (Mechanism* const mechanism : {&diagnose_split, &diagnose_one_side, &diagnose_place, &diagnose_few})
      if (const auto region = mechanism(exercise, answers); region && is_told(region->kind)) {
        explanation.diagnoses = {*region};
        break;
      }
  if (tells_nothing()) explanation.diagnoses = {where_it_fails(exercise, answers)};
}

}  // namespace workbook
