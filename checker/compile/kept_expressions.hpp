/// @file
/// `auto x = a + b;` keeps an expression of Eigen, not its value. The compiler itself is asked where that happens: in a
/// copy of the file each `auto` demands a type that holds its own value.
#pragma once

#include "checker/compile/diagnostics.hpp"
#include "checker/data/observation.hpp"

#include <string>
#include <vector>

namespace workbook {

/// The copy to compile. Lines stay where they are.
struct DemandingCopy {
  std::string before;                ///< to stand before the first line
  std::string source;                ///< empty if there is no `auto` to ask about
  std::vector<std::size_t> offsets;  ///< of each `auto` that demands, in the student's own text
};

DemandingCopy demanding_copy(const std::string& source);

/// The variables and functions that keep an expression, from what the compiler said about the copy.
std::vector<Finding> kept_expressions(const std::vector<Diagnostic>& found, const DemandingCopy& copy,
                                      const std::string& source);

}  // namespace workbook
