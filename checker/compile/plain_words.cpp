#include "checker/base/text.hpp"
#include "checker/compile/diagnostics.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <regex>

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
  static const std::regex noun("(\\d+|n)×(\\d+|n) (?:row vector|vector|matrix)");
  static const std::regex name("(Row)?(Vector|Matrix)([1-4X])([1-4X])?[df]");
  const auto number = [](const std::string& size) { return size == "n" || size == "X" ? -1 : std::stoi(size); };
  std::smatch found;
  if (std::regex_search(type, found, noun)) return Shape{number(found[1]), number(found[2])};
  if (!std::regex_search(type, found, name)) return std::nullopt;
  const int size = number(found[3]);
  if (found[1].matched) return Shape{1, size};
  return Shape{size, found[2] == "Vector" ? 1 : found[4].matched ? number(found[4]) : size};
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
  if ((scalar != "double" && scalar != "float") || std::max(rows, columns) > 4 || (rows == 1 && columns == 1))
    return noun({rows, columns});
  if (columns == 1) return "Vector" + size(rows) + scalar[0];
  if (rows == 1) return "RowVector" + size(columns) + scalar[0];
  return "Matrix" + size(rows) + (rows == columns ? "" : size(columns)) + scalar[0];
}

/// A template whose arguments have been shortened.
std::string shortened(const std::string& name, const std::string& list) {
  std::vector<std::string> arguments;
  boost::split(arguments, boost::replace_all_copy(list, ", ", ","), [](char letter) { return letter == ','; });
  arguments.resize(std::max<std::size_t>(arguments.size(), 3));
  const auto is = [&](std::string_view names) { return names.find(" " + name + " ") != std::string_view::npos; };
  static const std::regex number("-?\\d{1,6}");
  const bool is_sized = std::regex_match(arguments[1], number) && std::regex_match(arguments[2], number);
  if (is(" Matrix Array ") && is_sized) return matrix(arguments[0], std::stoi(arguments[1]), std::stoi(arguments[2]));
  if (is(" Block ") && is_sized) return noun({std::stoi(arguments[1]), std::stoi(arguments[2])});
  const auto first = shape_of(arguments[0]), second = shape_of(arguments[1]), third = shape_of(arguments[2]);
  if (is(" Transpose ") && first) return noun({first->columns, first->rows});
  if (is(" Product ") && first && second && (first->columns == second->rows || first->columns * second->rows < 0))
    return noun({first->rows, second->columns});
  if (is(" CwiseBinaryOp ") && second && third)
    return noun({std::max(second->rows, third->rows), std::max(second->columns, third->columns)});
  if (is(" CwiseUnaryOp CwiseNullaryOp CwiseUnaryView Solve ") && second) return noun(*second);
  if (is(" VectorBlock ") && first && std::regex_match(arguments[1], number))
    return noun(first->rows == 1 ? Shape{1, std::stoi(arguments[1])} : Shape{std::stoi(arguments[1]), 1});
  if (is(" Map Ref Inverse ArrayWrapper MatrixWrapper NoAlias Reverse Select ") && first) return noun(*first);
  std::string shown = name == "vector" ? arguments[0] : list;
  std::ranges::replace(shown, ',', comma_mark);
  return name + open_mark + (shown.size() > 40 ? "…" : shown) + close_mark;
}

}  // namespace

std::string in_plain_words(std::string_view text) {
  constexpr std::size_t longest = 2000;  // std::regex recurses over the length of its text
  static const std::regex noise(R"(\b(class|struct) (?=\w*::)| \[-fpermissive\]| \[with [^\]]*\])");
  static const std::regex innermost(R"((?:Eigen::)?(?!operator\b)\b(\w+)<([^<>]*?) ?>(::)?)");
  static const std::regex aka(R"('[^']*' \{aka '([^']*)'\}|'[^'{]* \{aka ([^'}]*)\}')");
  static const std::regex constant(R"((\w[\w:]*(?:\x01[\w:]+\x02)?) const&)");
  static const std::regex name(R"(\bEigen::(?=(Row)?(Vector|Matrix)[234X]+[df]\b))");
  std::string plain = std::regex_replace(cut(text, longest), noise, "");
  for (std::smatch found; std::regex_search(plain, found, innermost);) {
    // A member of a template, A<…>::B, has not the shape of A.
    const std::string type =
        found[3].matched ? found[1].str() + open_mark + "…" + close_mark + "::" : shortened(found[1], found[2]);
    plain.replace(static_cast<std::size_t>(found.position()), static_cast<std::size_t>(found.length()), type);
  }
  plain = std::regex_replace(std::regex_replace(plain, aka, "'$1$2'"), constant, "const $1&");
  std::ranges::replace(plain, open_mark, '<');
  std::ranges::replace(plain, close_mark, '>');
  std::ranges::replace(plain, comma_mark, ',');
  return std::regex_replace(plain, name, "");
}

}  // namespace workbook
