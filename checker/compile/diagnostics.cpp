#include "checker/compile/diagnostics.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <regex>
#include <sstream>
#include <string_view>

namespace workbook {
namespace {

bool contains_any(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return text.find(part) != std::string_view::npos; });
}

/// Eigen puts its advice into the names of static assertions: YOU_MIXED_VECTORS_OF_DIFFERENT_SIZES.
std::string readable(std::string text) {
  static const std::regex shouted("static assertion failed: ([A-Z][A-Z_]{8,}[A-Z])");
  std::smatch found;
  if (!std::regex_search(text, found, shouted)) return text;
  std::string words = found[1];
  for (char& letter : words)
    letter = letter == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return "Eigen says: " + words;
}

}  // namespace

std::optional<FirstError> first_error(const std::string& output, const std::string& file_name) {
  // "name:12:5: error: …", and, where the error itself is inside a header, "name:12:5:   required from here".
  static const std::regex place("^:(\\d+):(?:\\d+:)?(.*)$");
  static const std::regex error("(?:fatal )?error: (.*)$");
  int line_before = 0;
  std::optional<FirstError> first;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 2000) line.resize(2000);  // std::regex recurses over the length of its text
    std::smatch found;
    const bool in_file = line.starts_with(file_name);
    const std::string rest = in_file ? line.substr(file_name.size()) : std::string();
    const bool placed = in_file && std::regex_match(rest, found, place);
    const int number = placed ? std::stoi(found[1].str().substr(0, 9)) : 0;
    std::smatch message;
    if (std::regex_search(line, message, error)) {
      if (first) return first;
      first = FirstError{placed ? number : line_before, readable(message[1])};
      if (first->line > 0) return first;
    } else if (placed && line.find("required from here") != std::string::npos) {
      line_before = number;
      if (first) {
        first->line = number;
        return first;
      }
    }
  }
  return first;
}

bool ran_out_of_memory(const std::string& output) {
  return contains_any(output, {"out of memory", "virtual memory exhausted", "Killed signal terminated program",
                               "memory exhausted", "Cannot allocate memory"});
}

bool grew_too_large(const std::string& output) {
  return contains_any(output, {"File too large", "File size limit exceeded"});
}

}  // namespace workbook
