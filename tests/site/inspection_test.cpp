// The judge of the site is judged: each page under pages/ has one kind of fault, which must be found and named.
#include "tests/site/inspection.hpp"

#include <doctest/doctest.h>

#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>

using namespace workbook::site;

namespace {

using Words = std::vector<std::string>;

/// One browser for all cases: its start takes longer than all pages together.
Browser& browser() {
  static Browser the_browser(SITE_CHROMIUM);
  return the_browser;
}

Inspection new_inspection() { return Inspection(browser(), SITE_PAGES); }

/// Expects as many faults as words, the first to hold the first word and so on.
void check_named(const Inspection& inspection, const Words& words) {
  const auto& faults = inspection.faults();
  REQUIRE_MESSAGE(faults.size() == words.size(), fmt::format("found:\n{}", fmt::join(faults, "\n")));
  for (std::size_t i = 0; i < words.size(); ++i) {
    CAPTURE(words[i]);
    CHECK_MESSAGE(faults[i].find(words[i]) != std::string::npos, faults[i]);
  }
}

void check_page(const std::string& page, const Words& words) {
  CAPTURE(page);
  Inspection inspection = new_inspection();
  inspection.look_at(page);
  inspection.follow_links();
  check_named(inspection, words);
}

}  // namespace

TEST_CASE("a sound page has no faults, and what it holds is counted") {
  Inspection inspection = new_inspection();
  inspection.look_at("sound.html");
  inspection.look_at("searchable.html");
  inspection.follow_links();
  check_named(inspection, {});
  CHECK(inspection.counts().pages == 2);
  CHECK(inspection.counts().formulas == 1);
  CHECK(inspection.counts().pictures == 2);
  CHECK(inspection.counts().links == 5);
}

TEST_CASE("each kind of fault on a page is found and named") {
  check_page("plain_formula.html", {R"(\(T\))", R"(\f$ L \f$)"});
  check_page("missing_picture.html", {"nowhere.svg", "nowhere.svg"});  // not shown, not loaded
  check_page("undescribed_picture.html", {"square.svg"});
  check_page("undescribed_figure.html", {"A caption alone."});
  check_page("stuck_picture.html", {"figure"});
  check_page("unlinked_call.html", {"call of cross_matrix", "call of inertial_rate", "exercise_cross_matrix.html",
                                    "exercise_inertial_rate.html", "exercise_angle.html"});
  check_page("embedded_document.html", {"object#square"});
  check_page("foreign_request.html", {"http://example.org/counter.js"});
  check_page("missing_script.html", {"nowhere.js"});
  check_page("failing_script.html", {"no such angle", "undefinedFunction"});
  check_page("no_landmarks.html", {"V46", "<main>", "<nav>"});
}

TEST_CASE("formulas without a number, with that of another, twice the same number and a gap are found") {
  check_page("lecture_numbers.html", {"L = 3 J s", "(1.5)", "eq_1_1 stands twice", "have the id eq_1_1"});
  Inspection inspection = new_inspection();
  inspection.look_at("lecture_numbers.html");
  inspection.expect_numbers();
  REQUIRE(inspection.faults().size() == 5);
  CHECK(inspection.faults().back() == "There is a number eq_1_3, but no eq_1_2.");
}

TEST_CASE("a formula that only a script shows and a citation without a preview are found") {
  Inspection inspection = new_inspection();
  inspection.look_at("lecture_scripts.html");
  check_named(inspection, {});
  inspection.read_without_scripts("lecture_scripts.html");
  check_named(inspection, {"(2.1)"});
  CHECK(!inspection.rest_on_citation("sound.html"));
  CHECK(inspection.rest_on_citation("lecture_scripts.html"));
  check_named(inspection, {"(2.1)", "shows no preview"});
  inspection.look_at("sound.html");  // with scripts again
  CHECK(inspection.faults().size() == 2);
}

TEST_CASE("what does not fit is named with the width and the colours") {
  check_page("overflow_narrow.html", {"390 pixels, dark", "390 pixels, light"});
  check_page("overflow_dark.html", {"1024 pixels, dark", "390 pixels, dark"});
  Inspection cut = new_inspection();
  cut.look_at("cut_code.html");
  REQUIRE(cut.faults().size() == 5);
  CHECK(cut.faults().front().find("pre") != std::string::npos);
}

TEST_CASE("text of a figure that is faint or tiny is named") {
  Inspection inspection = new_inspection();
  inspection.look_at("faint_figure.html");
  REQUIRE(inspection.faults().size() == 10);  // two at each width and colour
  CHECK(inspection.faults()[0].find("faint") != std::string::npos);
  CHECK(inspection.faults()[1].find("tiny") != std::string::npos);
}

TEST_CASE("axe-core finds faint text and a field without a label") {
  const std::string axe = SITE_AXE;
  if (axe.empty()) {
    MESSAGE("axe-core is not here; see the configuring of the tests.");
    return;
  }
  Inspection inspection = new_inspection();
  inspection.look_at("inaccessible.html", read_text(axe));
  check_named(inspection, {"color-contrast", "label", "color-contrast"});  // the colours also in the dark
}

TEST_CASE("a link to a page, to a paragraph that does not exist, or out of the site is named by its words") {
  Inspection inspection = new_inspection();
  for (const char* page : {"dead_links.html", "sound.html", "searchable.html"}) inspection.look_at(page);
  inspection.follow_links();
  check_named(inspection, {"no page", "no paragraph", "no site"});
}

TEST_CASE("the keyboard must reach navigation and search, and turn pages without a click") {
  Inspection reachable = new_inspection();
  reachable.walk_with_keyboard("searchable.html");
  check_named(reachable, {});
  Inspection stuck = new_inspection();
  stuck.walk_with_keyboard("stuck.html");
  check_named(stuck, {"1280 pixels Tab does not reach the navigation", "1280 pixels Tab does not reach the search",
                      "390 pixels Tab does not reach the navigation", "390 pixels Tab does not reach the search",
                      "PageDown", "“ ”", "End", "ArrowDown"});
}

TEST_CASE("a search must lead to the paragraph that has the words") {
  Inspection inspection = new_inspection();
  inspection.search("searchable.html", "Separatrix");
  check_named(inspection, {});
  inspection.search("searchable.html", "polhode");
  inspection.search("searchable.html", "nothing");
  inspection.search("searchable.html", "late=search");
  inspection.search("searchable.html", "separatris=polhode");
  check_named(inspection, {"searchable.html#field, which does not have “polhode”", "“nothing” finds nothing",
                           "“late” has a lecture, but not first", "“separatris” leads to searchable.html#field"});
}

TEST_CASE("a paragraph that a diagnosis names must stand on exactly one page") {
  Inspection inspection = new_inspection();
  inspection.look_at("sound.html");
  inspection.look_at("searchable.html");
  inspection.expect_anchors({"below", "nowhere"});
  check_named(inspection, {"#nowhere"});
}

TEST_CASE("the paragraphs named by diagnoses are read from wherever they stand in the reference results") {
  const std::filesystem::path folder = std::filesystem::path(SITE_PAGES).parent_path() / "reference";
  std::filesystem::create_directories(folder);
  CHECK_THROWS_AS(anchors_of_diagnoses(folder), std::runtime_error);
  std::ofstream(folder / "01.json")
      << "{\"format\": 2}\n"
      << R"({"exercises": [{"misconceptions": [{"notes": "here"}, {"notes": ""}], "terms": [{"notes": "there"}]}]})"
      << "\n";
  CHECK(anchors_of_diagnoses(folder) == std::set<std::string>{"here", "there"});
  std::filesystem::remove_all(folder);
}
