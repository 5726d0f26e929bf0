#include "checker/judging/comparison.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace workbook {

namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;

/// A deviation whose numbers may all be equally large.
Deviation uniform_deviation(std::string meaning, Kind kind, const MatrixXd& difference, double tolerance, double size) {
  Deviation deviation{std::move(meaning), kind, to_value(difference), tolerance, {}, false};
  deviation.allowed.assign(deviation.difference.numbers.size(), tolerance * size);
  return deviation;
}

Deviation entry_by_entry(std::string meaning, Kind kind, const Case& one, const Value& actual, const Value& target) {
  Deviation deviation{std::move(meaning), kind, actual, one.tolerance, {}, true};
  for (std::size_t n = 0; n < actual.numbers.size(); ++n) {
    deviation.difference.numbers[n] = actual.numbers[n] - target.numbers[n];
    deviation.allowed.push_back(one.tolerance * scale_at(one, n));
  }
  return deviation;
}

Value negative(Value value) {
  for (double& number : value.numbers) number = -number;
  return value;
}

/// Signs and order of eigenvectors of equal moments are free, so the equations are tested and not the entries.
std::vector<Deviation> eigenvector_deviations(const Case& one, const Value& actual) {
  // Of fixed size, which also compiles in a fraction of the time.
  const Matrix3d I = as_matrix(one.inputs.at(0));
  const Matrix3d V = as_matrix(actual);
  const Matrix3d expected = as_matrix(one.expected);
  const Matrix3d D = (expected.transpose() * I * expected).diagonal().asDiagonal();
  const MatrixXd determinant = MatrixXd::Constant(1, 1, V.determinant() - 1);
  // The determinant only tells right-handed from left-handed: its size follows from Vᵀ V = 1, with an error three
  // halves as large.
  return {uniform_deviation("I V − V D", Kind::matrix3, I * V - V * D, one.tolerance, I.norm()),
          uniform_deviation("Vᵀ V − 1", Kind::matrix3, V.transpose() * V - Matrix3d::Identity(), one.tolerance, 1.0),
          uniform_deviation("det V − 1", Kind::number, determinant, one.tolerance, 4.0)};
}

/// What three numbers say of an attitude. Of angles: R = R_ψ R_θ R_φ with passive elementary rotations about z, y and
/// z, or x for yaw, pitch and roll: components on the body axes from inertial ones. Of a rotation vector: the rotation
/// itself.
Matrix3d attitude(Comparison comparison, const Value& value) {
  if (comparison == Comparison::rotation_by_vector) {
    const Eigen::Vector3d v = as_matrix(value);
    return Eigen::AngleAxisd(v.stableNorm(), v.stableNormalized()).toRotationMatrix();
  }
  const auto about_z = [](double angle) -> Matrix3d {
    const double c = std::cos(angle), s = std::sin(angle);
    return (Matrix3d() << c, s, 0, -s, c, 0, 0, 0, 1).finished();
  };
  const auto about_y = [](double angle) -> Matrix3d {
    const double c = std::cos(angle), s = std::sin(angle);
    return (Matrix3d() << c, 0, -s, 0, 1, 0, s, 0, c).finished();
  };
  const Matrix3d first_two = about_y(value.numbers.at(1)) * about_z(value.numbers.at(0));
  const double last = value.numbers.at(2);
  if (comparison == Comparison::attitude_by_yaw_pitch_roll)
    return Eigen::AngleAxisd(-last, Eigen::Vector3d::UnitX()).toRotationMatrix() * first_two;
  return about_z(last) * first_two;
}

/// Of θ, which is unique in [0, π]. NaN stays NaN.
double beyond_range(double theta) {
  return theta < 0 ? theta : theta > std::numbers::pi ? theta - std::numbers::pi : 0 * theta;
}

/// The attitude, and the range in which its numbers are unique.
std::vector<Deviation> attitude_deviations(Comparison comparison, const Case& one, const Value& actual) {
  const double pi = std::numbers::pi;
  std::vector<Deviation> found{uniform_deviation("R(yours) − R(expected)", Kind::matrix3,
                                                 attitude(comparison, actual) - attitude(comparison, one.expected),
                                                 one.tolerance, 1.0)};
  const auto add_range = [&](const char* meaning, double beyond, double tolerance) {
    found.push_back(uniform_deviation(meaning, Kind::number, MatrixXd::Constant(1, 1, beyond), tolerance, 1.0));
  };
  constexpr double rounding = 1e-7;  // any arctangent or arccosine may round beyond the end of its range
  if (comparison == Comparison::attitude_by_angles)
    add_range("θ beyond [0, π]", beyond_range(actual.numbers.at(1)), one.tolerance);
  if (comparison == Comparison::attitude_by_yaw_pitch_roll)
    add_range("|pitch| beyond π/2", std::max(0.0, std::abs(actual.numbers.at(1)) - pi / 2), rounding);
  if (comparison == Comparison::rotation_by_vector) {
    const Eigen::Vector3d yours = as_matrix(actual), expected = as_matrix(one.expected);
    add_range("|yours| − π", std::max(0.0, yours.norm() - pi), rounding);
    // The matrix of a small rotation does not show the digits of the vector.
    if (const double length = expected.norm(); length > 0 && length < 1e-3)
      found.push_back(uniform_deviation("yours − expected", Kind::vector3, yours - expected, one.tolerance, length));
  }
  return found;
}

bool is_same_number(double one, double other, double allowed) {
  if (!std::isfinite(one) || !std::isfinite(other)) return !std::isfinite(one) && !std::isfinite(other);
  return std::abs(one - other) <= allowed;
}

/// Entries may be larger than the right ones; then their rounding errors are larger too.
bool is_same_entry_by_entry(const Case& one, const Value& first, const Value& second) {
  for (std::size_t n = 0; n < first.numbers.size(); ++n) {
    const double size = std::max(scale_at(one, n), std::abs(second.numbers[n]));
    if (!is_same_number(first.numbers[n], second.numbers[n], one.tolerance * size)) return false;
  }
  return true;
}

bool is_same_up_to_signs_of_columns(const Case& one, const MatrixXd& first, const MatrixXd& second) {
  MatrixXd turned = second;
  for (Eigen::Index col = 0; col < second.cols(); ++col) {
    if (first.col(col).dot(second.col(col)) < 0) turned.col(col) = -second.col(col);
  }
  return is_same_entry_by_entry(one, to_value(first), to_value(turned));
}

bool is_same_attitude(Comparison comparison, const Case& one, const Value& first, const Value& second) {
  const Matrix3d R_first = attitude(comparison, first);
  const Matrix3d R_second = attitude(comparison, second);
  for (Eigen::Index n = 0; n < R_first.size(); ++n) {
    if (!is_same_number(R_first(n), R_second(n), one.tolerance)) return false;
  }
  return true;
}

}  // namespace

bool Deviation::is_within(std::size_t number) const { return std::abs(difference.numbers[number]) <= allowed[number]; }

bool Deviation::is_within() const {
  for (std::size_t n = 0; n < difference.numbers.size(); ++n) {
    if (!is_within(n)) return false;
  }
  return true;
}

double Deviation::relative_size() const {
  double largest = 0.0;
  for (std::size_t n = 0; n < difference.numbers.size(); ++n) {
    const double size = std::abs(difference.numbers[n]);
    if (std::isnan(size)) return std::numeric_limits<double>::infinity();
    if (size > 0) largest = std::max(largest, size / allowed[n] * tolerance);
  }
  return largest;
}

double scale_at(const Case& one, std::size_t number) {
  return one.scale.size() == 1 ? one.scale[0] : one.scale.at(number);
}

bool has_usable_value(const Reply& reply, const Case& one) {
  return reply.ending == Ending::returned && reply.value.has_shape_of(one.expected) && reply.value.is_complete();
}

Answers answers_of(const ExerciseReference& exercise, const std::vector<Reply>& replies) {
  Answers answers(exercise.cases.size());
  for (std::size_t i = 0; i < std::min(answers.size(), replies.size()); ++i) {
    if (has_usable_value(replies[i], exercise.cases[i])) answers[i] = replies[i].value;
  }
  return answers;
}

std::vector<std::size_t> deciding_cases(const ExerciseReference& exercise) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (exercise.cases[i].deciding) indices.push_back(i);
  }
  return indices;
}

bool all_deciding_cases_answered(const ExerciseReference& exercise, const Answers& answers) {
  const auto deciding = deciding_cases(exercise);
  return !deciding.empty() &&
         std::ranges::all_of(deciding, [&](std::size_t i) { return i < answers.size() && answers[i].has_value(); });
}

/// A rotation vector is so only where it is half a turn long.
static bool is_free_in_sign(const ExerciseReference& exercise, const Value& expected) {
  return exercise.comparison == Comparison::up_to_sign || (exercise.comparison == Comparison::rotation_by_vector &&
                                                           as_matrix(expected).norm() > std::numbers::pi - 1e-7);
}

Value nearest_expected(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  const Value& expected = exercise.cases.at(case_index).expected;
  if (!is_free_in_sign(exercise, expected)) return expected;
  return as_matrix(actual).cwiseProduct(as_matrix(expected)).sum() < 0 ? negative(expected) : expected;
}

std::vector<Deviation> deviations(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  const Case& one = exercise.cases.at(case_index);
  std::vector<Deviation> found;
  switch (exercise.comparison) {
    case Comparison::plain:
    case Comparison::up_to_sign:
      found.push_back(entry_by_entry("yours − expected", exercise.result_kind, one, actual,
                                     nearest_expected(exercise, case_index, actual)));
      break;
    case Comparison::eigenvectors:
      found = eigenvector_deviations(one, actual);
      break;
    case Comparison::attitude_by_angles:
    case Comparison::attitude_by_yaw_pitch_roll:
    case Comparison::rotation_by_vector:
      found = attitude_deviations(exercise.comparison, one, actual);
      break;
  }
  for (const Property& property : exercise.properties) {
    if (property.kind == PropertyKind::constant_weighted_square && actual.cols > 0) {
      found.push_back(invariant_deviation(exercise, property, case_index, actual));
    }
  }
  return found;
}

Deviation invariant_deviation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                const Value& actual) {
  const Case& one = exercise.cases.at(case_index);
  const std::vector<double>& weights = property.weights.at(case_index);
  std::vector<double> magnitudes = weights;
  for (double& weight : magnitudes) weight = std::abs(weight);

  const Value sums{actual.cols, 1, weighted_squares(weights, actual)};
  Deviation deviation{property.message, Kind::vector, sums, one.tolerance, {}, false};
  const std::vector<double> expected = weighted_squares(weights, one.expected);
  for (double& sum : deviation.difference.numbers) sum -= expected.front();
  for (double size : weighted_squares(magnitudes, one.expected)) deviation.allowed.push_back(one.tolerance * size);
  return deviation;
}

bool passes(const ExerciseReference& exercise, std::size_t case_index, const Value& actual) {
  if (!actual.has_shape_of(exercise.cases.at(case_index).expected) || !actual.is_complete() || !actual.is_finite())
    return false;
  return std::ranges::all_of(deviations(exercise, case_index, actual),
                             [](const Deviation& deviation) { return deviation.is_within(); });
}

bool is_same_answer(const ExerciseReference& exercise, std::size_t case_index, const Value& one, const Value& other) {
  if (!one.has_shape_of(other)) return false;
  const Case& judged = exercise.cases.at(case_index);
  switch (exercise.comparison) {
    case Comparison::plain:
    case Comparison::up_to_sign:
    case Comparison::rotation_by_vector:
      return is_same_entry_by_entry(judged, one, other) ||
             (is_free_in_sign(exercise, judged.expected) && is_same_entry_by_entry(judged, one, negative(other)));
    case Comparison::eigenvectors: {
      // Eigenvectors put into rows by mistake have the freedom of sign row by row.
      const MatrixXd first = as_matrix(one);
      const MatrixXd second = as_matrix(other);
      return is_same_up_to_signs_of_columns(judged, first, second) ||
             is_same_up_to_signs_of_columns(judged, first.transpose(), second.transpose());
    }
    case Comparison::attitude_by_angles:
    case Comparison::attitude_by_yaw_pitch_roll:
      return is_same_attitude(exercise.comparison, judged, one, other);
  }
  return false;
}

std::vector<double> weighted_squares(const std::vector<double>& weights, const Value& value) {
  std::vector<double> sums;
  for (int col = 0; col < value.cols; ++col) {
    double sum = 0.0;
    for (int row = 0; row < value.rows; ++row) {
      sum += weights.at(static_cast<std::size_t>(row)) * value.at(row, col) * value.at(row, col);
    }
    sums.push_back(sum);
  }
  return sums;
}

}  // namespace workbook
