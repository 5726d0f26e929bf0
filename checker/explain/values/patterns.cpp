// Where an answer is wrong, and what that has in common: cases, components, inputs.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace workbook {

std::set<std::size_t> wrong_entries(const ExerciseReference& exercise, const Answers& answers) {
  std::set<std::size_t> wrong;
  const Value& shape = exercise.cases.front().expected;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!exercise.cases[i].expected.has_shape_of(shape)) return {};
    if (!answers[i]) continue;
    const Deviation deviation = deviations(exercise, i, *answers[i]).front();
    if (!deviation.is_entrywise) return {};
    for (std::size_t n = 0; n < shape.numbers.size(); ++n) {
      if (!deviation.is_within(n)) wrong.insert(n);
    }
  }
  return wrong;
}

std::optional<Reason> diagnose_place(const ExerciseReference& exercise, const Answers& answers) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  const Value& shape = exercise.cases.front().expected;
  const Outcomes outcome = outcomes_of(exercise, answers);
  const bool are_products = exercise.result_kind == Kind::matrix3 && wrong == std::set<std::size_t>{1, 2, 3, 5, 6, 7};
  if (wrong.empty() || wrong.size() == shape.numbers.size() || (wrong.size() > 4 && !are_products)) return std::nullopt;
  // At a few special inputs the other components may be right by accident.
  constexpr std::size_t fewest = 5;
  if (outcome.wrong.size() < fewest && !outcome.right.empty()) return std::nullopt;
  std::vector<std::string> names;
  for (const std::size_t n : wrong) names.push_back(entry_name(shape, exercise.result_kind, n));
  const std::string where = outcome.right.empty() && outcome.wrong.size() == 1 ? "at the only case"
                            : outcome.right.empty()
                                ? fmt::format("at all {}", plural(outcome.wrong.size(), "case"))
                                : fmt::format("at {} of {}", outcome.wrong.size(),
                                              plural(outcome.right.size() + outcome.wrong.size(), "case"));
  return Reason{ReasonKind::place, "place",
                fmt::format("Only {} {} wrong, {}; all other numbers are right everywhere.",
                            are_products ? "the entries off the diagonal" : listed(names),
                            wrong.size() == 1 ? "is" : "are", where),
                Weight::symptom};
}

std::optional<Reason> diagnose_along(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t fewest = 8;
  constexpr double exactness = 1e-7, clearly_oblique = 1e-2;
  if ((exercise.result_kind != Kind::vector3 && exercise.result_kind != Kind::points) ||
      exercise.comparison != Comparison::plain || !all_deciding_cases_answered(exercise, answers))
    return std::nullopt;
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    if (exercise.arguments[a].kind != Kind::vector3) continue;
    std::size_t wrong = 0, oblique = 0;  // columns, and those that are not along the input themselves
    const auto is_along = [&](std::size_t i) {
      const Case& one = exercise.cases[i];
      if (!answers[i]->is_finite() || !answers[i]->has_shape_of(one.expected)) return false;
      const Eigen::Vector3d input = as_matrix(one.inputs[a]).col(0).normalized();
      const Eigen::MatrixXd right = as_matrix(one.expected), error = as_matrix(*answers[i]) - right;
      for (Eigen::Index k = 0; k < error.cols(); ++k) {
        const Eigen::Vector3d off = error.col(k), expected = right.col(k);
        if (off.cross(input).norm() > exactness * (off.norm() + expected.norm())) return false;
        if (off.norm() <= exactness * expected.norm()) continue;
        ++wrong;
        const bool has_one_number = (input.array() != 0).count() == 1;
        if (!has_one_number && expected.cross(input).norm() > clearly_oblique * expected.norm()) ++oblique;
      }
      return true;
    };
    if (!std::ranges::all_of(deciding_cases(exercise), is_along) || wrong < fewest || oblique < fewest) continue;
    return Reason{
        ReasonKind::difference, "along",
        fmt::format("Your result is wrong only by a vector along {0}, at every case: all that is perpendicular "
                    "to {0} is right.",
                    exercise.arguments[a].name),
        Weight::possible};
  }
  return std::nullopt;
}

std::optional<Reason> diagnose_no_effect(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t fewest = 3, most_named = 5;
  const bool has_few_results = exercise.result_kind == Kind::integer;  // of which many changes leave the right one
  std::size_t all = 0, all_changes = 0;  // pairs of cases, and those at which the right result changes
  // Of an argument, or of one number of it.
  const auto has_none = [&](std::size_t a, std::optional<std::size_t> entry) {
    std::size_t pairs = 0, changes = 0;
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      const Case& one = exercise.cases[i];
      const auto base = static_cast<std::size_t>(one.base);
      if (one.base < 0 || !std::cmp_equal(one.argument, a) || (entry && !std::cmp_equal(one.entry, *entry))) continue;
      if (!answers[i] || !answers[base] || answers[i]->numbers != answers[base]->numbers) return false;
      changes += is_same_answer(exercise, base, one.expected, exercise.cases[base].expected) ? 0 : 1;
      ++pairs;
    }
    if (changes < (has_few_results ? 1 : fewest)) return false;
    all += pairs;
    all_changes += changes;
    return true;
  };
  std::vector<std::string> names;
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    const auto& [name, kind, unit] = exercise.arguments[a];
    if (has_none(a, std::nullopt)) {
      names.push_back(name);
      continue;
    }
    if (kind != Kind::vector2 && kind != Kind::vector3 && kind != Kind::matrix3) continue;
    std::vector<std::size_t> column;  // of a matrix
    for (std::size_t n = 0; n < exercise.cases.front().inputs[a].numbers.size(); ++n) {
      if (n % 3 == 0) column.clear();
      if (!has_none(a, n)) continue;
      column.push_back(n);
      names.push_back(name + entry_suffix(kind, n));
      if (kind != Kind::matrix3 || column.size() < 3) continue;
      names.resize(names.size() - column.size());
      names.push_back(fmt::format("{}.col({})", name, n / 3));
    }
  }
  if (all_changes < fewest || names.size() > most_named) return std::nullopt;
  return Reason{
      ReasonKind::independence, "no_effect",
      fmt::format("Your result never changes with {} (at {} where nothing else changes); the right one does{}.",
                  listed(names), plural(all, "pair of cases", "pairs of cases"),
                  2 * all_changes < all ? fmt::format(" at {} of them", all_changes) : ""),
      Weight::symptom};
}

std::optional<Reason> diagnose_accuracy(const ExerciseReference& exercise, const Answers& answers) {
  constexpr double largest = 1e-2, single_precision = 1e-6;
  constexpr std::size_t fewest = 5;
  std::vector<std::pair<std::size_t, double>> errors;  // of the wrong cases, in natural sizes
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i] || !answers[i]->is_finite()) return std::nullopt;
    double error = 0;
    for (const Deviation& each : deviations(exercise, i, *answers[i])) error = std::max(error, each.relative_size());
    if (error > largest) return std::nullopt;
    if (!passes(exercise, i, *answers[i])) errors.emplace_back(i, error);
  }
  if (errors.size() < fewest || 4 * errors.size() < exercise.cases.size()) return std::nullopt;
  const double worst = std::ranges::max(errors, {}, &std::pair<std::size_t, double>::second).second;
  // An error of a calculation follows a law; without one, as much may be a small term that is wrong or missing.
  std::vector<std::string> grows_with;
  for (const Quantity& quantity : quantities_of(exercise)) {
    const auto size_at = [&](const auto& error) { return std::abs(quantity.values[error.first]); };
    std::vector<std::pair<std::size_t, double>> ordered = errors;
    std::ranges::stable_sort(ordered, {}, size_at);
    const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
    const auto error_of = &std::pair<std::size_t, double>::second;
    if (quantity.unit == units::second && size_at(ordered.front()) < size_at(*middle) &&
        std::ranges::max_element(ordered.begin(), middle, {}, error_of)->second * 3 <
            std::ranges::max_element(middle, ordered.end(), {}, error_of)->second)
      grows_with.push_back(quantity.name);
  }
  std::string law;
  if (!grows_with.empty())
    law = fmt::format(" The error grows with {}, as that of steps that are too large does.", listed(grows_with));
  else if (worst < single_precision)
    law = " A `float` has so many, and so has a constant or a step of about that accuracy.";
  else
    return Reason{ReasonKind::accuracy, "near",
                  fmt::format("Your result is nearly right: it differs by less than {} % of its size at every case. "
                              "Either a small term is wrong or missing, or the calculation is too coarse.",
                              number_text(std::ceil(1000 * worst) / 10, 2)),
                  Weight::symptom};
  const std::string sentence =
      fmt::format("Your result is right to about {} at every case, and more are asked for.{}",
                  plural(static_cast<std::size_t>(std::max(1.0, std::floor(-std::log10(worst)))), "digit"), law);
  return Reason{ReasonKind::accuracy, "accuracy", sentence, Weight::possible};
}

std::optional<Reason> diagnose_mostly_near(const ExerciseReference& exercise, const Answers& answers) {
  constexpr double near = 1e-2, far_away = 0.5;
  constexpr std::size_t fewest = 5;
  std::size_t wrong = 0, far = 0, lost = 0, larger = 0;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i] || !answers[i]->is_finite()) return std::nullopt;
    double error = 0;
    for (const Deviation& each : deviations(exercise, i, *answers[i])) error = std::max(error, each.relative_size());
    if (passes(exercise, i, *answers[i])) continue;
    ++wrong;
    far += error > near ? 1 : 0;
    lost += error > far_away ? 1 : 0;
    if (exercise.result_kind == Kind::number && error <= near)
      larger += answers[i]->numbers.front() > exercise.cases[i].expected.numbers.front() ? 1 : 0;
  }
  if (wrong < fewest || 2 * wrong < exercise.cases.size() || 5 * far > wrong || 10 * lost > wrong) return std::nullopt;
  const char* const side = exercise.result_kind != Kind::number || (larger > 0 && larger < wrong - far) ? ""
                           : larger > 0
                               ? " There it is never too small, as the end of a step in place of a point within it."
                               : " There it is never too large, as the best of some points, between which lies a "
                                 "better one.";
  return Reason{
      ReasonKind::accuracy, "near",
      fmt::format("Your result is nearly right: at {} of the {} where it is wrong, it differs by less than "
                  "1 % of its size.{} Either a small term is wrong or missing, or the calculation is too coarse.",
                  wrong - far, plural(wrong, "case"), side),
      Weight::symptom};
}

std::optional<Reason> diagnose_range(const ExerciseReference& exercise, const Answers& answers) {
  struct Range {
    const char* what;
    const char* beyond;
    const char* advice;
    double least, most;
    std::function<double(const Value&)> of;
  };
  constexpr double pi = std::numbers::pi;
  std::optional<Range> range;
  if (exercise.comparison == Comparison::attitude_by_angles)
    range = {"angles give the right attitude",
             "θ is not in [0, π]",
             "(φ + π, −θ, ψ + π) is the same attitude.",
             0,
             pi,
             [](const Value& value) { return value.numbers[1]; }};
  if (exercise.comparison == Comparison::attitude_by_yaw_pitch_roll)
    range = {"angles give the right attitude",
             "the pitch is not in [−π/2, π/2]",
             "(yaw + π, π − pitch, roll + π) is the same attitude.",
             -pi / 2,
             pi / 2,
             [](const Value& value) { return value.numbers[1]; }};
  if (exercise.comparison == Comparison::rotation_by_vector)
    range = {"vector gives the right rotation",
             "its angle is more than half a turn",
             "The same rotation goes the other way round by 2π less.",
             0,
             pi,
             [](const Value& value) { return as_matrix(value).norm(); }};
  if (!range) return std::nullopt;
  std::optional<std::size_t> first;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i] || !deviations(exercise, i, *answers[i]).front().is_within()) return std::nullopt;
    if (passes(exercise, i, *answers[i])) continue;
    const double number = range->of(*answers[i]);
    if (number >= range->least && number <= range->most) return std::nullopt;
    if (!first) first = i;
    ++beyond;
  }
  if (!first) return std::nullopt;
  return Reason{ReasonKind::property, "range",
                fmt::format("Your {} at every case, but at {} {}: it is {} at the case “{}”. {}", range->what,
                            plural(beyond, "case"), range->beyond, number_text(range->of(*answers[*first]), 4),
                            exercise.cases[*first].name, range->advice)};
}

std::optional<Reason> diagnose_eigenvectors(const ExerciseReference& exercise, const Answers& answers) {
  if (exercise.comparison != Comparison::eigenvectors) return std::nullopt;
  struct Fault {
    const char* name;
    const char* words;
    std::size_t cases = 0;
  };
  Fault unsorted{"order", "are not in the order of ascending moments"};
  Fault left_handed{"handedness", "form a left-handed triad (determinant −1)"};
  Fault oblique{"oblique", "are not perpendicular to each other, as axes of equal moments need not be by themselves"};
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i] || !answers[i]->is_finite()) return std::nullopt;
    const Eigen::Matrix3d I = as_matrix(exercise.cases[i].inputs.at(0)), V = as_matrix(*answers[i]);
    const Eigen::Vector3d moments = (V.transpose() * I * V).diagonal();
    const double allowed = clear_margin * exercise.cases[i].tolerance;
    const bool are_axes = (I * V - V * moments.asDiagonal()).norm() <= allowed * I.norm();
    const bool are_units = (V.colwise().norm().array() - 1).abs().maxCoeff() <= allowed;
    if (!are_axes || !are_units) return std::nullopt;
    if (passes(exercise, i, *answers[i])) continue;
    const double step = allowed * I.norm();
    const bool is_unsorted = moments[0] > moments[1] + step || moments[1] > moments[2] + step;
    const bool is_oblique = std::abs(std::abs(V.determinant()) - 1) > allowed;
    ++(is_unsorted ? unsorted : is_oblique ? oblique : left_handed).cases;
  }
  std::vector<std::string> faults;
  const char* name = "";  // of the first
  for (const Fault& fault : {unsorted, left_handed, oblique}) {
    if (fault.cases == 0) continue;
    if (faults.empty()) name = fault.name;
    faults.push_back(fmt::format("at {} they {}", plural(fault.cases, "case"), fault.words));
  }
  if (faults.empty()) return std::nullopt;
  return Reason{ReasonKind::entry, name,
                fmt::format("Your columns are principal axes of length 1 at all {}, but {}.",
                            plural(exercise.cases.size(), "case"), listed(faults))};
}

}  // namespace workbook
