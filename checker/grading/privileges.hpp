/// @file
/// No student's code is run by an administrator.
#pragma once

#include <filesystem>
#include <vector>

namespace workbook {

/// Where this program runs as root: hands the folder over to a user whom nobody is, and becomes that user for good.
/// @param needed  must be readable to everybody. @throws GradingError if that cannot be
void give_up_root(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& needed);

}  // namespace workbook
