/// @file
/// Text that people read, compared with golden files. To rewrite them: WORKBOOK_REWRITE_GOLDEN=1 tests/run -R judging
#pragma once

#include <filesystem>
#include <string>

namespace workbook::testing {

/// Fails the running test case at the first line that differs. The difference of a rewritten file is to be read like a
/// change of code.
void compare_with_golden(const std::filesystem::path& file, const std::string& text);

}  // namespace workbook::testing
