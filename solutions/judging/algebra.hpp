/// @file
/// Sums and products of Eigen's vectors and matrices that are values at once.
///
/// Eigen's own operators give expressions, which keep references to their operands: returned from a lambda they outlive
/// them. Inside workbook::judging these take their place, so that `[](auto& I, auto& omega) { return I * omega; }`
/// returns a vector. A compiler is also done with them much sooner.
#pragma once

#include <Eigen/Dense>

#include <concepts>
#include <type_traits>

namespace workbook::judging {

template <class T>
concept Dense = std::derived_from<T, Eigen::MatrixBase<T>>;

template <class T>
concept Scalar = std::is_arithmetic_v<T>;

/// Column-major like all matrices of the contracts, which PlainObject is not after a transpose().
template <class A, class B = A>
using Plain = Eigen::Matrix<typename A::Scalar, A::RowsAtCompileTime, B::ColsAtCompileTime>;

template <Dense A, Dense B>
Plain<A> operator+(const A& a, const B& b) {
  return a.operator+(b);
}
template <Dense A, Dense B>
Plain<A> operator-(const A& a, const B& b) {
  return a.operator-(b);
}
template <Dense A>
Plain<A> operator-(const A& a) {
  return a.operator-();
}
template <Dense A, Dense B>
Plain<A, B> operator*(const A& a, const B& b) {
  return a.operator*(b);
}
template <Scalar S, Dense A>
Plain<A> operator*(S factor, const A& a) {
  return a.operator*(static_cast<double>(factor));
}
template <Dense A, Scalar S>
Plain<A> operator*(const A& a, S factor) {
  return a.operator*(static_cast<double>(factor));
}
template <Dense A, Scalar S>
Plain<A> operator/(const A& a, S divisor) {
  return a.operator/(static_cast<double>(divisor));
}

}  // namespace workbook::judging
