/// @file
/// What the compiler printed, taken apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace workbook {

enum class Severity { error, warning };

/// A place in the student's file; line 0: none.
struct Place {
  int line = 0;
  int column = 0;  ///< as terminals show it, from 1, with a tab stop every eight; 0 if the compiler names none
};

/// One error or warning.
struct Diagnostic {
  Severity severity = Severity::error;
  Place place;         ///< in the student's file: of the error itself, or of the line that led to it
  std::string header;  ///< the file with the error, if that is not the student's
  std::string text;
  std::string option;                ///< "-Wreturn-type"
  std::vector<std::string> context;  ///< which templates led to it, the innermost first
  std::vector<std::string> notes;
};

/// All errors and warnings, in the compiler's order.
/// @param output     what the compiler printed
/// @param file_name  the name under which the student knows the file
std::vector<Diagnostic> diagnostics(const std::string& output, const std::string& file_name);

/// True if the compiler stopped because its memory was used up.
bool ran_out_of_memory(const std::string& output);

/// True if it stopped because what it made grew too large.
bool grew_too_large(const std::string& output);

}  // namespace workbook
