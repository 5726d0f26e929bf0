#include "checker/judging/diagnosis.hpp"

#include "checker/judging/dimensions.hpp"
#include "checker/judging/misconceptions.hpp"
#include "checker/judging/properties.hpp"
#include "checker/judging/terms.hpp"
#include "checker/judging/transforms.hpp"

#include <algorithm>
#include <iterator>

namespace workbook {

std::vector<Diagnosis> diagnose(const ExerciseReference& exercise, const Answers& answers,
                                const std::vector<UnitProbe>& probes) {
  for (const auto& whole_explanation : {diagnose_misconception, diagnose_terms, diagnose_transform}) {
    if (const auto diagnosis = whole_explanation(exercise, answers)) return {*diagnosis};
  }
  std::vector<Diagnosis> diagnoses = diagnose_properties(exercise, answers);
  std::ranges::move(diagnose_dimensions(exercise, answers, probes), std::back_inserter(diagnoses));
  return diagnoses;
}

}  // namespace workbook
