#include "checker/data/value.hpp"

#include "checker/base/text.hpp"

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

constexpr int largest_denominator = 12;

/// Entries of the columns [first, first + cols), row by row: "26 -3; -3 20".
std::string rows_text(const Value& value, int first, int cols, int digits) {
  std::string text = "[";
  for (int row = 0; row < value.rows; ++row)
    for (int col = first; col < first + cols; ++col)
      text += (col > first ? " " : row > 0 ? "; " : "") + number_text(value.at(row, col), digits);
  return text + "]";
}

std::size_t point_position(const std::string& number) { return std::min(number.find_first_of(".e"), number.size()); }

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

std::string number_text(double number, int digits) {
  if (std::isnan(number)) return "NaN";  // never "-nan": its sign says nothing
  if (number == 0) return "0";
  return digits == all_digits ? fmt::format("{}", number) : fmt::format("{:.{}g}", number, digits);
}

std::pair<std::string, std::string> distinct_texts(double one, double other, int digits) {
  std::pair<std::string, std::string> texts;
  do {
    texts = {number_text(one, digits), number_text(other, digits)};
  } while (texts.first == texts.second && ++digits <= 17);
  return texts;
}

int digits_to_tell_apart(double one, double other) {
  const double difference = std::abs(one - other);
  if (!(difference > 0) || !std::isfinite(difference)) return 6;
  const double size = std::max(std::abs(one), std::abs(other));
  return std::clamp(static_cast<int>(std::ceil(std::log10(size / difference))) + 2, 6, 17);
}

std::string coefficient_text(double coefficient) {
  const std::string sign = coefficient < 0 ? "−" : "";
  const double size = std::abs(coefficient);
  for (int denominator = 1; denominator <= largest_denominator; ++denominator) {
    const double numerator = std::round(size * denominator);
    if (std::abs(size - numerator / denominator) > 1e-6 * std::max(1.0, size)) continue;
    if (numerator == 0) return "0";
    return denominator == 1 ? fmt::format("{}{}", sign, numerator)
                            : fmt::format("{}{}/{}", sign, numerator, denominator);
  }
  return sign + number_text(size, 4);
}

std::string format_value(const Value& value, Kind kind, int digits) {
  std::vector<std::string> texts;
  if (is_vector(kind)) {
    for (const double number : value.numbers) texts.push_back(number_text(number, digits));
    return fmt::format("({})", fmt::join(texts, ", "));
  }
  if (kind == Kind::matrices) {
    for (int col = 0; col + 3 <= value.cols; col += 3) texts.push_back(rows_text(value, col, 3, digits));
    return fmt::format("{{{}}}", fmt::join(texts, ", "));
  }
  if (kind == Kind::matrix3 || kind == Kind::points)
    return value.cols == 0 ? "[]" : rows_text(value, 0, value.cols, digits);
  return value.numbers.empty() ? "nothing" : number_text(value.numbers.front(), digits);
}

std::string entry_name(const Value& value, Kind kind, std::size_t number) {
  const auto rows = static_cast<std::size_t>(std::max(value.rows, 1));
  const std::size_t row = number % rows, col = number / rows;
  if (is_vector(kind)) return fmt::format("component [{}]", row);
  if (kind == Kind::matrix3 || kind == Kind::points) return fmt::format("entry ({},{})", row, col);
  if (kind == Kind::matrices) return fmt::format("entry ({},{}) of matrix [{}]", row, col % 3, col / 3);
  return "the result";
}

std::vector<std::string> aligned_on_point(const std::vector<std::string>& numbers) {
  std::size_t before = 0, after = 0;
  for (const std::string& number : numbers) {
    before = std::max(before, point_position(number));
    after = std::max(after, number.size() - point_position(number));
  }
  std::vector<std::string> aligned;
  for (const std::string& number : numbers)
    aligned.push_back(padded(padded("", before - point_position(number)) + number, before + after));
  return aligned;
}

}  // namespace workbook
