/// @file
/// Bytes as text, for terminals and pages that take nothing else.
#pragma once

#include <string>
#include <string_view>

namespace workbook {

/// Base64 with its closing "=" signs and without line breaks.
std::string base64(std::string_view bytes);

}  // namespace workbook
