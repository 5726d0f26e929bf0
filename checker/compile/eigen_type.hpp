/// @file
/// Types of Eigen as compilers spell them in their messages, and what a student needs to know of them: their shape.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// A type taken apart: "const Eigen::Transpose<Eigen::Matrix<double, 3, 1> >".
struct TypeName {
  std::string name;  ///< without namespace Eigen, const and reference: "Transpose"; a number stands for itself
  std::vector<TypeName> arguments;
};

/// Reads a type; what is no type gives some name without arguments.
TypeName read_type(std::string_view text);

/// Rows and columns; −1 where they are known at run time only.
struct Shape {
  int rows = 0;
  int columns = 0;

  bool operator==(const Shape&) const = default;
  Shape transposed() const { return {columns, rows}; }
};

/// The shape of a matrix or of an expression of Eigen; nothing for other types, and for those that fit together badly.
std::optional<Shape> shape_of(const TypeName& type);

/// True for the arithmetic types of C++.
bool is_number(const TypeName& type);

/// "number", "3×1 vector", "1×3 row vector", "3×3 matrix", "matrix"; empty for other types.
std::string noun_for(const TypeName& type);

/// The name that the contracts use for a matrix type, "Vector3d"; empty for other types.
std::string short_name(const TypeName& type);

}  // namespace workbook
