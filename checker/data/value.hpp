/// @file
/// A value as it travels between a student's function, the reference results and the judge: numbers and a shape.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace workbook {

/// The argument and result types that a contract may use.
enum class Kind { number, integer, vector2, vector3, vector, matrix3, points, matrices };

/// Kind as it is written in the reference results ("matrix3").
std::string to_string(Kind kind);

/// The kind of that name. @throws std::invalid_argument for an unknown name.
Kind kind_from_string(const std::string& name);

/// True for the kinds that are one column of numbers.
constexpr bool is_vector(Kind kind) { return kind == Kind::vector2 || kind == Kind::vector3 || kind == Kind::vector; }

/// Numbers in column-major order. A list of n 3×3 matrices stands side by side as 3×3n.
struct Value {
  int rows = 1;
  int cols = 1;
  std::vector<double> numbers = {0.0};

  bool operator==(const Value&) const = default;

  double at(int row, int col) const { return numbers.at(static_cast<std::size_t>(col) * rows + row); }
  bool has_shape_of(const Value& other) const { return rows == other.rows && cols == other.cols; }

  /// True if it has as many numbers as its shape says.
  bool is_complete() const;
  bool is_finite() const;
};

/// The numbers as a matrix, without a copy.
Eigen::Map<const Eigen::MatrixXd> as_matrix(const Value& value);

/// The inverse of as_matrix.
Value to_value(const Eigen::MatrixXd& matrix);

/// A 1×1 value as a number, a column as a list, all else as a list of rows; null for what JSON cannot hold.
void to_json(nlohmann::json& json, const Value& value);
/// The inverse; null becomes NaN. @throws nlohmann::json::exception
void from_json(const nlohmann::json& json, Value& value);

/// As the reader of a report expects it: a vector of one component is a list, points are three rows, matrices a
/// list of matrices.
nlohmann::json json_of(const Value& value, Kind kind);

// --- as people read them

/// The shortest text that reads back as the same number.
inline constexpr int all_digits = 0;

/// The number with at most that many significant digits, or with all_digits.
std::string number_text(double number, int digits);

/// Two numbers with as few digits as tell them apart, and at least `digits`.
std::pair<std::string, std::string> distinct_texts(double one, double other, int digits);

/// How many significant digits show where two numbers differ, between 6 and 17.
int digits_to_tell_apart(double one, double other);

/// "1/2", "−1", "0": a simple fraction if the number is one within 1e-6, else four digits.
std::string coefficient_text(double coefficient);

/// The value on one line: "4.82", "(0.3, -0.2, 0.5)", "[26 -3 -4.5; -3 20 -9; -4.5 -9 10]".
std::string format_value(const Value& value, Kind kind, int digits = all_digits);

/// What one of the value's numbers is called: "the result", "component [1]", "entry (0,2)", "entry (0,2) of matrix [1]", counted as
/// in code.
std::string entry_name(const Value& value, Kind kind, std::size_t number);

/// Texts of one width, with their decimal points below each other.
std::vector<std::string> aligned_on_point(const std::vector<std::string>& numbers);

}  // namespace workbook
