/// @file
/// The bridge between the C++ types of the contracts and Value; header-only because the worker needs it and no library.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace workbook {

/// Numbers with a shape, seen without owning them (column-major).
struct NumbersView {
  int rows;
  int cols;
  const double* numbers;
};

/// How one C++ type is read from and written to numbers.
/// `name` is the name of the kind in the reference results.
template <class T>
struct KindOf;

template <class Number>
struct NumberKind {
  static Number read(NumbersView view) { return static_cast<Number>(view.numbers[0]); }
  static int rows(Number) { return 1; }
  static int cols(Number) { return 1; }
  static void write(Number value, double* out) { out[0] = value; }
};

template <>
struct KindOf<double> : NumberKind<double> {
  static constexpr const char* name = "number";
};
template <>
struct KindOf<int> : NumberKind<int> {
  static constexpr const char* name = "integer";
};

/// Every Eigen matrix of the contracts, fixed or free in size.
template <int Rows, int Cols>
struct KindOf<Eigen::Matrix<double, Rows, Cols>> {
  using Matrix = Eigen::Matrix<double, Rows, Cols>;
  static constexpr bool is_list = Rows == Eigen::Dynamic || Cols == Eigen::Dynamic;
  static constexpr const char* name = Cols == 1 && Rows == 2   ? "vector2"
                                      : Cols == 1 && Rows == 3 ? "vector3"
                                      : Cols == 1 && is_list   ? "vector"
                                      : Rows == 3 && Cols == 3 ? "matrix3"
                                      : Rows == 3 && is_list   ? "points"
                                                               : nullptr;
  static_assert(name != nullptr, "no contract has matrices of this size");
  static Matrix read(NumbersView view) {
    Matrix value(view.rows, view.cols);
    std::copy_n(view.numbers, value.size(), value.data());
    return value;
  }
  static int rows(const Matrix& value) { return static_cast<int>(value.rows()); }
  static int cols(const Matrix& value) { return static_cast<int>(value.cols()); }
  static void write(const Matrix& value, double* out) { std::copy_n(value.data(), value.size(), out); }
};

template <>
struct KindOf<std::vector<Eigen::Matrix3d>> {
  using List = std::vector<Eigen::Matrix3d>;
  static constexpr const char* name = "matrices";
  static List read(NumbersView view) {
    List list(static_cast<std::size_t>(view.cols) / 3);
    for (std::size_t i = 0; i < list.size(); ++i) std::copy_n(view.numbers + 9 * i, 9, list[i].data());
    return list;
  }
  static int rows(const List&) { return 3; }
  static int cols(const List& value) { return static_cast<int>(3 * value.size()); }
  static void write(const List& value, double* out) {
    for (std::size_t i = 0; i < value.size(); ++i) std::copy_n(value[i].data(), 9, out + 9 * i);
  }
};

/// The kind of a parameter as a contract declares it (`const Vector3d&`, `double`).
template <class Parameter>
using KindOfParameter = KindOf<std::remove_cvref_t<Parameter>>;

}  // namespace workbook
