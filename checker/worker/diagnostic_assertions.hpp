/// @file
/// For a diagnostic run: assertions of Eigen and of the standard library that also tell the numbers they compare. To be
/// included before both.
///
/// A failed condition such as `index >= 0 && index < size()` is evaluated once more between two capturing operators:
/// `Capture{} << index >= 0 && index < size() >> Capture{}`. Shifts bind tighter than comparisons and looser than sums,
/// so the first captures the left side of the first comparison and the second the right side of the last one.
#pragma once

#include <type_traits>
#include <version>

namespace workbook {

/// The two sides of the first and of the last comparison, if they are whole numbers; of a single one only once.
struct Operands {
  int count = 0;
  long numbers[4] = {};

  constexpr explicit operator bool() const { return false; }
};

template <class T>
struct Captured {
  const T& value;

  constexpr explicit operator bool() const { return static_cast<bool>(value); }
};

// clang-format off
struct Capture {
  template <class T> constexpr Captured<T> operator<<(const T& value) const { return {value}; }
  template <class T> friend constexpr Captured<T> operator>>(const T& value, Capture) { return {value}; }
};

template <class T> inline constexpr bool is_captured = false;
template <class T> inline constexpr bool is_captured<Captured<T>> = true;
template <class T> constexpr const T& value_of(const T& side) { return side; }
template <class T> constexpr const T& value_of(const Captured<T>& side) { return side.value; }

template <class Left, class Right> constexpr Operands compared(const Left& left, const Right& right) {
  if constexpr (!std::is_integral_v<Left> || !std::is_integral_v<Right>) return {};
  else return {2, {static_cast<long>(left), static_cast<long>(right)}};
}

#define WORKBOOK_COMPARISON(op)                                                                                 \
  template <class Left, class Right> requires(is_captured<Left> || is_captured<Right>)                          \
  constexpr Operands operator op(const Left& left, const Right& right) { return compared(value_of(left), value_of(right)); }
WORKBOOK_COMPARISON(<)
WORKBOOK_COMPARISON(<=)
WORKBOOK_COMPARISON(>)
WORKBOOK_COMPARISON(>=)
WORKBOOK_COMPARISON(==)
WORKBOOK_COMPARISON(!=)

constexpr Operands operator&&(const Operands& first, const Operands& last) {
  if (first.count == 0 || last.count == 0) return first.count == 0 ? last : first;
  return {4, {first.numbers[0], first.numbers[1], last.numbers[0], last.numbers[1]}};
}
template <class T> constexpr Operands operator&&(const Operands& first, const T&) { return first; }
template <class T> constexpr Operands operator&&(const T&, const Operands& last) { return last; }
constexpr Operands operands(const Operands& condition) { return condition; }
template <class T> constexpr Operands operands(const T&) { return {}; }
// clang-format on

/// Tells what Eigen compared, and throws EigenError.
void report_eigen_assertion(const char* condition, const Operands& operands);

/// Tells which condition of the standard library failed, and aborts as the library would.
[[noreturn]] void report_library_assertion(const char* function, const char* condition, const Operands& operands);

}  // namespace workbook

#define WORKBOOK_OPERANDS(...) ::workbook::operands(::workbook::Capture{} << __VA_ARGS__ >> ::workbook::Capture{})

#define eigen_assert(...)               \
  ((__VA_ARGS__) ? static_cast<void>(0) \
                 : ::workbook::report_eigen_assertion(#__VA_ARGS__, WORKBOOK_OPERANDS(__VA_ARGS__)))

#if defined(__glibcxx_assert)
#undef __glibcxx_assert
#define __glibcxx_assert(...)                                                                                  \
  do {                                                                                                         \
    if (!bool(__VA_ARGS__))                                                                                    \
      ::workbook::report_library_assertion(__PRETTY_FUNCTION__, #__VA_ARGS__, WORKBOOK_OPERANDS(__VA_ARGS__)); \
  } while (false)
#endif
