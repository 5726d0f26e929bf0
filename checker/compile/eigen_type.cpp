#include "checker/compile/eigen_type.hpp"

#include "checker/messages/compiling.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace workbook {
namespace {

constexpr int deepest = 40;  // no type that a student means is nested deeper

void drop_prefix(std::string_view& text, std::string_view prefix) {
  if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '&' || text.back() == '*')) text.remove_suffix(1);
  if (text.ends_with(" const")) text.remove_suffix(6);
  for (const std::string_view word : {"const ", "class ", "struct ", "Eigen::"}) drop_prefix(text, word);
  return text;
}

TypeName read(std::string_view text, int depth) {
  text = trimmed(text);
  const std::size_t open = text.find('<');
  if (open == std::string_view::npos || text.back() != '>' || depth > deepest) return {std::string(text), {}};
  TypeName type{std::string(text.substr(0, open)), {}};
  int level = 0;
  std::size_t begin = open + 1;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char letter = text[at];
    if (letter == '<' || letter == '(') ++level;
    const bool ends_all = letter == '>' && level == 0;
    if (ends_all && at + 1 != text.size()) return {std::string(text), {}};  // a member of a template, A<…>::B<…>
    if ((letter == ',' && level == 0) || ends_all) {
      type.arguments.push_back(read(text.substr(begin, at - begin), depth + 1));
      begin = at + 1;
    }
    if ((letter == '>' || letter == ')') && level > 0) --level;
  }
  return type;
}

std::optional<int> number(const TypeName& type) {
  int value = 0;
  const char* const end = type.name.data() + type.name.size();
  const auto [stop, error] = std::from_chars(type.name.data(), end, value);
  if (error != std::errc() || stop != end || !type.arguments.empty()) return std::nullopt;
  return value;
}

std::optional<Shape> shape_from(const TypeName& type, std::size_t rows_at) {
  if (type.arguments.size() < rows_at + 2) return std::nullopt;
  const std::optional<int> rows = number(type.arguments[rows_at]);
  const std::optional<int> columns = number(type.arguments[rows_at + 1]);
  if (!rows || !columns) return std::nullopt;
  return Shape{*rows, *columns};
}

std::optional<int> size_letter(char letter) {
  if (letter == 'X') return -1;
  if (letter >= '2' && letter <= '4') return letter - '0';
  return std::nullopt;
}

/// "Vector3d", "RowVectorXd", "Matrix3Xd".
std::optional<Shape> shape_of_short_name(std::string_view name) {
  if (name.size() < 2 || name.back() != 'd') return std::nullopt;
  name.remove_suffix(1);
  const auto sizes_behind = [&](std::string_view prefix) -> std::string_view {
    return name.starts_with(prefix) ? name.substr(prefix.size()) : std::string_view();
  };
  if (const std::string_view size = sizes_behind("Vector"); size.size() == 1)
    if (const auto rows = size_letter(size[0])) return Shape{*rows, 1};
  if (const std::string_view size = sizes_behind("RowVector"); size.size() == 1)
    if (const auto columns = size_letter(size[0])) return Shape{1, *columns};
  if (const std::string_view size = sizes_behind("Matrix"); size.size() == 1 || size.size() == 2) {
    const auto rows = size_letter(size.front());
    const auto columns = size_letter(size.back());
    if (rows && columns) return Shape{*rows, *columns};
  }
  return std::nullopt;
}

std::string size_text(int size) { return size < 0 ? "X" : std::to_string(size); }

bool one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

TypeName read_type(std::string_view text) { return read(text, 0); }

std::optional<Shape> shape_of(const TypeName& type) {
  const std::string& name = type.name;
  const auto argument = [&](std::size_t i) -> std::optional<Shape> {
    if (i >= type.arguments.size()) return std::nullopt;
    return shape_of(type.arguments[i]);
  };
  if (type.arguments.empty()) return shape_of_short_name(name);
  if (one_of(name, {"Matrix", "Array", "Block"})) return shape_from(type, 1);
  if (one_of(name, {"Map", "Ref", "Inverse", "ArrayWrapper", "MatrixWrapper", "NoAlias", "MatrixBase", "DenseBase",
                    "PlainObjectBase", "Reverse", "TriangularView", "SelfAdjointView", "Select"}))
    return argument(0);
  if (one_of(name, {"CwiseUnaryOp", "CwiseNullaryOp", "CwiseUnaryView"})) return argument(1);
  if (name == "Transpose") {
    const std::optional<Shape> shape = argument(0);
    return shape ? std::optional(shape->transposed()) : std::nullopt;
  }
  if (name == "VectorBlock") {
    const std::optional<Shape> whole = argument(0);
    const std::optional<int> size = type.arguments.size() > 1 ? number(type.arguments[1]) : std::nullopt;
    if (!whole || !size) return std::nullopt;
    return whole->rows == 1 ? Shape{1, *size} : Shape{*size, 1};
  }
  if (name == "CwiseBinaryOp") {
    const std::optional<Shape> left = argument(1);
    const std::optional<Shape> right = argument(2);
    if (!left || !right) return std::nullopt;
    return Shape{std::max(left->rows, right->rows), std::max(left->columns, right->columns)};
  }
  if (name == "Product") {
    const std::optional<Shape> left = argument(0);
    const std::optional<Shape> right = argument(1);
    if (!left || !right) return std::nullopt;
    const bool fits = left->columns == right->rows || left->columns < 0 || right->rows < 0;
    return fits ? std::optional(Shape{left->rows, right->columns}) : std::nullopt;
  }
  return std::nullopt;
}

bool is_number(const TypeName& type) {
  return type.arguments.empty() && one_of(type.name, {"double", "float", "int", "long", "long int", "unsigned int",
                                                      "long unsigned int", "std::size_t", "size_t", "Index", "bool",
                                                      "long double", "short int", "char", "double&", "int&"});
}

std::string noun_for(const TypeName& type) {
  if (is_number(type)) return messages::number_noun();
  const std::optional<Shape> shape = shape_of(type);
  return shape ? messages::matrix_noun(shape->rows, shape->columns) : std::string();
}

std::string short_name(const TypeName& type) {
  if (type.name != "Matrix") return shape_of_short_name(type.name) ? type.name : "";
  const std::optional<Shape> shape = shape_of(type);
  if (!shape || type.arguments.front().name != "double") return {};
  const auto [rows, columns] = *shape;
  const auto has_letter = [](int size) { return size < 0 || (size >= 2 && size <= 4); };
  if (columns == 1 && has_letter(rows)) return "Vector" + size_text(rows) + "d";
  if (rows == 1 && has_letter(columns)) return "RowVector" + size_text(columns) + "d";
  if (rows == columns && has_letter(rows)) return "Matrix" + size_text(rows) + "d";
  if ((rows < 0 || columns < 0) && has_letter(rows) && has_letter(columns))
    return "Matrix" + size_text(rows) + size_text(columns) + "d";
  return {};
}

}  // namespace workbook
