/// @file
/// Where gnuplot is.
#pragma once

#include <string>

namespace workbook {

/// The path of gnuplot as found on PATH; "" if it is not installed.
std::string gnuplot_program();

}  // namespace workbook
