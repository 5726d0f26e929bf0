// The registrar: marks that can be taken over as they are.
#include "tests/grading/made_up_class.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>

using namespace workbook::testing;
namespace fs = std::filesystem;

TEST_SUITE_BEGIN("registrar" * doctest::skip(!is_open_to_all()));

TEST_CASE("Nobody gets a zero in silence.") { MadeUpClass().check_story("zeros"); }

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

TEST_CASE("A date costs what the assignment says, and nothing else.") { MadeUpClass().check_story("dates"); }

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
