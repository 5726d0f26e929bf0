/// @file
/// No student's code is run by an administrator.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace workbook {

/// Who grades into a folder: this user; or where that is root the owner that the folder has from an earlier run, or
/// else a user whom nobody is.
uid_t grading_user(const std::filesystem::path& folder);

/// Where this program runs as root: hands the folder over to the user who grades, and becomes that user for good.
/// @param needed  must be readable to everybody. @throws GradingError if that cannot be
void give_up_root(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& needed);

}  // namespace workbook
