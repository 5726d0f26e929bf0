// The numbers that this project did not make, as one table: `ctest -R outside_cases -V` shows it. Each row is printed
// by a worked example just behind the check that reaches it, so a row stands here only if its check passed.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Row {
  std::string expected, ours, tolerance, lecture;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

std::map<std::string, Row> read_rows(const std::filesystem::path& directory) {
  std::map<std::string, Row> rows;
  for (const auto& file : std::filesystem::directory_iterator(directory)) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      if (line.size() < 4 || line[0] != 'V' || line.find(" | ") == std::string::npos) continue;
      std::vector<std::string> columns;
      std::istringstream parts(line);
      for (std::string part; std::getline(parts, part, '|');) columns.push_back(trimmed(part));
      REQUIRE_MESSAGE(columns.size() == 4, line);
      rows[columns[0]] = {columns[1], columns[2], columns[3], file.path().stem().string()};
    }
  }
  return rows;
}

}  // namespace

TEST_CASE("every case from an outside source is reached by a worked example") {
  const auto rows = read_rows(WORKBOOK_PRINTED_DIRECTORY);
  fmt::print("case | expected | ours | tolerance | lecture\n");
  for (const auto& [id, row] : rows)
    fmt::print("{} | {} | {} | {} | {}\n", id, row.expected, row.ours, row.tolerance, row.lecture);

  for (const char* id : {"V01", "V02", "V03", "V04", "V06", "V10", "V11", "V16", "V20", "V26", "V27", "V35", "V36",
                         "V39", "V43", "V44", "V46", "V49"}) {
    CHECK_MESSAGE(rows.contains(id), id);
  }
}
