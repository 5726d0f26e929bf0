#include "checker/report/json_report.hpp"

#include <nlohmann/json.hpp>

namespace workbook {

namespace {

using nlohmann::ordered_json;

ordered_json inputs_of(const ExerciseReference& reference, const Case& failed) {
  ordered_json inputs = ordered_json::object();
  for (std::size_t i = 0; i < reference.arguments.size(); ++i) {
    inputs[reference.arguments[i].name] = to_json(failed.inputs[i], reference.arguments[i].kind);
  }
  return inputs;
}

ordered_json first_failure(const Checked& checked) {
  const ExerciseReference& reference = *checked.reference;
  const FirstFailure& failure = *checked.judgement.first_failure;
  const Case& failed = reference.cases[failure.case_index];
  ordered_json result;
  result["case"] = failed.name;
  result["inputs"] = inputs_of(reference, failed);
  result["expected"] = to_json(failed.expected, reference.result_kind);
  // A value of another shape than the contract's is told by its shape alone.
  if (failure.actual && failure.actual->has_shape_of(failed.expected)) {
    result["actual"] = to_json(*failure.actual, reference.result_kind);
  } else {
    result["actual"] = nullptr;
  }
  result["tolerance"] = failed.tolerance;
  return result;
}

ordered_json result_of(const Checked& checked) {
  const Judgement& judgement = checked.judgement;
  const double points = checked.exercise.entry->points;
  ordered_json result;
  result["lecture"] = checked.exercise.lecture();
  result["exercise"] = checked.exercise.name();
  result["verdict"] = to_string(judgement.verdict);
  // Trouble of our own is no zero: there is no score at all.
  result["score"] = judgement.verdict == Verdict::checker_error ? ordered_json(nullptr)
                                                                : ordered_json(judgement.passed() ? points : 0.0);
  result["points"] = points;
  result["cases"] = {{"passed", judgement.cases_passed}, {"total", judgement.cases_total}};
  result["message"] = judgement.message;
  result["diagnosis"] = ordered_json::array();
  for (const Diagnosis& diagnosis : judgement.diagnoses) {
    result["diagnosis"].push_back({{"kind", to_string(diagnosis.kind)},
                                   {"name", diagnosis.name},
                                   {"message", diagnosis.message},
                                   {"notes", diagnosis.notes}});
  }
  if (judgement.first_failure && checked.reference != nullptr) {
    result["first_failure"] = first_failure(checked);
  } else {
    result["first_failure"] = nullptr;
  }
  result["findings"] = ordered_json::array();
  for (const Finding& finding : checked.observation.findings) {
    result["findings"].push_back({{"line", finding.line}, {"excerpt", finding.excerpt}, {"message", finding.sentence}});
  }
  if (!checked.observation.printed.empty()) result["printed"] = checked.observation.printed;
  if (!checked.observation.refusal_details.empty()) result["details"] = checked.observation.refusal_details;
  result["seconds"] = {{"compile", checked.observation.compile_seconds}, {"run", checked.observation.run_seconds}};
  return result;
}

}  // namespace

nlohmann::ordered_json json_report(const std::vector<Checked>& results, std::uint64_t seed) {
  ordered_json document;
  document["format"] = 1;
  document["seed"] = seed;
  document["results"] = ordered_json::array();
  for (const Checked& checked : results) document["results"].push_back(result_of(checked));
  return document;
}

}  // namespace workbook
