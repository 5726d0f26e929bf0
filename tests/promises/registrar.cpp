// The registrar: marks that can be taken over as they are.
#include "tests/grading/made_up_class.hpp"

#include "checker/grading/grading.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <sys/stat.h>

#include <numeric>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

const std::string wrong = energy_text("return 0;");

}  // namespace

TEST_SUITE_BEGIN("registrar" * doctest::skip(!is_open_to_all()));

TEST_CASE("Nobody gets a zero in silence.") {
  const MadeUpClass all;
  for (const char* path : {"ada/spring_energy.cpp", "bob/spring_energy.cpp", "cleo_1_2_spring_energy.cpp"})
    write(all.submissions() / path, energy_text("throw NotStarted{};"));
  write(all.submissions() / "bob_123_456_spring_force.cpp", force_text(right_force));  // another entry
  write(all.submissions() / "cleo_1_3_spring_energy.cpp", wrong);                      // the same file of two
  write(all.root() / "roster.csv", "id\nada\nbob\ncleo\ndora\n");
  write(all.submissions() / "dora.zip", "torn");
  const Outcome graded = all.grade("out", "--roster roster.csv");
  REQUIRE_MESSAGE(graded.status == 1, graded.said());
  CHECK(has(graded.out, "3 of 4 students of the roster handed in; 3 not read or not judged"));
  const auto document = nlohmann::json::parse(read(all.root() / "out/class.json"));
  CHECK(document.at("missing") == nlohmann::json{"dora"});
  CHECK(document.at("not_judged").empty());  // the checker has no error
  for (const char* id : {"bob", "cleo"}) {
    CHECK(all.student(id).at("results").at(0).at("verdict") == "checker_error");
    CHECK(all.student(id).at("results").at(0).at("score").is_null());
  }
  const std::vector<int> bars = document.at("distribution");
  CHECK(std::accumulate(bars.begin(), bars.end(), 0) == 2);  // of those who were judged
  for (const char* table : {"grades.csv", "moodle.csv", "canvas.csv"}) {
    const std::string text = read(all.root() / "out" / table);
    CHECK(has(text, "ada"));
    for (const char* id : {"bob", "cleo", "dora"}) CHECK_MESSAGE(!has(text, id), table);
  }
  const std::string page = read(all.root() / "out/class.html");
  CHECK(page.find("dora.zip") < page.find("<h2>Students</h2>"));
  CHECK(page.find("Nothing was found of: dora") < page.find("<h2>Students</h2>"));

  CHECK(all.grade("out", "--roster roster.csv --with-missing").status == 1);
  CHECK(has(read(all.root() / "out/grades.csv"), "dora"));
}

TEST_CASE("Results are readable to nobody else.") {
  const MadeUpClass few;
  few.energy("ada", "throw NotStarted{};");
  fs::create_directories(few.root() / "out");  // is open to all
  REQUIRE(few.run("grade submissions --out out --allow-reduced --seed 1", "umask 000;").status == 0);
  for (const auto& entry : fs::recursive_directory_iterator(few.root() / "out")) {
    struct stat status {};
    REQUIRE(::stat(entry.path().c_str(), &status) == 0);
    CHECK_MESSAGE((status.st_mode & 0777) == (entry.is_directory() ? 0700 : 0600), entry.path().string());
  }
  CHECK(fs::status(few.root() / "out").permissions() == fs::perms::owner_all);
  CHECK(fs::exists(few.root() / "out/submissions/ada/spring_energy.cpp"));
}

TEST_CASE("A date costs what the assignment says, and nothing else.") {
  const MadeUpClass few;
  few.energy("ada", right_energy);
  few.energy("ben", right_energy);
  write(few.root() / "roster.csv", "id,submitted\nada,2027-03-01T23:58:00Z\nben,2027-03-02T00:00:00Z\n");
  const auto scores = [&](const std::string& late) {
    write(few.root() / "week.json", R"({"exercises": [{"name": "spring_energy", "points": 10}],
        "due": "2027-03-01T23:59:00Z")" +
                                        late + "}");
    REQUIRE(few.grade("out", "--roster roster.csv --assignment week.json").status == 0);
    CHECK(few.student("ben").at("student").at("days_late") == 1);
    return std::pair<double, double>(few.student("ada").at("student").at("score"),
                                     few.student("ben").at("student").at("score"));
  };
  CHECK(scores("") == std::pair(10., 10.));
  CHECK(scores(R"(, "late": {"per_day": 0.1, "days": 5})") == std::pair(10., 9.));
}

TEST_CASE("No cell of a table is a formula.") {
  const MadeUpClass few;
  few.energy("ada", right_energy);
  write(few.root() / "roster.csv", "id,name\nada,\"=1+1\"\n\"x;=2+2\",\"\t@SUM(A1)\"\n+3,-4\n");
  CHECK(few.grade("out", "--roster roster.csv --with-missing").status == 1);
  for (const char* table : {"grades.csv", "moodle.csv", "canvas.csv"}) {
    CAPTURE(table);
    const std::string text = read(few.root() / "out" / table);
    REQUIRE(has(text, "1+1"));
    REQUIRE(has(text, "2+2"));
    // As spreadsheets read it that take a comma, and as those that take a semicolon.
    for (const char separator : {',', ';'})
      for (std::size_t at = 0; at < text.size(); ++at) {
        const bool begins = at == 0 || text[at - 1] == separator || text[at - 1] == '\n';
        const std::size_t cell = begins ? text.find_first_not_of("\" \t", at) : std::string::npos;
        if (cell != std::string::npos)
          CHECK_MESSAGE(std::string("=+-@").find(text[cell]) == std::string::npos, text.substr(at, 20));
      }
  }
}

TEST_SUITE_END();
