/// @file
/// What compilers write about types, in the words of the contracts.
#pragma once

#include <string>
#include <string_view>

namespace workbook {

/// A C++ signature in the words of the contracts: "const Vector3d&" for "Eigen::Matrix<double, 3, 1, 0, 3, 1> const&".
std::string in_contract_words(std::string signature);

/// A compiler's message without what only authors of templates need: matrices by their short names, expressions as
/// "3×1 expression" (or "3×1 part" where they are a piece of a matrix), no "[with …]", no "{aka …}", other long
/// template arguments as "<…>".
std::string in_plain_words(std::string_view message);

}  // namespace workbook
