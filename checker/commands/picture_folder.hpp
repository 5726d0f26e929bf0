/// @file
/// The folder that pictures are written to.
#pragma once

#include <filesystem>

namespace workbook {

/// Makes the folder if need be. Where it cannot be written to, says so in one sentence on standard error and returns
/// false.
bool make_picture_folder(const std::filesystem::path& directory);

}  // namespace workbook
