/// @file
/// Exponents as raised digits, for units and powers of ten.
#pragma once

#include <string>

namespace workbook {

/// "²" for 2, "⁻¹⁰" for −10.
std::string superscript(int exponent);

}  // namespace workbook
