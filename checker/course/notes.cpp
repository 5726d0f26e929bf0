#include "checker/course/notes.hpp"

#include <fstream>
#include <regex>

namespace workbook {

std::map<std::string, std::string> read_headings(const std::filesystem::path& notes) {
  static const std::regex heading(R"(^#+\s+(.*\S)\s*\{#(\w+)\}\s*$)");
  std::map<std::string, std::string> headings;
  std::ifstream in(notes);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, heading)) headings.emplace(match[2], match[1]);
  }
  return headings;
}

}  // namespace workbook
