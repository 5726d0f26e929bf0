/// @file
/// Numbers that explain a failed condition: indices and sizes.
#pragma once

#include <stdexcept>
#include <type_traits>

namespace workbook {

/// Their meaning depends on the condition.
struct Facts {
  static constexpr int most = 6;
  int count = 0;
  long numbers[most] = {};
};

template <class... Numbers>
Facts facts(const Numbers&... numbers) {
  static_assert(sizeof...(numbers) <= Facts::most);
  return {sizeof...(numbers), {static_cast<long>(numbers)...}};
}

/// One of Eigen's own checks failed: an index or a size does not fit.
struct EigenError : std::logic_error {
  using std::logic_error::logic_error;
};

/// Remembers what failed and where, and throws EigenError.
void report_eigen_assertion(const char* condition, const Facts& facts);

/// The two sides of `a < b` in a condition of the standard library, or nothing.
struct Sides {
  bool known = false;
  long left = 0;
  long right = 0;

  constexpr Sides() = default;
  constexpr Sides(bool) {}
  template <class Left, class Right>
  constexpr Sides(const Left& left_side, const Right& right_side) {
    if constexpr (std::is_integral_v<Left> && std::is_integral_v<Right>) {
      known = true;
      left = static_cast<long>(left_side);
      right = static_cast<long>(right_side);
    }
  }
  constexpr explicit operator bool() const { return false; }
};

/// Catches the sides: `CatchSides()->*a < b` is `->*` first, then `<`.
template <class Left>
struct LeftSide {
  const Left& left;

  // clang-format off
  template <class Right> constexpr Sides operator<(const Right& right) const { return {left, right}; }
  template <class Right> constexpr Sides operator<=(const Right& right) const { return {left, right}; }
  template <class Right> constexpr Sides operator>(const Right&) const { return {}; }
  template <class Right> constexpr Sides operator>=(const Right&) const { return {}; }
  template <class Right> constexpr Sides operator==(const Right&) const { return {}; }
  template <class Right> constexpr Sides operator!=(const Right&) const { return {}; }
  // clang-format on
  constexpr operator Sides() const { return {}; }
  constexpr explicit operator bool() const { return false; }
};

struct CatchSides {
  template <class Left>
  constexpr LeftSide<Left> operator->*(const Left& left) const {
    return {left};
  }
};

/// A check of the standard library failed: tells what and where, then aborts as the library would.
[[noreturn]] void report_library_assertion(const char* function, const char* condition, const Sides& sides);

}  // namespace workbook
