/// @file
/// Formulas for terminals.
#pragma once

#include <string>

namespace workbook {

/// A text in Markdown whose formulas stand as TeX between Doxygen's marks, with each paragraph on one line and the
/// formulas in Unicode: "\f$ \tfrac12\vec\omega\cdot\vec L \f$" as "(1/2) ω·L", displays on lines of their own.
std::string with_readable_formulas(const std::string& markdown);

}  // namespace workbook
