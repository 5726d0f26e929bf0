#include "checker/data/value.hpp"

#include "checker/messages/reference_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace workbook {

namespace {

using messages::ListOf;
using nlohmann::json;

constexpr std::array<std::pair<Kind, const char*>, 8> kind_names = {{{Kind::number, "number"},
                                                                     {Kind::integer, "integer"},
                                                                     {Kind::vector2, "vector2"},
                                                                     {Kind::vector3, "vector3"},
                                                                     {Kind::vector, "vector"},
                                                                     {Kind::matrix3, "matrix3"},
                                                                     {Kind::points, "points"},
                                                                     {Kind::matrices, "matrices"}}};

// --- writing

json number_to_json(double number, Kind kind) {
  if (!std::isfinite(number)) return nullptr;
  const bool is_whole = number == std::trunc(number) && std::abs(number) < 9e15;
  if (kind == Kind::integer && is_whole) return static_cast<std::int64_t>(number);
  return number;
}

json rows_to_json(const Value& value, int first_col, int cols) {
  json rows = json::array();
  for (int row = 0; row < value.rows; ++row) {
    json entries = json::array();
    for (int col = first_col; col < first_col + cols; ++col) {
      entries.push_back(number_to_json(value.at(row, col), Kind::number));
    }
    rows.push_back(std::move(entries));
  }
  return rows;
}

// --- reading

double number_from_json(const json& part, Kind kind = Kind::number) {
  if (part.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (!part.is_number()) {
    throw std::invalid_argument(messages::expected_number(part.type_name()));
  }
  const double number = part.get<double>();
  if (kind == Kind::integer && number != std::trunc(number)) {
    throw std::invalid_argument(messages::expected_whole_number(part.dump()));
  }
  return number;
}

const json& list_from_json(const json& part, ListOf what) {
  if (!part.is_array()) throw std::invalid_argument(messages::expected_list_of(what, part.type_name()));
  return part;
}

void require_length(const json& list, std::size_t length, ListOf what) {
  if (list_from_json(list, what).size() == length) return;
  throw std::invalid_argument(messages::expected_list_of(what, list.size()));
}

void require_row(const json& row, std::size_t length) {
  if (!row.is_array()) throw std::invalid_argument(messages::expected_row(length, row.type_name()));
  if (row.size() != length) throw std::invalid_argument(messages::expected_row(length, row.size()));
}

Value vector_from_json(const json& list) {
  Value value{static_cast<int>(list.size()), 1, {}};
  for (const json& entry : list) value.numbers.push_back(number_from_json(entry));
  return value;
}

Value three_rows_from_json(const json& rows) {
  require_length(rows, 3, ListOf::three_rows);
  const std::size_t cols = list_from_json(rows[0], ListOf::three_rows).size();
  for (const json& row : rows) require_row(row, cols);
  Value value{3, static_cast<int>(cols), {}};
  for (std::size_t col = 0; col < cols; ++col) {
    for (std::size_t row = 0; row < 3; ++row) value.numbers.push_back(number_from_json(rows[row][col]));
  }
  return value;
}

Value matrix3_from_json(const json& rows) {
  Value value = three_rows_from_json(rows);
  if (value.cols != 3) throw std::invalid_argument(messages::expected_square(value.cols));
  return value;
}

Value matrices_from_json(const json& list) {
  Value side_by_side{3, 0, {}};
  for (const json& rows : list_from_json(list, ListOf::matrices)) {
    const Value matrix = matrix3_from_json(rows);
    side_by_side.cols += 3;
    side_by_side.numbers.insert(side_by_side.numbers.end(), matrix.numbers.begin(), matrix.numbers.end());
  }
  return side_by_side;
}

}  // namespace

std::string to_string(Kind kind) {
  const auto* entry = std::ranges::find(kind_names, kind, &std::pair<Kind, const char*>::first);
  return entry->second;
}

Kind kind_from_string(const std::string& name) {
  for (const auto& [kind, kind_name] : kind_names) {
    if (name == kind_name) return kind;
  }
  throw std::invalid_argument(messages::unknown_kind(name));
}

bool is_finite(const Value& value) {
  return std::ranges::all_of(value.numbers, [](double number) { return std::isfinite(number); });
}

json to_json(const Value& value, Kind kind) {
  switch (kind) {
    case Kind::number:
    case Kind::integer:
      return number_to_json(value.numbers.at(0), kind);
    case Kind::vector2:
    case Kind::vector3:
    case Kind::vector: {
      json list = json::array();
      for (double number : value.numbers) list.push_back(number_to_json(number, kind));
      return list;
    }
    case Kind::matrix3:
    case Kind::points:
      return rows_to_json(value, 0, value.cols);
    case Kind::matrices: {
      json list = json::array();
      for (int col = 0; col + 3 <= value.cols; col += 3) list.push_back(rows_to_json(value, col, 3));
      return list;
    }
  }
  throw std::invalid_argument(messages::unknown_kind(std::to_string(static_cast<int>(kind))));
}

Value value_from_json(const json& part, Kind kind) {
  switch (kind) {
    case Kind::number:
    case Kind::integer:
      return {1, 1, {number_from_json(part, kind)}};
    case Kind::vector2:
      require_length(part, 2, ListOf::two_numbers);
      return vector_from_json(part);
    case Kind::vector3:
      require_length(part, 3, ListOf::three_numbers);
      return vector_from_json(part);
    case Kind::vector:
      return vector_from_json(list_from_json(part, ListOf::numbers));
    case Kind::matrix3:
      return matrix3_from_json(part);
    case Kind::points:
      return three_rows_from_json(part);
    case Kind::matrices:
      return matrices_from_json(part);
  }
  throw std::invalid_argument(messages::unknown_kind(std::to_string(static_cast<int>(kind))));
}

}  // namespace workbook
