// The programs that make and judge the site: when one cannot do its work it says why, and ends with a status of its
// own.
#include "tests/support/files.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

Outcome check_site(const std::string& arguments) {
  return run_command(fmt::format("'{}' {}", CHECK_SITE_PROGRAM, arguments), WORKBOOK_TEST_SCRATCH);
}

void check_refused(const Outcome& outcome, const std::string& name) {
  CHECK(outcome.status == 3);
  CHECK(outcome.out.empty());
  CHECK_MESSAGE(has(outcome.err, name), outcome.err);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
}

}  // namespace

TEST_CASE("wrong arguments are named, and --help lists the right ones") {
  const Outcome nothing = check_site("");
  CHECK(nothing.status == 2);
  CHECK_MESSAGE(has(nothing.err, "SITE"), nothing.err);
  const Outcome unknown = check_site("site --pigeon");
  CHECK(unknown.status == 2);
  CHECK_MESSAGE(has(unknown.err, "--pigeon"), unknown.err);
  const Outcome help = check_site("--help");
  CHECK(help.status == 0);
  CHECK(has(help.out, "--references"));
}

TEST_CASE("a folder without pages, a browser or a file that is not there, and results without anchors are named") {
  check_refused(check_site("/nowhere"), "/nowhere");
  check_refused(check_site(fmt::format("'{}' --chromium /no/chromium", SITE_PAGES)), "/no/chromium");
  check_refused(check_site(fmt::format("'{}' --axe /no/axe.js", SITE_PAGES)), "/no/axe.js");
  check_refused(check_site(fmt::format("'{}' --page sound.html --references /nowhere", SITE_PAGES)), "/nowhere");
}

TEST_CASE("the status is 0 where nothing is wrong and 1 where something is") {
  const Outcome sound = check_site(fmt::format("'{}' --page sound.html", SITE_PAGES));
  CHECK_MESSAGE(sound.status == 0, sound.out);
  CHECK(has(sound.out, "1 pages, "));
  const Outcome broken = check_site(fmt::format("'{}' --page missing_picture.html", SITE_PAGES));
  CHECK(broken.status == 1);
  CHECK_MESSAGE(has(broken.out, "nowhere.svg"), broken.out);
}

TEST_CASE("a formula that cannot be set and a label without a formula stop the build and are named") {
  const fs::path site = fs::path(WORKBOOK_TEST_SCRATCH) / "site";
  const std::string tex = R"(<p>An angle \(\theta\), another \(\notacommand{x}\).</p>)";
  fs::create_directories(site);
  write(site / "lecture_01_a.html", tex);
  const Outcome formulas = run_command(fmt::format("'{}' '{}/formulas.js' '{}' '{}' '{}/macros.tex'", SITE_NODE,
                                                   SITE_SOURCES, SITE_KATEX, site.string(), SITE_SOURCES),
                                       WORKBOOK_TEST_SCRATCH);
  CHECK(formulas.status == 1);
  CHECK_MESSAGE(has(formulas.err, R"(lecture_01_a.html: the formula “\notacommand{x}” cannot be set)"), formulas.err);
  CHECK(read(site / "lecture_01_a.html") == tex);
  write(site / "pages", "01_a");
  write(site / "lecture_01_a.html", R"(<p class="formulaDsp">T</p><p id="eq_lost">No formula below.</p>)");
  const Outcome numbers = run_command(
      fmt::format("cmake -D 'site={0}' -D 'pages={0}/pages' -P '{1}/numbers.cmake'", site.string(), SITE_SOURCES),
      WORKBOOK_TEST_SCRATCH);
  CHECK(numbers.status == 1);
  CHECK_MESSAGE(has(numbers.err, "no formula and no figure follows the anchor eq_lost"), numbers.err);
}
