// The report page as text: what stands on it, and that nothing of it can be taken for markup.
#include "tests/report/made_up.hpp"
#include "tests/support/files.hpp"
#include "tests/support/golden.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

using namespace workbook;
using namespace workbook::testing;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// The part of the page about one exercise.
std::string article(const std::string& page, const std::string& exercise) {
  const std::size_t begin = page.find("<article id=\"exercise-" + exercise + "\"");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("</article>", begin) - begin);
}

}  // namespace

TEST_CASE("a page with a bit of everything") {
  MadeUpCourse course;
  course.page.picture_trouble = "There are no plots, for a reason.";
  ExerciseReference reference;
  reference.result_units = {units::joule};
  reference.sweep.components = {{"E"}};
  reference.measured = {{"a luggage scale", {}, {0.02}}};
  ReportedExercise& passed = course.add("01_springs", "energy", Verdict::passed, 2);
  passed.checked.picture = base64("<svg/>");
  passed.checked.reference = &reference;
  passed.checked.observation.measured = {{Ending::returned, {1, 1, {2.4525}}}};
  ReportedExercise& wrong = course.add("01_springs", "force", Verdict::wrong_value, 3);
  wrong.checked.reasons = {
      {ReasonKind::misconception, "away", "A spring pulls back.", Weight::cause, "springs_energy"}};
  wrong.checked.picture = base64("<svg/>");
  wrong.checked.picture_description = "A plot.";
  ReportedExercise& refused = course.add("01_springs", "work", Verdict::compile_error);
  refused.checked.reasons = {
      {.name = "power", .sentence = "^ is not a power.", .line = 4, .column = 9, .excerpt = "return x^2;\n        ^"}};
  refused.checked.observation.refusal_details = "All that the compiler said.";
  refused.checked.source = "#include <cmath>\n\ndouble work(double x) {\n  return x^2;\n}\n";
  course.add("01_springs", "mass", Verdict::checker_error, 4);
  course.add("02_more_springs", "period", Verdict::not_started, 1.5);
  course.add("02_more_springs", "length", Verdict::not_started);
  const std::string page = report_page(course.page);
  const std::size_t style = page.find("<style>");
  compare_with_golden(std::filesystem::path(WORKBOOK_TEST_COURSE).parent_path() / "golden/report_page.html",
                      page.substr(0, style) + page.substr(page.find("</style>")));

  // Why comes first, then what to do.
  const std::string force = article(page, "force");
  CHECK(force.find("A spring pulls back.") < force.find("Fix what"));
  CHECK(has(article(page, "work"), "work.cpp:4:9"));
  CHECK(article(page, "period").empty());
}

TEST_CASE("what could not be judged counts neither way, and of many failures the first five are named") {
  MadeUpCourse course;
  course.add("01_springs", "energy", Verdict::passed, 2);
  course.add("01_springs", "force", Verdict::checker_error, 3);
  CHECK(has(report_page(course.page), "2 of 2 points"));
  for (const char* name : {"one", "two", "three", "four", "five", "six", "seven"})
    course.add("01_springs", name, Verdict::crashed);
  const std::string page = report_page(course.page);
  CHECK(has(page, "<li><a href=\"#exercise-five\">five</a>: The next step of five."));
  CHECK_FALSE(has(page, "<a href=\"#exercise-six\">six</a>: "));
}

TEST_CASE("a page without a name, and one on which all is done") {
  MadeUpCourse course;
  course.page.student = "";
  course.add("01_springs", "energy", Verdict::passed);
  const std::string page = report_page(course.page);
  CHECK_FALSE(has(page, "Report for"));
  CHECK(has(page, "Every exercise on this page passes."));
}

TEST_CASE("nothing that comes from a student is markup, a part of the template, or a control character") {
  MadeUpCourse course;
  fill_with_hostile_text(course);
  const std::string page = report_page(course.page);
  for (const char* markup : {"<script", "<img src=x", "<svg", "<!-- "}) CHECK_MESSAGE(!has(page, markup), markup);
  CHECK(count(page, "</style>") == 1);
  CHECK(has(page, "{{mustache}}{{{style}}}{{#lectures}}"));
  CHECK(count(page, ":root {") == 3);  // light, dark and print, once each
  CHECK(std::ranges::none_of(page,
                             [](unsigned char letter) { return letter < 0x20 && letter != '\n' && letter != '\t'; }));
  // Every attribute that a student's text stands in is still in its quotes.
  CHECK(search_all(page, R"re( alt="[^"<>]*")re").size() == 6);
  // Nothing beside it is needed, and no path of the machine that made it is given away.
  for (const char* part : {"http:", "https:", "@import", "url(", "/home/student"})
    CHECK_MESSAGE(!has(page, part), part);
  CHECK(has(page, "default-src 'none'"));
}

TEST_CASE("a printout without end is cut") {
  MadeUpCourse course;
  course.add("01_springs", "energy", Verdict::wrong_value).checked.observation.replies = {
      Reply{.printed = std::string(1 << 20, 'x')}};
  CHECK(report_page(course.page).size() < 100000);
}
