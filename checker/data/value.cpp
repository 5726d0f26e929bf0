#include "checker/data/value.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace workbook {

using nlohmann::json;

namespace {

/// In the order of Kind.
constexpr std::array kind_names = {"number", "integer", "vector2", "vector3",
                                   "vector", "matrix3", "points",  "matrices"};

json number_to_json(double number) { return std::isfinite(number) ? json(number) : json(nullptr); }

double number_from_json(const json& part) {
  return part.is_null() ? std::numeric_limits<double>::quiet_NaN() : part.get<double>();
}

json rows_to_json(const Value& value, int first_col, int cols) {
  json rows = json::array();
  for (int row = 0; row < value.rows; ++row) {
    rows.push_back(json::array());
    for (int col = first_col; col < first_col + cols; ++col) rows.back().push_back(number_to_json(value.at(row, col)));
  }
  return rows;
}

}  // namespace

std::string to_string(Kind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

Kind kind_from_string(const std::string& name) {
  const auto found = std::find(kind_names.begin(), kind_names.end(), name);
  if (found == kind_names.end()) throw std::invalid_argument("there is no kind of value \"" + name + "\"");
  return static_cast<Kind>(found - kind_names.begin());
}

bool Value::is_complete() const {
  return rows >= 0 && cols >= 0 && numbers.size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols);
}

bool Value::is_finite() const {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

Eigen::Map<const Eigen::MatrixXd> as_matrix(const Value& value) {
  return {value.numbers.data(), value.rows, value.cols};
}

Value to_value(const Eigen::MatrixXd& matrix) {
  return {
      static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), {matrix.data(), matrix.data() + matrix.size()}};
}

void to_json(json& part, const Value& value) {
  if (value.cols != 1) {
    part = rows_to_json(value, 0, value.cols);
  } else if (value.rows == 1) {
    part = number_to_json(value.numbers.at(0));
  } else {
    part = json::array();
    for (const double number : value.numbers) part.push_back(number_to_json(number));
  }
}

void from_json(const json& part, Value& value) {
  if (!part.is_array()) {
    value = {1, 1, {number_from_json(part)}};
    return;
  }
  const std::size_t rows = part.size();
  const bool is_column = rows == 0 || !part.front().is_array();
  const std::size_t cols = is_column ? 1 : part.front().size();
  value = {static_cast<int>(rows), static_cast<int>(cols), std::vector<double>(rows * cols)};
  for (std::size_t row = 0; row < rows; ++row) {
    if (!is_column && part[row].size() != cols) throw std::invalid_argument("the rows of a matrix differ in length");
    for (std::size_t col = 0; col < cols; ++col)
      value.numbers[col * rows + row] = number_from_json(is_column ? part[row] : part[row].at(col));
  }
}

json json_of(const Value& value, Kind kind) {
  if (kind == Kind::matrices) {
    json list = json::array();
    for (int col = 0; col + 3 <= value.cols; col += 3) list.push_back(rows_to_json(value, col, 3));
    return list;
  }
  if (kind == Kind::integer && value.is_finite()) return std::llround(value.numbers.at(0));
  if (is_vector(kind) && value.rows == 1) return json::array({number_to_json(value.numbers.at(0))});
  if (kind == Kind::points) return rows_to_json(value, 0, value.cols);
  return value;
}

}  // namespace workbook
