// The judge of the site is judged: each page under pages/ has one fault, and the sentence about it is expected word for
// word.
#include "tests/site/inspection.hpp"

#include <doctest/doctest.h>

#include <fmt/ranges.h>

#include <fstream>

using namespace workbook::site;

namespace {

using Sentences = std::vector<std::string>;

/// One browser for all cases: its start takes longer than all pages together.
Browser& browser() {
  static Browser the_browser(SITE_CHROMIUM);
  return the_browser;
}

Inspection new_inspection() { return Inspection(browser(), SITE_PAGES); }

Sentences faults_of(const std::string& page) {
  Inspection inspection = new_inspection();
  inspection.look_at(page);
  inspection.follow_links();
  return inspection.faults();
}

void check_same(const Sentences& found, const Sentences& expected) {
  CHECK_MESSAGE(found == expected, fmt::format("found:\n{}", fmt::join(found, "\n")));
}

}  // namespace

TEST_CASE("A sound page has no faults, and what it holds is counted") {
  Inspection inspection = new_inspection();
  inspection.look_at("sound.html");
  inspection.look_at("navigation.html");
  inspection.follow_links();
  check_same(inspection.faults(), {});
  CHECK(inspection.counts().pages == 2);
  CHECK(inspection.counts().formulas == 1);
  CHECK(inspection.counts().pictures == 1);
  CHECK(inspection.counts().links == 4);
}

TEST_CASE("A formula that MathJax cannot read is named with the reason") {
  check_same(
      faults_of("broken_formula.html"),
      {R"(broken_formula.html: the formula “\notacommand{x}” cannot be shown: Undefined control sequence \notacommand.)",
       R"(broken_formula.html: the formula “\frac{1}{2” cannot be shown: Missing close brace.)"});
}

TEST_CASE("A formula that nothing draws is named") {
  check_same(faults_of("plain_formula.html"),
             {R"(plain_formula.html: the formula “\(T\).” is shown as plain text.)",
              R"(plain_formula.html: the formula “\f$ L \f$.” is shown as plain text.)"});
}

TEST_CASE("A picture that does not load is named") {
  check_same(faults_of("missing_picture.html"), {"missing_picture.html: the picture nowhere.svg is not shown.",
                                                 "missing_picture.html: nowhere.svg cannot be loaded."});
}

TEST_CASE("A picture of the text without alternative text is named") {
  check_same(faults_of("undescribed_picture.html"),
             {"undescribed_picture.html: the picture square.svg has no alternative text."});
}

TEST_CASE("A document within the page is refused") {
  check_same(
      faults_of("embedded_document.html"),
      {"embedded_document.html: the element object#square is a document within the page, which readers may not see; "
       "show it as a picture."});
}

TEST_CASE("A link to a page, to a paragraph that does not exist, or out of the site is named by its words") {
  Inspection inspection = new_inspection();
  inspection.look_at("dead_links.html");
  inspection.look_at("sound.html");
  inspection.look_at("navigation.html");
  inspection.follow_links();
  const std::string outside = (std::filesystem::canonical(SITE_PAGES).parent_path() / "outside.html").string();
  check_same(inspection.faults(),
             {"dead_links.html: the link “no page” leads to nowhere.html, which does not exist.",
              "dead_links.html: the link “no paragraph” leads to #nowhere on sound.html, which does not exist.",
              "dead_links.html: the link “no site” leads outside the site, to " + outside + "."});
}

TEST_CASE("A request to another machine is named by its address") {
  check_same(faults_of("foreign_request.html"),
             {"foreign_request.html: the page asks another machine for http://example.org/counter.js."});
}

TEST_CASE("A script that is missing is named") {
  check_same(faults_of("missing_script.html"), {"missing_script.html: nowhere.js cannot be loaded."});
}

TEST_CASE("A script that reports an error or stops is quoted") {
  const Sentences faults = faults_of("failing_script.html");
  REQUIRE(faults.size() == 2);
  CHECK(faults[0] == "failing_script.html: a script reports an error: \"no such angle\"");
  CHECK(
      faults[1].starts_with("failing_script.html: a script stopped: ReferenceError: undefinedFunction is not defined"));
}

TEST_CASE("What makes a narrow page scroll sideways is named, in light and dark") {
  check_same(
      faults_of("overflow_narrow.html"),
      {"overflow_narrow.html: at a width of 390 pixels the page scrolls sideways by 318 pixels because of p#wide (“A "
       "paragraph of fixed width.”), light.",
       "overflow_narrow.html: at a width of 390 pixels the page scrolls sideways by 318 pixels because of p#wide (“A "
       "paragraph of fixed width.”), dark."});
}

TEST_CASE("A page that is too wide in the dark only is not sound") {
  const Sentences faults = faults_of("overflow_dark.html");
  REQUIRE(faults.size() == 2);
  CHECK(faults[0] ==
        "overflow_dark.html: at a width of 1280 pixels the page scrolls sideways by 728 pixels because of p.wide "
        "(“A paragraph wide in the dark.”), dark.");
}

TEST_CASE("A column of text that scrolls sideways is as bad as a page that does") {
  const Sentences faults = faults_of("column_overflow.html");
  REQUIRE(faults.size() == 4);
  CHECK(faults[0].find("because of p.fixed (“A paragraph of fixed width in a column.”), light.") != std::string::npos);
}

TEST_CASE("The keyboard reaches navigation and search, or the page is told off at either width") {
  Inspection reachable = new_inspection();
  reachable.walk_with_keyboard("navigation.html");
  check_same(reachable.faults(), {});
  Inspection unreachable = new_inspection();
  unreachable.walk_with_keyboard("unreachable.html");
  check_same(unreachable.faults(), {"unreachable.html: at a width of 1280 pixels Tab does not reach the navigation.",
                                    "unreachable.html: at a width of 1280 pixels Tab does not reach the search.",
                                    "unreachable.html: at a width of 390 pixels Tab does not reach the navigation.",
                                    "unreachable.html: at a width of 390 pixels Tab does not reach the search."});
}

TEST_CASE("A search that finds nothing is reported") {
  Inspection inspection = new_inspection();
  inspection.search("navigation.html", "inertia");
  check_same(inspection.faults(), {"navigation.html: the search for “inertia” finds nothing."});
}

TEST_CASE("A paragraph that a diagnosis names must stand on exactly one page") {
  Inspection inspection = new_inspection();
  inspection.look_at("sound.html");
  inspection.look_at("navigation.html");
  inspection.expect_anchors({"below", "nowhere"});
  check_same(inspection.faults(),
             {"#nowhere, which a diagnosis names for further reading, stands on 0 pages instead of one."});
}

TEST_CASE("The paragraphs named by diagnoses are read from wherever they stand in the reference results") {
  const std::filesystem::path folder = std::filesystem::path(SITE_PAGES).parent_path() / "reference";
  std::filesystem::create_directories(folder);
  CHECK_THROWS_WITH(anchors_of_diagnoses(folder),
                    (folder.string() + " holds no reference results that name paragraphs of the notes.").c_str());
  std::ofstream(folder / "01.json")
      << R"({"exercises": [{"misconceptions": [{"notes": "here"}], "terms": [{"notes": "there"}]}]})";
  CHECK(anchors_of_diagnoses(folder) == std::set<std::string>{"here", "there"});
  std::filesystem::remove_all(folder);
}

TEST_CASE("A site without pages and a browser that is not installed are told plainly") {
  CHECK_THROWS_WITH(pages_of("no-such-folder"), "no-such-folder holds no pages: build the target notes first.");
  CHECK_THROWS_WITH(Browser("/no/such/chromium"), "/no/such/chromium cannot be started: install the package chromium.");
}
