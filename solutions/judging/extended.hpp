/// @file
/// The solutions once more with `long double` in the place of `double`, in namespace `extended`: included before every
/// other line of a source. What the standard library, Eigen and Boost declare must be read before their words change.
#pragma once

#include "checker/data/reference_results.hpp"

#include <Eigen/Dense>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace workbook::judging {

using OfValues = std::function<Value(const std::vector<Value>&)>;
using Extended = long double;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

/// The functions of a lecture by name.
std::map<std::string, OfValues> extended_functions();

/// An argument of a contract in extended precision.
template <class T>
struct FromValue {
  static T read(const Value& value) {
    if constexpr (std::is_arithmetic_v<T>)
      return static_cast<T>(value.numbers.at(0));
    else
      return as_matrix(value).cast<Extended>();
  }
};
template <class Matrix>
struct FromValue<std::vector<Matrix>> {
  static std::vector<Matrix> read(const Value& value) {
    std::vector<Matrix> list;
    for (int i = 0; i < value.cols / 3; ++i)
      list.push_back(as_matrix(value).middleCols<3>(3 * i).template cast<Extended>());
    return list;
  }
};

inline Value rounded(Extended number) { return {1, 1, {static_cast<double>(number)}}; }
inline Value rounded(const ExtendedMatrix& matrix) { return to_value(matrix.cast<double>()); }
template <class Matrix>
Value rounded(const std::vector<Matrix>& list) {
  ExtendedMatrix all(3, 3 * list.size());
  for (std::size_t i = 0; i < list.size(); ++i) all.middleCols(static_cast<Eigen::Index>(3 * i), 3) = list[i];
  return rounded(all);
}

template <class Result, class... Parameters>
OfValues on_values(Result (*function)(Parameters...)) {
  return [function](const std::vector<Value>& inputs) {
    const auto call = [&]<std::size_t... I>(std::index_sequence<I...>) {
      return function(FromValue<std::remove_cvref_t<Parameters>>::read(inputs.at(I))...);
    };
    return rounded(call(std::index_sequence_for<Parameters...>{}));
  };
}

}  // namespace workbook::judging

namespace Eigen {
using Vector2e = Matrix<long double, 2, 1>;
using Vector3e = Matrix<long double, 3, 1>;
using VectorXe = Matrix<long double, Dynamic, 1>;
using Matrix3e = Matrix<long double, 3, 3>;
using Matrix3Xe = Matrix<long double, 3, Dynamic>;
using MatrixXe = Matrix<long double, Dynamic, Dynamic>;
using Quaternione = Quaternion<long double>;
using AngleAxise = AngleAxis<long double>;
using Rotation2De = Rotation2D<long double>;
}  // namespace Eigen

using extended_double = long double;  // one word, as double is
#define double extended_double
#define Vector2d Vector2e
#define Vector3d Vector3e
#define VectorXd VectorXe
#define Matrix3d Matrix3e
#define Matrix3Xd Matrix3Xe
#define MatrixXd MatrixXe
#define Quaterniond Quaternione
#define AngleAxisd AngleAxise
#define Rotation2Dd Rotation2De
#define rigid extended
