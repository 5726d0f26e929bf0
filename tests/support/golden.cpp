#include "tests/support/golden.hpp"

#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>
#include <string_view>

namespace workbook::testing {

void compare_with_golden(const std::filesystem::path& file, const std::string& text) {
  const char* rewrite = std::getenv("WORKBOOK_REWRITE_GOLDEN");
  if (rewrite != nullptr && std::string_view(rewrite) == "1") {
    write(file, text);
    MESSAGE("rewritten: " << file.string());
    return;
  }
  const std::string golden = read(file);  // nothing if there is no such file
  if (golden == text) return;
  std::istringstream golden_lines(golden);
  std::istringstream lines(text);
  const auto next = [](std::istream& in) {
    std::string line;
    return std::getline(in, line) ? line : "(the end)";
  };
  for (int number = 1;; ++number) {
    const std::string expected = next(golden_lines);
    const std::string actual = next(lines);
    const bool have_both_ended = !golden_lines && !lines;  // then the last line end is the difference
    if (expected == actual && !have_both_ended) continue;
    ADD_FAIL_CHECK_AT(file.c_str(), number, "in the file: " << expected << "\nnow:         " << actual);
    return;
  }
}

}  // namespace workbook::testing
