/// @file
/// What an object file or a program would make other tools do, read without running any.
#pragma once

#include <filesystem>
#include <string_view>

namespace workbook {

/// Does an object file of this machine have a section whose name begins like that? True as well for a file that cannot
/// be understood.
bool has_section(const std::filesystem::path& object, std::string_view beginning);

/// Does a program ask the system to start another one, its interpreter, in its place?
bool has_interpreter(const std::filesystem::path& program);

}  // namespace workbook
