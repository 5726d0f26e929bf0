/// @file
/// A value as it travels between a student's function, the reference results and the judge: numbers and a shape.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace workbook {

/// The argument and result types that a contract may use.
enum class Kind { number, integer, vector2, vector3, vector, matrix3, points, matrices };

/// Kind as it is written in the reference results ("matrix3").
std::string to_string(Kind kind);

/// The kind of that name. @throws std::invalid_argument for an unknown name.
Kind kind_from_string(const std::string& name);

/// Numbers in column-major order. A list of n 3×3 matrices stands side by side as 3×3n.
struct Value {
  int rows = 1;
  int cols = 1;
  std::vector<double> numbers = {0.0};

  bool operator==(const Value&) const = default;

  double at(int row, int col) const { return numbers.at(static_cast<std::size_t>(col) * rows + row); }
  bool has_shape_of(const Value& other) const { return rows == other.rows && cols == other.cols; }
};

/// True if no number is NaN or infinite.
bool is_finite(const Value& value);

/// A number as a number, a vector as a list, a matrix as a list of rows, matrices as a list of such;
/// numbers that JSON cannot hold (NaN, infinity) become null.
nlohmann::json to_json(const Value& value, Kind kind);

/// The inverse of to_json; null becomes NaN. @throws std::invalid_argument saying what is wrong with the shape.
Value value_from_json(const nlohmann::json& json, Kind kind);

}  // namespace workbook
