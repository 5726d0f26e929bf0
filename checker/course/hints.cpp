#include "checker/course/hints.hpp"

#include <fmt/format.h>

#include <fstream>

namespace workbook {

std::vector<std::string> read_hints(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw HintError(fmt::format("{}: missing; take the file from the workbook again.", file.string()));
  std::vector<std::string> hints(1);
  for (std::string line; std::getline(in, line);) {
    if (line == "---") {
      hints.emplace_back();
    } else {
      hints.back() += line + "\n";
    }
  }
  for (std::string& hint : hints) {
    const std::size_t first = hint.find_first_not_of('\n');
    const std::size_t last = hint.find_last_not_of('\n');
    hint = first == std::string::npos ? "" : hint.substr(first, last - first + 1);
  }
  std::erase(hints, "");
  if (hints.empty())
    throw HintError(fmt::format("{}: there is no hint in it; write three, weakest first.", file.string()));
  return hints;
}

}  // namespace workbook
