/// @file
/// The compiler's and the linker's messages, read for the one sentence that helps most.
#pragma once

#include <optional>
#include <string>

namespace workbook {

/// The first error of a compilation.
struct FirstError {
  int line = 0;  ///< in the student's file; 0 if the compiler names none
  std::string text;
};

/// @param output     what the compiler printed
/// @param file_name  the name under which the student knows the file
std::optional<FirstError> first_error(const std::string& output, const std::string& file_name);

/// True if the compiler stopped because its memory was used up.
bool ran_out_of_memory(const std::string& output);

/// True if it stopped because what it made grew too large.
bool grew_too_large(const std::string& output);

}  // namespace workbook
