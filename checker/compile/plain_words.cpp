#include "checker/base/text.hpp"
#include "checker/compile/diagnostics.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>

namespace workbook {
namespace {

// What stands for < > and a comma in what has been shortened.
constexpr char open_mark = '\x01';
constexpr char close_mark = '\x02';
constexpr char comma_mark = '\x03';

/// Rows and columns; −1 where they are known at run time only.
struct Shape {
  int rows = 0;
  int columns = 0;
};

/// "3×1 vector", "Matrix3d", "const RowVector3d&"
std::optional<Shape> shape_of(const std::string& type) {
  const auto number = [](const std::string& size) { return size == "n" || size == "X" ? -1 : std::stoi(size); };
  if (const Match noun = search(type, "(\\d{1,6}|n)×(\\d{1,6}|n) (?:row vector|vector|matrix)"))
    return Shape{number(noun[1]), number(noun[2])};
  const Match name = search(type, "(Row)?(Vector|Matrix)([1-4X])([1-4X])?[dfi]");
  if (!name) return std::nullopt;
  const int size = number(name[3]);
  if (!name[1].empty()) return Shape{1, size};
  return Shape{size, name[2] == "Vector" ? 1 : name[4].empty() ? size : number(name[4])};
}

std::string noun(Shape shape) {
  const auto size = [](int count) { return count < 0 ? "n" : std::to_string(count); };
  return fmt::format("{}×{} {}", size(shape.rows), size(shape.columns),
                     shape.columns == 1 && shape.rows != 1   ? "vector"
                     : shape.rows == 1 && shape.columns != 1 ? "row vector"
                                                             : "matrix");
}

/// Eigen::Matrix<double, 3, 1>, or one that it has no name for.
std::string matrix(const std::string& scalar, int rows, int columns) {
  const auto size = [](int count) { return count < 0 ? "X" : std::to_string(count); };
  if ((scalar != "double" && scalar != "float" && scalar != "int") || std::max(rows, columns) > 4 ||
      (rows == 1 && columns == 1))
    return noun({rows, columns});
  if (columns == 1) return "Vector" + size(rows) + scalar[0];
  if (rows == 1) return "RowVector" + size(columns) + scalar[0];
  return "Matrix" + size(rows) + (rows == columns ? "" : size(columns)) + scalar[0];
}

/// A template whose arguments have been shortened.
std::string plain_template(const std::string& name, const std::string& list) {
  std::vector<std::string> arguments;
  boost::split(arguments, boost::replace_all_copy(list, ", ", ","), [](char letter) { return letter == ','; });
  arguments.resize(std::max<std::size_t>(arguments.size(), 3));
  const auto is = [&](std::string_view names) { return names.find(" " + name + " ") != std::string_view::npos; };
  const auto is_number = [](const std::string& text) { return bool{search(text, "^-?\\d{1,6}$")}; };
  const bool is_sized = is_number(arguments[1]) && is_number(arguments[2]);
  if (is(" Matrix Array ") && is_sized) return matrix(arguments[0], std::stoi(arguments[1]), std::stoi(arguments[2]));
  if (is(" Block ") && is_sized) return noun({std::stoi(arguments[1]), std::stoi(arguments[2])});
  const auto first = shape_of(arguments[0]), second = shape_of(arguments[1]), third = shape_of(arguments[2]);
  if (is(" Transpose ") && first) return noun({first->columns, first->rows});
  if (is(" Product ") && first && second && (first->columns == second->rows || first->columns * second->rows < 0))
    return noun({first->rows, second->columns});
  if (is(" CwiseBinaryOp ") && second && third)
    return noun({std::max(second->rows, third->rows), std::max(second->columns, third->columns)});
  if (is(" CwiseUnaryOp CwiseNullaryOp CwiseUnaryView Solve ") && second) return noun(*second);
  if (is(" VectorBlock ") && first && is_number(arguments[1]))
    return noun(first->rows == 1 ? Shape{1, std::stoi(arguments[1])} : Shape{std::stoi(arguments[1]), 1});
  if (is(" Map Ref Inverse ArrayWrapper MatrixWrapper NoAlias Reverse Select ") && first) return noun(*first);
  std::string shown = name == "vector" ? arguments[0] : list;
  std::ranges::replace(shown, ',', comma_mark);
  return name + open_mark + (shown.size() > 40 ? "…" : shown) + close_mark;
}

}  // namespace

std::string in_plain_words(std::string_view text) {
  constexpr std::size_t longest = 12000;
  std::string plain =
      replaced(cut(text, longest), R"(\b(class|struct) (?=\w*::)| \[-fpermissive\]| \[with [^\]]*\])", "");
  constexpr const char* innermost = R"((?:Eigen::)?(?!operator\b)\b(\w+)<([^<>]*?) ?>(::)?)";
  while (const Match found = search(plain, innermost)) {
    // A member of a template, A<…>::B, has not the shape of A.
    const std::string type =
        found[3].empty() ? plain_template(found[1], found[2]) : found[1] + open_mark + "…" + close_mark + "::";
    plain.replace(found.offsets[0], found[0].size(), type);
  }
  plain = replaced(plain, R"('[^']*' \{aka '([^']*)'\}|'[^'{]* \{aka ([^'}]*)\}')", "'$1$2'");
  plain = replaced(plain, R"((\w[\w:]*(?:\x01[\w:]+\x02)?) const&)", "const $1&");
  std::ranges::replace(plain, open_mark, '<');
  std::ranges::replace(plain, close_mark, '>');
  std::ranges::replace(plain, comma_mark, ',');
  plain = replaced(plain, R"((?:Eigen::)?MatrixBase<…>::cross_product_return_type<…>::type)", "3×1 vector");
  return replaced(plain, R"(\bEigen::(?=(Row)?(Vector|Matrix)[234X]+[dfi]\b))", "");
}

}  // namespace workbook
