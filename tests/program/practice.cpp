// What is told of a problem, where an editor finds it, and a function on real data. Other practice is told in stories.
#include "checker/base/formulas.hpp"
#include "checker/base/text.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace workbook::testing;

TEST_CASE("no TeX is left in any derivation of the course as a terminal shows it") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(fmt::format("{}/solutions", WORKBOOK_ROOT)))
    if (entry.path().parent_path().filename() == "derivations")
      CHECK_MESSAGE(!has(workbook::with_readable_formulas(read(entry.path())), "\\"), entry.path().string());
}

TEST_CASE("a problem tells where it fails, then a region, then the mistake by name; or all after a hint") {
  CourseCopy().check_story("problem");
}

TEST_CASE("after a pass a function is shown on real data, with errors where they are known; it decides nothing") {
  CourseCopy().check_story("real_data");
}

TEST_CASE("an editor finds each reason at its line and column, and one without a line at the first") {
  const CourseCopy course;
  const auto tasks = nlohmann::json::parse(read(std::filesystem::path(WORKBOOK_ROOT) / ".vscode/tasks.json"));
  const nlohmann::json& task = tasks["tasks"][0];
  const std::string file = "spring_energy.cpp", name = "${fileBasenameNoExtension}", base = "${fileBasename}";
  std::string typed = task["command"];
  REQUIRE(typed.starts_with("./checker/run check " + name + " | "));
  typed.erase(0, typed.find(" | "));
  typed.replace(typed.find(base), base.size(), file);
  const nlohmann::json& pattern = task["problemMatcher"]["pattern"];
  const auto found_in = [&](const std::string& screen) {
    std::string found;
    for (const std::string& line : workbook::lines_of(screen))
      if (const workbook::Match match = workbook::search(line, pattern["regexp"].get<std::string>());
          match && found.empty())
        for (const char* part : {"file", "line", "column", "message"})
          found += match[pattern[part].get<std::size_t>()] + " ";
    INFO(screen);
    CHECK(!found.empty());
    return found;
  };
  const auto problem = [&](const std::string& body) {
    course.answer_energy(body);
    return found_in(course.run("check spring_energy" + typed, "COLUMNS=1000").out);
  };
  CHECK(problem("return k * x.squaredNorm() / y;").starts_with(file + " 4 30 `y`"));                 // no program
  CHECK(problem("return 1 / 2 * k * x.squaredNorm();").starts_with(file + " 4 8 `1/2`"));            // in the code
  CHECK(problem("return k * x.squaredNorm();").starts_with(file + " 1 1 "));                         // in the values
  CHECK(problem("return k * x[3];").starts_with(file + " 4 1 an index"));                            // an exception
  CHECK(problem("return *static_cast<double*>(nullptr);").starts_with(file + " 4 1 "));              // a crash
  CHECK(problem("return k + std::exp(x[0]) * 3.7 - std::cbrt(x[1]);").starts_with(file + " 1 1 "));  // without reason
  // The same mistake in two lines stands at the first one.
  CHECK(found_in("  Why    spring_energy.cpp:4:9, 5:9: A double") == file + " 4 9 A double ");
}
