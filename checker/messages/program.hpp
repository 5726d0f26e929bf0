/// @file
/// How the program is called in what it says.
#pragma once

#include <string>

namespace workbook::messages {

/// The program as it was typed: checker/run says so in WORKBOOK_PROGRAM; else "checker".
std::string program_name();

/// What to type for a command of the program: "./checker/run hint inertia_of_points".
std::string command(const std::string& arguments);

}  // namespace workbook::messages
