/// @file
/// The words around a verdict on the terminal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::messages {

std::string your_code_printed();
std::string the_compiler_says();
std::string plot_label();
std::string building();
std::string more_lines(std::size_t count);

/// "6 of 8 passed, 1 to mend, 1 not started."
std::string summary(std::size_t total, std::size_t passed, std::size_t wrong, std::size_t not_started,
                    std::size_t errors);

/// An unknown --case; `proposal` may be empty.
std::string no_such_case(const std::string& exercise, const std::string& name, const std::string& proposal,
                         const std::vector<std::string>& known);

std::string case_needs_one_exercise();
std::string file_needs_one_exercise(const std::string& command);
std::string nothing_started();

}  // namespace workbook::messages
