/// @file
/// Ways to spoil an input or a result that recur, for wrong_input and wrong_output.
#pragma once

#include "solutions/judging/algebra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace workbook::judging {

inline auto times(double factor) {
  return [factor](auto& value) { value *= factor; };
}

template <class T>
auto fixed(const T& constant) {
  return [constant](T& value) { value = constant; };
}

/// The opposite sign of component number i.
inline auto negate(int i) {
  return [i](auto& vector) { vector[i] = -vector[i]; };
}

inline auto zeroed(int i) {
  return [i](auto& vector) { vector[i] = 0; };
}

inline auto complement_of(int i) {
  return [i](auto& angles) { angles[i] = std::numbers::pi / 2 - angles[i]; };
}

inline auto exchange(int i, int j) {
  return [i, j](auto& vector) { std::swap(vector[i], vector[j]); };
}

inline constexpr auto complement = [](double angle) { return std::numbers::pi / 2 - angle; };
inline constexpr auto negated = [](auto& value) { value = -value; };
inline constexpr auto transposed = [](auto& matrix) { matrix.transposeInPlace(); };
inline constexpr auto reversed = [](auto& vector) { std::reverse(vector.data(), vector.data() + vector.size()); };
inline constexpr auto first_two_exchanged = [](auto& first, auto& other, auto&...) { std::swap(first, other); };
inline constexpr auto without_sign = [](double& number) { number = std::abs(number); };

}  // namespace workbook::judging
