// The pages of a student and of a class in a real browser, wide and narrow, light and dark.
#include "tests/site/browser.hpp"
#include "tests/program/program.hpp"
#include "tests/report/made_up.hpp"

#include "checker/grading/grading.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>

using namespace workbook;
using namespace workbook::testing;
using workbook::site::Browser;
namespace fs = std::filesystem;

namespace {

const fs::path scratch = fs::path(WORKBOOK_TEST_SCRATCH);

void set_view(Browser& browser, int width, const std::string& colors) {
  browser.call("Emulation.setDeviceMetricsOverride",
               {{"width", width}, {"height", 900}, {"deviceScaleFactor", 1}, {"mobile", width < 768}});
  browser.call("Emulation.setEmulatedMedia",
               {{"features", nlohmann::json::array({{{"name", "prefers-color-scheme"}, {"value", colors}}})}});
  browser.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))");
}

/// What must hold of every page of results. Its links stay on it, or lead to the page of a student.
void check_page(Browser& browser, const fs::path& file, int scripts = 0) {
  const std::string url = "file://" + fs::canonical(file).string();
  const std::string overflow = read(fs::path(SITE_SCRIPTS) / "overflow.js");
  set_view(browser, 1280, "light");
  browser.take_events();
  browser.open(url);
  for (const int width : {1280, 390}) {
    std::string grounds;
    for (const char* colors : {"light", "dark"}) {
      CAPTURE(width);
      CAPTURE(colors);
      set_view(browser, width, colors);
      browser.evaluate("document.querySelectorAll('details').forEach(each => each.open = false)");
      CHECK(browser.evaluate(overflow).dump() == "null");
      browser.evaluate("document.querySelectorAll('details').forEach(each => each.open = true)");
      CHECK(browser.evaluate(overflow).dump() == "null");
      grounds += browser.evaluate("getComputedStyle(document.body).backgroundColor").get<std::string>() + " ";
    }
    CHECK(grounds == "rgb(255, 255, 255) rgb(23, 25, 28) ");
  }
  CHECK(browser.evaluate("[...document.images].every(each => each.complete && each.naturalWidth > 0)") == true);
  CHECK(browser.evaluate("[...document.images].every(each => each.alt.trim() !== '')") == true);
  CHECK(browser.evaluate("document.querySelectorAll('iframe, object, embed, link, base, form').length") == 0);
  CHECK(browser.evaluate("document.querySelectorAll('script').length") == scripts);
  CHECK(browser.evaluate("[...document.querySelectorAll('*')].flatMap(each => [...each.attributes])"
                         ".filter(each => each.name.startsWith('on')).length") == 0);
  CHECK(browser.evaluate("document.querySelectorAll('h1').length") == 1);
  CHECK(browser.evaluate("[...document.querySelectorAll('a')].every(each => "
                         "/students\\/[\\w.-]+\\.html$/.test(each.pathname) || "
                         "document.getElementById(decodeURIComponent(each.hash.slice(1))) !== null)") == true);
  for (const nlohmann::json& event : browser.take_events()) {
    const std::string method = event["method"];
    CAPTURE(event.dump());
    if (method == "Network.requestWillBeSent") {
      const std::string to = event["params"]["request"]["url"];
      // The browser's own spelling of the address, in which a space is %20.
      const std::string here = browser.evaluate("location.href");
      const bool stays = to == here || to.starts_with("data:");
      CHECK(stays);
    }
    CHECK(method != "Runtime.exceptionThrown");
    CHECK(method != "Runtime.consoleAPICalled");
    CHECK(method != "Page.javascriptDialogOpening");
    CHECK(method != "Log.entryAdded");
  }
}

}  // namespace

TEST_CASE("a page full of hostile text is text, at every width and in both colours") {
  const fs::path file = scratch / "hostile.html";
  MadeUpCourse course;
  fill_with_hostile_text(course);
  write(file, report_page(course.page));
  Browser browser(SITE_CHROMIUM);
  check_page(browser, file);
  CHECK(browser.evaluate("document.title") == "Report for " + hostile);
  CHECK(browser.evaluate("document.querySelector('h1').textContent") == "Report for " + hostile);
  const std::string text = browser.evaluate("document.body.textContent");
  for (const char* where : {"The function threw an exception: ", "Next. ", "Diagnosed. ", "int ", "Found. ",
                            "Printed. ", "Compiled. ", "// Source. "}) {
    CAPTURE(where);
    CHECK(has(text, where + hostile));
  }
  CHECK(browser.evaluate("document.images[0].alt") == "Pictured. " + hostile);
  CHECK(browser.evaluate("document.images.length") == 6);
  CHECK(browser.evaluate("[...document.querySelectorAll('pre')].some(each => each.scrollWidth > each.clientWidth)") ==
        true);
}

TEST_CASE("a class with hostile names and values has a page of text") {
  using nlohmann::ordered_json;
  const auto mark = [](const char* exercise, const char* verdict, const ordered_json& score) {
    return ordered_json{
        {"exercise", exercise}, {"verdict", verdict}, {"score", score}, {"points", 1}, {"message", hostile}};
  };
  ordered_json document = {{"title", hostile},     {"seed", 1},
                           {"sandbox", hostile},   {"problems", {hostile}},
                           {"missing", {hostile}}, {"not_judged", {hostile}}};
  for (const char* exercise : {"spring_energy", "spring_force"})
    document["exercises"].push_back({{"exercise", exercise},
                                     {"lecture", "01_springs"},
                                     {"points", 1},
                                     {"started", 2},
                                     {"passed", 1},
                                     {"difficulty", 0.5},
                                     {"discrimination", nullptr}});
  document["distribution"] = {0, 0, 1, 0, 0, 0, 0, 0, 0, 30};
  document["learnt_by_heart"] = ordered_json::array({{{"exercise", "spring_force"}, {"students", {"0 " + hostile}}}});
  document["misconceptions"] = ordered_json::array(
      {{{"exercise", "spring_energy"}, {"name", "no_half"}, {"message", hostile}, {"students", {"1 " + hostile}}}});
  document["changes"] = {hostile};
  document["similar"] = ordered_json::array(
      {{{"exercise", "spring_energy"},
        {"share", 0.9},
        {"answers",
         {{{"students", {"1 " + hostile}}, {"text", hostile}}, {{"students", {"2 " + hostile}}, {"text", hostile}}}}}});
  document["identical_wrong_outputs"] =
      ordered_json::array({{{"exercise", "spring_energy"},
                            {"first_failure", {{"case", hostile}, {"expected", 1.5}, {"actual", hostile}}},
                            {"students", {"1 " + hostile, "2 " + hostile}}}});
  for (int k = 0; k < 31; ++k)
    document["students"].push_back(
        {{"id", fmt::format("{} {}", k, hostile)},
         {"name", k % 2 == 0 ? hostile : std::string(200, 'W')},
         {"slug", std::to_string(k)},
         {"score", k + 1},
         {"before", 0.5},
         {"possible", 40},
         {"days_late", k},
         {"notes", {hostile}},
         {"results", {mark("spring_energy", "passed", 1), mark("spring_force", "checker_error", nullptr)}}});
  const fs::path file = scratch / "class.html";
  write(file, class_page(document, "22 November 2026"));
  Browser browser(SITE_CHROMIUM);
  check_page(browser, file, 1);
  CHECK(browser.evaluate("document.title") == "Results of a class: " + hostile);
  CHECK(browser.evaluate("document.querySelectorAll('.marks tbody tr').length") == 31);
  CHECK(browser.evaluate("document.images.length") == 0);
  const std::string text = browser.evaluate("document.body.textContent");
  for (const std::string& where : {"Sandbox: " + hostile, "30 " + hostile}) CHECK(has(text, where));

  const auto first = [&](const char* what) {
    return browser.evaluate(fmt::format("document.querySelector('.marks tbody tr').{}", what)).get<std::string>();
  };
  // The name stands still while the marks scroll; sorting and searching change which rows are seen and nothing else.
  set_view(browser, 320, "light");
  CHECK(
      browser.evaluate("{const box = document.querySelector('.marks').parentNode, name = box.querySelector('tbody th');"
                       "const x = name.getBoundingClientRect().x; box.scrollLeft = 1000;"
                       "box.scrollLeft > 0 && name.getBoundingClientRect().x === x}") == true);
  // innerText leaves out rows that are not laid out.
  browser.evaluate("document.querySelector('style').append('.marks tbody tr { content-visibility: visible; }')");
  // A name from right to left does not turn round what stands beside it.
  CHECK(browser.evaluate("[...document.querySelectorAll('a')].every(each => getComputedStyle(each).unicodeBidi === "
                         "'isolate')") == true);
  browser.evaluate("document.querySelectorAll('.marks thead th')[1].click()");
  CHECK(browser.evaluate("[...document.querySelectorAll('.marks tbody tr')].map(each => +each.cells[1].dataset.sort)"
                         ".every((each, i, all) => i === 0 || all[i - 1] <= each)") == true);
  browser.evaluate("document.querySelectorAll('.marks thead th')[1].click()");
  CHECK(has(first("cells[1].textContent"), "31 of 40"));
  browser.evaluate(
      "const box = document.getElementById('search'); box.value = '(17 '; box.dispatchEvent(new Event('input'))");
  CHECK(browser.evaluate("document.querySelectorAll('.marks tbody tr:not([hidden])').length") == 1);
  CHECK(has(browser.evaluate("document.body.innerText").get<std::string>(), "WWW"));
  browser.evaluate("document.getElementById('anonymous').click()");
  CHECK(browser.evaluate("document.querySelectorAll('.marks tbody tr:not([hidden])').length") == 31);
  const std::string shown = browser.evaluate("document.body.innerText");
  CHECK(has(shown, "Student 31"));
  CHECK(!has(shown, "before"));  // by which others know who has had a mark changed
  CHECK(!has(shown, "WWW"));
  CHECK(!has(shown, "17 " + hostile));
  browser.evaluate("document.getElementById('anonymous').click()");
  CHECK(browser.evaluate("document.querySelectorAll('.marks tbody tr:not([hidden])').length") == 31);
}

TEST_CASE("the page of a class of 500 students and 48 exercises opens at once") {
  using nlohmann::ordered_json;
  ordered_json document = {{"title", "A large class"}, {"seed", 1}, {"sandbox", "full."}};
  for (const char* list :
       {"problems", "missing", "not_judged", "changes", "learnt_by_heart", "identical_wrong_outputs"})
    document[list] = ordered_json::array();
  document["distribution"] = {0, 0, 0, 0, 0, 500, 0, 0, 0, 0};
  document["misconceptions"] = ordered_json::array();
  for (int e = 0; e < 48; ++e) {
    const std::string name = fmt::format("exercise_with_a_name_{}", e);
    document["exercises"].push_back({{"exercise", name},
                                     {"lecture", "01_springs"},
                                     {"points", 1},
                                     {"started", 2},
                                     {"passed", 1},
                                     {"difficulty", 0.5},
                                     {"discrimination", 0.25}});
    document["misconceptions"].push_back({{"exercise", name}, {"name", "sign"}, {"message", "A sign is wrong."}});
  }
  for (int k = 0; k < 500; ++k) {
    const std::string id = fmt::format("s{:03}", k);
    document["students"].push_back({{"id", id},
                                    {"name", "Student of Physics"},
                                    {"slug", id},
                                    {"score", (7 * k) % 48},
                                    {"possible", 48},
                                    {"days_late", 0}});
    for (int e = 0; e < 48; ++e) {
      const bool is_right = (k + e) % 3 != 0;
      document["students"].back()["results"].push_back({{"exercise", document["exercises"][e]["exercise"]},
                                                        {"verdict", is_right ? "passed" : "wrong_value"},
                                                        {"score", is_right ? 1 : 0},
                                                        {"points", 1}});
      if (!is_right) document["misconceptions"][e]["students"].push_back(id);
    }
  }
  const fs::path file = scratch / "large_class.html";
  write(file, class_page(document, "22 November 2026"));
  Browser browser(SITE_CHROMIUM);
  set_view(browser, 1280, "light");
  browser.open("file://" + fs::canonical(file).string());
  const double seconds = browser.evaluate("performance.getEntriesByType('navigation')[0].loadEventEnd / 1000");
  MESSAGE(std::to_string(fs::file_size(file) / 1000000), " MB, loaded after ", seconds, " s");
  CHECK(browser.evaluate("document.querySelectorAll('.marks tbody tr').length") == 500);
  set_view(browser, 390, "light");  // no name is cut
  CHECK(browser.evaluate("[...document.querySelectorAll('.marks tbody th')].every(each => each.scrollWidth <= "
                         "each.clientWidth)") == true);
  CHECK(seconds > 0);
  CHECK(seconds < 3);  // 1 s on a machine that has nothing else to do
}

TEST_CASE("the page of a student whose code prints markup is sound, with its real plots") {
  const CourseCopy course;
  course.answer_energy(
      "std::puts(\"</pre><script>document.title='taken'</script>{{name}}\"); return k * x.squaredNorm();",
      "#include <cstdio>\n");
  write(course.exercise("spring_force"),
        force_text("throw std::runtime_error(\"\\\"><img src=x onerror=alert(1)>\");"));
  const Outcome outcome = course.run("report --html page.html --name '<b>Ada</b>'");
  CHECK_MESSAGE(outcome.status == 0, outcome.err);
  Browser browser(SITE_CHROMIUM);
  check_page(browser, course.root() / "page.html");
  CHECK(browser.evaluate("document.title") == "Report for <b>Ada</b>");
  const std::string text = browser.evaluate("document.body.textContent");
  CHECK(has(text, "</pre><script>document.title='taken'</script>{{name}}"));
  CHECK(has(text, "\"><img src=x onerror=alert(1)>"));
  CHECK(browser.evaluate("document.images.length") == 1);  // spring_force gave no value, so there is no curve
}
