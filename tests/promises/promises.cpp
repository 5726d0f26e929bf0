// README promises what is tested here, and nothing else.
#include "checker/base/text.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace workbook::testing;

TEST_CASE("each promise of README is the beginning of a title here, and each such title is promised") {
  const std::filesystem::path project = WORKBOOK_ROOT;
  const std::string readme = read(project / "README.md");
  const std::size_t begin = readme.find("## What is promised"), end = readme.find("\n## ", begin + 1);
  REQUIRE(end != std::string::npos);
  std::set<std::string> promised, tested;
  for (const auto& line : workbook::search_all(readme.substr(begin, end - begin), R"(\n- ([A-Z].*)\.)"))
    promised.insert(line[1]);
  CHECK(promised.size() > 8);
  for (const auto& file : files_below(project / "tests/promises"))
    for (const auto& title : workbook::search_all(read(file), R"re(TEST_CASE\("([A-Z][^":.]*))re"))
      tested.insert(title[1]);
  CHECK(promised == tested);
}
