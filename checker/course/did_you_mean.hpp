/// @file
/// The nearest known name to a mistyped one.
#pragma once

#include <string>
#include <vector>

namespace workbook {

/// The known name with the fewest letters to change; empty if none is near enough to be meant.
std::string did_you_mean(const std::string& typed, const std::vector<std::string>& known);

}  // namespace workbook
