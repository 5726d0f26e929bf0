/// @file
/// What is said to an instructor who hands out the course.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

std::string handout_needs_solutions();
std::string handout_needs_a_new_folder(const std::string& directory);
std::string handout_could_not_be_built();
std::string cannot_write_handout(const std::string& directory, const std::string& reason);
std::string handed_out(const std::string& directory, std::size_t lectures, std::size_t exercises);

}  // namespace workbook::messages
