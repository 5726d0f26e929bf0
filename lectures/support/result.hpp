/// @file
/// What a worked example prints for its page: results with a name, a value and a unit.
///
/// @code
/// TEST_CASE("energy: The tensor gives the energy that the points have") {
///   …
///   result("T", T, "J", "the same as the sum over the points");
/// @endcode
/// The word before the colon names the example: the page quotes all that it printed by \\computed{LECTURE,energy}.
/// Everything is written to the file named by the environment variable WORKBOOK_PRINTED, if it is set; each value also
/// with all its digits, for the test that compares it with numbers from elsewhere.
#pragma once

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace workbook {

/// Prints "name = value unit, remark".
/// @param name    a formula in TeX with the macros of the notes, such as R"(\vec L)"
/// @param unit    "kg m²"; "" for a pure number, "°" for an angle in degrees
/// @param remark  the rest of the sentence, without its full stop; may hold formulas between \( and \)
/// @param digits  that are shown, of those that matter
/// @throws std::domain_error if the value is not finite
void result(const std::string& name, double value, const std::string& unit, const std::string& remark = "",
            int digits = 3);

/// The same for a vector, printed as a row, or a matrix.
void result(const std::string& name, const Eigen::MatrixXd& value, const std::string& unit,
            const std::string& remark = "", int digits = 3);

/// Prints a table, a column of `values` below each head such as R"(error / J)"; heads may hold formulas as remarks do.
void result_table(const std::vector<std::string>& heads, const Eigen::MatrixXd& values, int digits = 3);

}  // namespace workbook
