/// @file
/// The hints of an exercise, weakest first.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// The file of hints cannot be used; one sentence.
struct HintError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The hints of a file, which are separated by lines of three dashes. @throws HintError if it is missing or holds none.
std::vector<std::string> read_hints(const std::filesystem::path& file);

}  // namespace workbook
