// The live figures as their readers meet them, opened as files; what they compute is computed again natively.
#include "lectures/live/functions.hpp"
#include "tests/site/inspection.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string_view>

using namespace workbook::site;
using nlohmann::json;
using workbook::live::Numbers;

namespace {

/// One browser for all cases.
Browser& browser() {
  static Browser the_browser(SITE_CHROMIUM);
  // Formulas are tested elsewhere, take time, and move what lies below them.
  static const json blocked = the_browser.call("Network.setBlockedURLs", {{"urls", {"*/MathJax.js*"}}});
  return the_browser;
}

void set_media(const json& features, const char* media = "") {
  browser().call("Emulation.setEmulatedMedia", {{"media", media}, {"features", features}});
}

void resize(int width) {
  browser().call("Emulation.setDeviceMetricsOverride",
                 {{"width", width}, {"height", 900}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

/// Opens a page with the test's functions in it; returns how many live figures it has.
int open_page(const std::string& page) {
  resize(1280);
  browser().open("file://" SITE_NOTES "/" + page);
  return browser().evaluate(read_text(SITE_SCRIPTS "/live.js") + "; places.length");
}

std::vector<std::string> pages_with_figures() {
  std::vector<std::string> pages = pages_of(SITE_NOTES);
  std::erase_if(pages, [](const std::string& page) {
    return read_text(std::filesystem::path(SITE_NOTES) / page).find("<div class=\"live\"") == std::string::npos;
  });
  return pages;
}

json evaluate_in(int figure, const std::string& expression) {
  return browser().evaluate(
      fmt::format("((place, live) => {{ return {}; }})(places[{}], places[{}].live)", expression, figure, figure));
}

/// No request to another machine, no error.
void check_events() {
  for (const json& event : browser().take_events()) {
    if (event.value("/params/blockedReason"_json_pointer, "") == "inspector") continue;
    const std::string method = event["method"];
    if (method == "Network.requestWillBeSent") {
      const std::string url = event["params"]["request"]["url"];
      CHECK_MESSAGE((url.starts_with("file:") || url.starts_with("data:")), url);
    }
    CHECK_MESSAGE(method != "Network.loadingFailed", event.dump());
    CHECK_MESSAGE(method != "Runtime.exceptionThrown", event.dump());
    CHECK_MESSAGE((method != "Runtime.consoleAPICalled" || event["params"]["type"] != "error"), event.dump());
    CHECK_MESSAGE((method != "Log.entryAdded" || event["params"]["entry"]["level"] != "error"), event.dump());
  }
}

/// A value of JavaScript, where a matrix is a list of its columns, as rows, columns and numbers.
void append(const json& value, Numbers& numbers) {
  const auto count = [](const json& list) { return static_cast<double>(list.size()); };
  if (value.is_number()) {
    numbers.insert(numbers.end(), {1, 1, value.get<double>()});
  } else if (value.is_null()) {
    FAIL_CHECK("A figure calls a function with a number that is not finite.");
    numbers.insert(numbers.end(), {1, 1, NAN});
  } else if (value.empty() || value[0].is_number()) {
    numbers.insert(numbers.end(), {count(value), 1});
    for (const json& component : value) numbers.push_back(component);
  } else {
    numbers.insert(numbers.end(), {count(value[0]), count(value)});
    for (const json& column : value) numbers.insert(numbers.end(), column.begin(), column.end());
  }
}

bool agree(double a, double b, double scale) {
  return std::abs(a - b) <= 1e-9 * std::max(1.0, scale) || (std::isnan(a) && std::isnan(b));
}

/// The result of a call natively; the one of the page must agree.
Numbers compute_again(const json& call) {
  const auto function = std::ranges::find(workbook::live::functions, call[0].get<std::string>(),
                                          [](const auto& known) { return std::string(known.name); });
  REQUIRE_MESSAGE(function != workbook::live::functions.end(), call[0].dump());
  Numbers arguments, in_page;
  for (const json& argument : call[1]) append(argument, arguments);
  append(call[2], in_page);
  const Numbers native = function->call(arguments.data());
  REQUIRE(native.size() == in_page.size());
  const double scale = std::abs(*std::ranges::max_element(native, {}, [](double x) { return std::abs(x); }));
  for (std::size_t i = 0; i < native.size(); ++i)
    CHECK_MESSAGE(agree(native[i], in_page[i], scale), call[0].dump(), " ", call[1].dump());
  return {native.begin() + 2, native.end()};
}

/// Each number on display is one that a function of the course returned, or the length of a vector that it returned.
void check_numbers(int figure) {
  for (const json& setting : browser().evaluate(fmt::format("settings_of({})", figure))) {
    CAPTURE(setting["values"].dump());
    Numbers results;
    for (const json& call : setting["calls"]) {
      const Numbers result = compute_again(call);
      results.insert(results.end(), result.begin(), result.end());
      if (result.size() == 3) results.push_back(std::hypot(result[0], result[1], result[2]));
    }
    for (const json& number : setting["numbers"]) {
      if (number[1].is_null()) continue;  // not finite: shown as a dash
      const double value = number[1];
      CHECK_MESSAGE(std::ranges::any_of(results, [&](double x) { return agree(x, value, std::abs(x)); }),
                    number.dump());
    }
  }
}

/// Keys turn a scene and move a slider; so does the pointer.
void check_input(int figure) {
  const auto key = [](const char* name, int code) {
    for (const char* type : {"rawKeyDown", "keyUp"})
      browser().call("Input.dispatchKeyEvent",
                     {{"type", type}, {"key", name}, {"code", name}, {"windowsVirtualKeyCode", code}});
  };
  const auto changes = [&](const std::string& what, const std::function<void()>& act) {
    const json before = evaluate_in(figure, what);
    act();
    CHECK_MESSAGE(before != evaluate_in(figure, what), what);
  };
  changes("live.values", [&] {
    evaluate_in(figure, "place.querySelector('.settings input').focus()");
    const bool is_last = evaluate_in(figure, "document.activeElement.value === document.activeElement.max");
    is_last ? key("ArrowLeft", 37) : key("ArrowRight", 39);
  });
  const auto drag = [&](const json& at) {
    for (const auto& [type, moved] : {std::pair{"mousePressed", 0}, {"mouseMoved", 40}, {"mouseReleased", 40}})
      browser().call("Input.dispatchMouseEvent", {{"type", type},
                                                  {"x", at[0].get<double>() - moved},
                                                  {"y", at[1].get<double>() + moved},
                                                  {"button", "left"},
                                                  {"clickCount", 1}});
  };
  if (evaluate_in(figure, "live.scenes.some(({view}) => view.handle)"))
    changes("live.values", [&] {
      drag(evaluate_in(figure,
                       "(({view, scene}) => { const box = box_of(scene.canvas);"
                       " const [x, y] = scene.at(view.handle(live.model, live.time, live.values));"
                       " return [box.x + x, box.y + y]; })(live.scenes.find(({view}) => view.handle))"));
    });
  if (!evaluate_in(figure, "live.scenes.some(({scene}) => !scene.flat)")) return;
  const std::string canvas = "live.scenes.find(({scene}) => !scene.flat).scene.canvas";
  changes("pictures(live)", [&] {
    evaluate_in(figure, canvas + ".focus()");
    key("ArrowRight", 39);
  });
  changes("pictures(live)",
          [&] { drag(evaluate_in(figure, "(box => [box.x + 50, box.y + 10])(box_of(" + canvas + "))")); });
}

/// axe-core finds no fault with open figures; in the dark only the colours differ.
void check_accessibility() {
  browser().evaluate(read_text(SITE_AXE) + ";null");
  for (const auto& [colors, rules] : {std::pair{"light", ""}, {"dark", ", runOnly: ['color-contrast']"}}) {
    set_media({{{"name", "prefers-color-scheme"}, {"value", colors}}});
    const json violations = browser().evaluate(
        fmt::format("axe.run('.live', {{ resultTypes: ['violations'], preload: false{} }})", rules) +
        ".then(report => report.violations.map(found => found.id + ': ' + found.nodes[0].html.slice(0, 200)))");
    CHECK_MESSAGE(violations.empty(), violations.dump());
  }
  set_media(json::array());
}

}  // namespace

TEST_CASE("every live figure starts, runs, rests, obeys, and shows what the functions of the course compute") {
  const std::vector<std::string> pages = pages_with_figures();
  REQUIRE(!pages.empty());
  bool judged = false;
  for (const std::string& page : pages) {
    browser().take_events();
    const int count = open_page(page);
    // Nothing is loaded for figures that are out of sight.
    CHECK(browser().evaluate("places.some(place => place.closest('figure').getBoundingClientRect().top < 1100) || "
                             "![...document.scripts].some(script => script.src.endsWith('/live/rigid.js'))") == true);
    for (int figure = 0; figure < count; ++figure) {
      const std::string name = browser().evaluate(fmt::format("places[{}].dataset.figure", figure));
      CAPTURE(name);
      const double started = browser().evaluate(fmt::format("open_figure({})", figure));
      CHECK(started < 1000);
      const json run = browser().evaluate(fmt::format("run_figure({}, {})", figure, page == pages.front()));
      for (const json& fault : run["faults"]) CHECK_MESSAGE(false, fault.dump());
      fmt::print("{:<20} started after {:4.0f} ms, {:3.0f} frames per second\n", name, started,
                 run["rate"].get<double>());
      check_numbers(figure);
      check_input(figure);
    }
    resize(390);
    for (int figure = 0; figure < count; ++figure)
      CHECK(evaluate_in(figure, "place.scrollWidth <= place.clientWidth") == true);
    // Figures are made alike: only the first with every kind of control is judged whole.
    if (!judged && !std::string_view(SITE_AXE).empty() &&
        browser().evaluate("!!document.querySelector('.live select')")) {
      check_accessibility();
      judged = true;
    }
    check_events();
  }
}

TEST_CASE("without WebAssembly, and on paper, the still picture stays") {
  const std::string page = pages_with_figures().front();
  const std::string still_height = "document.querySelector('figure:has(> .live) > svg').getBoundingClientRect().height";
  open_page(page);
  browser().evaluate("open_figure(0)");
  CHECK(browser().evaluate(still_height) == 0);
  set_media(json::array(), "print");
  CHECK(browser().evaluate(still_height) > 20);
  CHECK(browser().evaluate("places[0].getBoundingClientRect().height") == 0);
  set_media(json::array());
  const json script =
      browser().call("Page.addScriptToEvaluateOnNewDocument", {{"source", "delete window.WebAssembly"}});
  open_page(page);
  browser().evaluate("places[0].closest('figure').scrollIntoView(), wait(300)");
  CHECK(browser().evaluate(still_height) > 20);
  CHECK(browser().evaluate("places[0].childElementCount") == 0);
  browser().call("Page.removeScriptToEvaluateOnNewDocument", script);
  browser().call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  browser().open("file://" SITE_NOTES "/" + page);
  CHECK(browser().evaluate(still_height) > 20);
  browser().call("Emulation.setScriptExecutionDisabled", {{"value", false}});
  check_events();
}

TEST_CASE("where motion is to be reduced, an answer alone moves nothing") {
  set_media({{{"name", "prefers-reduced-motion"}, {"value", "reduce"}}});
  open_page(pages_with_figures().front());
  browser().evaluate("open_figure(0)");
  evaluate_in(0, "place.querySelector('.question button').click()");
  CHECK(evaluate_in(0, "live.playing") == false);
  CHECK(evaluate_in(0, "live.settings.disabled") == false);
  set_media(json::array());
}
