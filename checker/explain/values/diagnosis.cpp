#include "checker/explain/values/diagnosis.hpp"

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
                                             {DiagnosisKind::accuracy, "accuracy"},
                                             {DiagnosisKind::learnt, "learnt"},
                                             {DiagnosisKind::property, "property"},
                                             {DiagnosisKind::dimension, "dimension"}})

std::string to_string(DiagnosisKind kind) { return nlohmann::json(kind).get<std::string>(); }

void to_json(nlohmann::json& document, const Diagnosis& diagnosis) {
  document = {
      {"kind", diagnosis.kind}, {"name", diagnosis.name}, {"message", diagnosis.message}, {"notes", diagnosis.notes}};
}

void from_json(const nlohmann::json& document, Diagnosis& diagnosis) {
  diagnosis = {document.at("kind"), document.at("name"), document.at("message"), document.at("notes")};
}

bool Diagnosis::is_symptom() const {
  // A wrong order or range is all that there is to say.
  if (kind == DiagnosisKind::property) return name != "range" && name != to_string(PropertyKind::ascending);
  return kind == DiagnosisKind::place || kind == DiagnosisKind::accuracy || kind == DiagnosisKind::dimension ||
         kind == DiagnosisKind::independence || name == "zero" || (kind == DiagnosisKind::split && name != "split");
}

namespace {

/// What is wrong beside numbers that are right to four digits only, as those of an integration in large steps.
std::optional<Diagnosis> diagnose_coarsely(ExerciseReference exercise, const Answers& answers) {
  constexpr double coarse = 1e-4;
  constexpr std::size_t fewest = 5;
  for (Case& one : exercise.cases) one.tolerance = std::max(one.tolerance, coarse);
  if (outcomes_of(exercise, answers).wrong.size() < fewest) return std::nullopt;
  for (const auto& mechanism :
       {diagnose_misconception, diagnose_transform, diagnose_input_transform, diagnose_whole_turns}) {
    std::optional<Diagnosis> found = mechanism(exercise, answers);
    if (!found) continue;
    found->message += " (As far as your numbers show it, which is to about four digits; more are asked for.)";
    return found;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Diagnosis> diagnose(const ExerciseReference& exercise, const Answers& answers,
                                const std::vector<UnitProbe>& probes) {
  for (const auto& mechanism : {diagnose_range, diagnose_misconception, diagnose_terms, diagnose_transform,
                                diagnose_input_transform, diagnose_factor, diagnose_whole_turns, diagnose_wrong_part}) {
    if (const auto diagnosis = mechanism(exercise, answers)) return {*diagnosis};
  }
  std::vector<Diagnosis> diagnoses;
  // What is nearly right everywhere has no wrong dimension, sign or place.
  if (const auto accuracy = diagnose_accuracy(exercise, answers)) {
    if (const auto difference = diagnose_difference(exercise, answers)) return {*difference};
    return {*accuracy};
  }
  if (const auto coarse = diagnose_coarsely(exercise, answers)) return {*coarse};
  const auto invariant = diagnose_invariant(exercise, answers);
  const auto place = invariant ? invariant : diagnose_place(exercise, answers);
  for (const auto& mechanism : {diagnose_eigenvectors, diagnose_difference, diagnose_split, diagnose_conditional,
                                diagnose_entries, diagnose_few, diagnose_one_side}) {
    if (const auto diagnosis = mechanism(exercise, answers)) {
      diagnoses.push_back(*diagnosis);
      break;
    }
  }
  if (std::ranges::all_of(diagnoses, [](const Diagnosis& each) { return each.name == "one_side"; })) {
    std::ranges::move(diagnose_properties(exercise, answers), std::back_inserter(diagnoses));
    // What is in the wrong order may change its order with the units; that says nothing of dimensions.
    const auto is_order = [](const Diagnosis& each) { return each.name == to_string(PropertyKind::ascending); };
    if (std::ranges::none_of(diagnoses, is_order))
      std::ranges::move(diagnose_dimensions(exercise, answers, probes), std::back_inserter(diagnoses));
  }
  // Values in another order have no direction.
  const bool is_unsorted = std::ranges::count(diagnoses, to_string(PropertyKind::ascending), &Diagnosis::name) > 0;
  const bool place_is_named =
      is_unsorted || (!diagnoses.empty() && (diagnoses.front().kind == DiagnosisKind::difference ||
                                             diagnoses.front().kind == DiagnosisKind::entry));
  if (place && !place_is_named) diagnoses.push_back(*place);
  return diagnoses;
}

}  // namespace workbook
