// The report page as text: what stands on it, and that nothing of it can be taken for markup.
#include "tests/report/made_up.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>

using namespace workbook;
using namespace workbook::testing;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// The part of the page about one exercise.
std::string article(const std::string& page, const std::string& exercise) {
  const std::size_t begin = page.find("<article id=\"exercise-" + exercise + "\"");
  if (begin == std::string::npos) return "";
  return page.substr(begin, page.find("</article>", begin) - begin);
}

}  // namespace

TEST_CASE("the page says whose it is, when it was made, what was reached and what comes next") {
  MadeUpCourse course;
  course.add("01_springs", "energy", Verdict::passed, 2);
  Judgement& wrong = course.add("01_springs", "force", Verdict::wrong_value, 3).checked.judgement;
  wrong.diagnoses = {{DiagnosisKind::misconception, "away", "A spring pulls back.", "springs_energy"}};
  course.add("02_more_springs", "period", Verdict::not_started, 1.5);
  const std::string page = report_page(course.reported());
  CHECK(has(page, "<h1>Report for Ada</h1>"));
  CHECK(has(page, "Checked on 2001-02-03, with the cases of seed 7."));
  CHECK(has(page, "2 of 6.5 points"));
  CHECK(has(page, "1 of 3 exercises passed, 1 to mend, 1 not started."));
  CHECK(has(page, "<h3>01  Springs</h3>\n<p class=\"quiet\">2 of 5 points</p>"));
  CHECK(has(page,
            "<a href=\"#exercise-force\">force</a>: A spring pulls back. Read lectures/01_springs/notes.md, “The "
            "energy of a spring”."));
  CHECK(has(page, "period: Begin with it. The task of period."));
  CHECK(has(article(page, "force"), "wrong value"));
  CHECK(has(article(page, "force"), "3 of 8 cases right, 0 of 3 points"));
  CHECK(has(article(page, "force"), "The message of force."));
  CHECK(has(article(page, "force"), "The next step of force."));
  CHECK_FALSE(has(article(page, "energy"), "The message of energy."));
  CHECK(article(page, "period").empty());
  CHECK(has(page, "<dd>period</dd>"));
}

TEST_CASE("a page without a name, and one on which all is done") {
  MadeUpCourse course;
  course.student = "";
  course.add("01_springs", "energy", Verdict::passed);
  const std::string page = report_page(course.reported());
  CHECK(has(page, "<h1>Report on the exercises</h1>"));
  CHECK(has(page, "1 of 1 point<"));
  CHECK(has(page, "Everything on this page passes; nothing is left to do here."));
  CHECK_FALSE(has(page, "Not started yet"));
}

TEST_CASE("an exercise that could not be judged counts neither way, and says so") {
  MadeUpCourse course;
  course.add("01_springs", "energy", Verdict::passed, 2);
  course.add("01_springs", "force", Verdict::checker_error, 3);
  const std::string page = report_page(course.reported());
  CHECK(has(page, "2 of 2 points"));
  CHECK(has(page, "1 of 2 exercises passed, 1 could not be judged."));
  CHECK(has(page,
            "1 exercise could not be judged because the checker itself was in trouble. That is no fault of the "
            "submission: their 3 points count neither way."));
  CHECK(has(article(page, "force"), "Our fault: this exercise counts neither way."));
  CHECK_FALSE(has(article(page, "force"), "0 of 3 points"));
}

TEST_CASE("of many things to mend the first five are named") {
  MadeUpCourse course;
  for (const char* name : {"one", "two", "three", "four", "five", "six", "seven"})
    course.add("01_springs", name, Verdict::crashed);
  const std::string page = report_page(course.reported());
  CHECK(has(page, "<a href=\"#exercise-five\">five</a>: The next step of five."));
  CHECK_FALSE(has(page, "<a href=\"#exercise-six\">six</a>: "));
  CHECK(has(page, "Then the other 2 exercises below that did not pass."));
}

TEST_CASE("the plot of what passed is folded away; without gnuplot a sentence stands in for all of them") {
  MadeUpCourse course;
  for (const Verdict verdict : {Verdict::passed, Verdict::wrong_value}) {
    ReportedExercise& exercise = course.add("01_springs", to_string(verdict), verdict);
    exercise.picture = "<svg/>";
    exercise.picture_description = "A plot.";
  }
  course.picture_trouble = "This page has no plots.";
  const std::string page = report_page(course.reported());
  CHECK(has(article(page, "passed"), "<summary>The plot</summary>"));
  CHECK_FALSE(has(article(page, "wrong_value"), "<summary>The plot</summary>"));
  CHECK(count(page, "<img src=\"data:image/svg+xml;base64,PHN2Zy8+\" alt=\"A plot.\"") == 2);
  CHECK(has(page, "This page has no plots."));
}

TEST_CASE("nothing that comes from a student is markup, a part of the template, or a control character") {
  const std::string page = report_page(hostile_course().reported());
  CHECK_FALSE(has(page, "<script"));
  CHECK_FALSE(has(page, "<img src=x"));
  CHECK_FALSE(has(page, "<svg"));
  CHECK(count(page, "</style>") == 1);
  CHECK_FALSE(has(page, "<!-- "));
  CHECK(has(page, "{{mustache}}{{{style}}}{{#lectures}}"));
  CHECK(count(page, ":root {") == 3);  // light, dark and print, once each
  const bool no_controls = std::none_of(page.begin(), page.end(), [](char letter) {
    return static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t';
  });
  CHECK(no_controls);
  // Every attribute that a student's text stands in is still in its quotes.
  const std::regex attribute(R"re( alt="[^"<>]*")re");
  CHECK(std::distance(std::sregex_iterator(page.begin(), page.end(), attribute), std::sregex_iterator()) == 6);
}

TEST_CASE("the page needs nothing beside it and gives away no path of the machine that made it") {
  const std::string page = report_page(hostile_course().reported());
  CHECK_FALSE(has(page, "http:"));
  CHECK_FALSE(has(page, "https:"));
  CHECK_FALSE(has(page, "@import"));
  CHECK_FALSE(has(page, "url("));
  CHECK_FALSE(has(page, "/home/student"));
  CHECK(has(page, "default-src 'none'"));
}

TEST_CASE("a printout without end is cut, and says so") {
  MadeUpCourse course;
  course.add("01_springs", "energy", Verdict::wrong_value).checked.observation.printed = std::string(1 << 20, 'x');
  const std::string page = report_page(course.reported());
  CHECK(page.size() < 100000);
  CHECK(has(page, "… (the rest is too long to be shown here)"));
}
