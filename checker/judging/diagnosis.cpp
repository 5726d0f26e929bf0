#include "checker/judging/diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace workbook {

NLOHMANN_JSON_SERIALIZE_ENUM(DiagnosisKind, {{DiagnosisKind::misconception, "misconception"},
                                             {DiagnosisKind::term, "term"},
                                             {DiagnosisKind::transform, "transform"},
                                             {DiagnosisKind::input_transform, "input_transform"},
                                             {DiagnosisKind::difference, "difference"},
                                             {DiagnosisKind::split, "split"},
                                             {DiagnosisKind::independence, "independence"},
                                             {DiagnosisKind::entry, "entry"},
                                             {DiagnosisKind::place, "place"},
                                             {DiagnosisKind::property, "property"},
                                             {DiagnosisKind::dimension, "dimension"}})

std::string to_string(DiagnosisKind kind) { return nlohmann::json(kind).get<std::string>(); }

void to_json(nlohmann::json& json, const Diagnosis& diagnosis) {
  json = {
      {"kind", diagnosis.kind}, {"name", diagnosis.name}, {"message", diagnosis.message}, {"notes", diagnosis.notes}};
}

void from_json(const nlohmann::json& json, Diagnosis& diagnosis) {
  diagnosis = {json.at("kind"), json.at("name"), json.at("message"), json.at("notes")};
}

std::vector<Diagnosis> diagnose(const ExerciseReference& exercise, const Answers& answers,
                                const std::vector<UnitProbe>& probes) {
  for (const auto& mechanism : {diagnose_misconception, diagnose_terms, diagnose_transform, diagnose_input_transform}) {
    if (const auto diagnosis = mechanism(exercise, answers)) return {*diagnosis};
  }
  std::vector<Diagnosis> diagnoses;
  const auto place = diagnose_place(exercise, answers);
  for (const auto& mechanism :
       {diagnose_difference, diagnose_split, diagnose_conditional, diagnose_entries, diagnose_independence}) {
    if (const auto diagnosis = mechanism(exercise, answers)) {
      diagnoses.push_back(*diagnosis);
      break;
    }
  }
  if (diagnoses.empty()) {
    diagnoses = diagnose_properties(exercise, answers);
    std::ranges::move(diagnose_dimensions(exercise, answers, probes), std::back_inserter(diagnoses));
  }
  const bool place_is_named = !diagnoses.empty() && (diagnoses.front().kind == DiagnosisKind::difference ||
                                                     diagnoses.front().kind == DiagnosisKind::entry);
  if (place && !place_is_named) diagnoses.push_back(*place);
  return diagnoses;
}

}  // namespace workbook
