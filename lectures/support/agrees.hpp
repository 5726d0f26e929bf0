/// @file
/// The one comparison of the worked examples and tests: with a tolerance relative to a scale, and all digits when it
/// fails.
#pragma once

#include <Eigen/Dense>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>

namespace workbook {

/// What agrees() found; true in a CHECK if the numbers agree.
struct Agreement {
  bool holds = false;
  std::string account;  ///< both values with all digits, for the report of a failed check

  explicit operator bool() const { return holds; }
};

namespace detail {

inline Eigen::MatrixXd as_matrix(double number) { return Eigen::MatrixXd::Constant(1, 1, number); }

template <class Derived>
Eigen::MatrixXd as_matrix(const Eigen::MatrixBase<Derived>& matrix) {
  return matrix;
}

inline std::string all_digits(const Eigen::MatrixXd& matrix) {
  if (matrix.size() == 1) return fmt::format("{}", matrix(0, 0));
  std::string text;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    text += i == 0 ? "[" : "; ";
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) text += fmt::format("{}{}", j == 0 ? "" : " ", matrix(i, j));
  }
  return text + "]";
}

/// As agrees() below; a function of its own, because it is compiled once then, not for each pair of types.
inline Agreement matrices_agree(const Eigen::MatrixXd& a, const Eigen::MatrixXd& e, double tolerance, double scale) {
  if (a.rows() != e.rows() || a.cols() != e.cols()) {
    return {false, fmt::format("{}×{} where {}×{} is expected", a.rows(), a.cols(), e.rows(), e.cols())};
  }
  if (scale == 0.0) scale = e.size() > 0 ? e.cwiseAbs().maxCoeff() : 1.0;
  if (scale == 0.0)
    throw std::invalid_argument(
        "the expected value, which should not be zero, is zero, so nothing can be compared with it");
  bool holds = true;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const double difference = std::abs(a(k) - e(k));
    holds = holds && difference <= tolerance * scale;
    largest = std::isnan(difference) ? difference : std::max(largest, difference);
  }
  return {holds, fmt::format("{} where {} is expected (difference {:.3g}, allowed {:.3g})", all_digits(a),
                             all_digits(e), largest, tolerance * scale)};
}

}  // namespace detail

/// Do two numbers, vectors or matrices agree within `tolerance` times `scale`, entry by entry?
///
/// Without a scale the largest expected entry is taken; for an expected zero a scale must be given, because nothing
/// is small compared with zero. NaN never agrees.
template <class Actual, class Expected>
Agreement agrees(const Actual& actual, const Expected& expected, double tolerance = 1e-12, double scale = 0.0) {
  return detail::matrices_agree(detail::as_matrix(actual), detail::as_matrix(expected), tolerance, scale);
}

}  // namespace workbook

template <>
struct doctest::StringMaker<workbook::Agreement> {
  static doctest::String convert(const workbook::Agreement& agreement) { return agreement.account.c_str(); }
};
