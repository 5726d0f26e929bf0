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

template <class A>
concept IsPlain = std::same_as<A, Plain<A>>;

/// What is evaluated already stays where it is. Sums and multiples of expressions are those of their values, so that
/// Eigen makes its types for these only.
template <Dense A>
decltype(auto) value_of(const A& a) {
  if constexpr (IsPlain<A>) {
    return (a);
  } else {
    return Plain<A>(a);
  }
}

template <Dense A, Dense B>
Plain<A> operator+(const A& a, const B& b) {
  if constexpr (IsPlain<A> && IsPlain<B>) {
    return a.operator+(b);
  } else {
    return value_of(a) + value_of(b);
  }
}
template <Dense A, Dense B>
Plain<A> operator-(const A& a, const B& b) {
  if constexpr (IsPlain<A> && IsPlain<B>) {
    return a.operator-(b);
  } else {
    return value_of(a) - value_of(b);
  }
}
template <Dense A>
Plain<A> operator-(const A& a) {
  if constexpr (IsPlain<A>) {
    return a.operator-();
  } else {
    return -value_of(a);
  }
}
template <Scalar S, Dense A>
Plain<A> operator*(S factor, const A& a) {
  if constexpr (IsPlain<A> && std::same_as<S, double>) {
    return a.operator*(factor);
  } else {
    return static_cast<double>(factor) * value_of(a);
  }
}
template <Dense A, Scalar S>
Plain<A> operator*(const A& a, S factor) {
  return static_cast<double>(factor) * value_of(a);
}
template <Dense A, Scalar S>
Plain<A> operator/(const A& a, S divisor) {
  if constexpr (IsPlain<A> && std::same_as<S, double>) {
    return a.operator/(divisor);
  } else {
    return value_of(a) / static_cast<double>(divisor);
  }
}
template <Dense A, Dense B>
Plain<A, B> operator*(const A& a, const B& b) {
  return a.operator*(b);
}

#define WORKBOOK_ALGEBRA extern template  // compiled once, in algebra.cpp
#include "solutions/judging/algebra.inc"

}  // namespace workbook::judging
