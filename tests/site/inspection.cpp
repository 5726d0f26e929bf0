#include "tests/site/inspection.hpp"

#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <thread>

namespace workbook::site {

using nlohmann::json;

namespace {

struct Setting {
  int width;
  const char* colors;
};

/// Wide pages in one colour each: what fits seldom depends on colours, nor contrast on the width.
constexpr std::array settings{Setting{1280, "light"}, Setting{1024, "dark"}, Setting{390, "dark"},
                              Setting{390, "light"}, Setting{1600, "light"}};

/// A script of this folder, to be evaluated in the page.
std::string script(const char* name) { return read_text(std::filesystem::path(SITE_SCRIPTS) / name); }

void resize(Browser& browser, int width, int height = 900) {
  browser.call("Emulation.setDeviceMetricsOverride",
               {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", width < 768}});
}

void prefer(Browser& browser, const char* colors) {
  browser.call("Emulation.setEmulatedMedia",
               {{"features", json::array({{{"name", "prefers-color-scheme"}, {"value", colors}}})}});
}

/// Until the page has been laid out and painted again.
void settle(Browser& browser) {
  browser.evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))");
}

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> beginnings) {
  return std::ranges::any_of(beginnings, [&](std::string_view beginning) { return text.starts_with(beginning); });
}

std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      plain += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

void press(Browser& browser, const std::string& key, int code) {
  json event{{"type", "rawKeyDown"}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}};
  if (key.size() == 1) event.update({{"type", "keyDown"}, {"text", key}});
  browser.call("Input.dispatchKeyEvent", event);
  event.erase("text");
  event["type"] = "keyUp";
  browser.call("Input.dispatchKeyEvent", event);
}

/// Without a paragraph of its own, a diagnosis has an empty name: it leads to that of its exercise.
void collect_notes(const json& part, std::set<std::string>& notes) {
  if (part.is_object() && part.contains("notes") && part["notes"].is_string() &&
      !part["notes"].get_ref<const std::string&>().empty())
    notes.insert(part["notes"]);
  if (part.is_structured()) {
    for (const json& below : part) collect_notes(below, notes);
  }
}

}  // namespace

Inspection::Inspection(Browser& browser, const std::filesystem::path& root)
    : browser_(browser), root_(std::filesystem::canonical(root)) {}

std::string Inspection::url(const std::string& page) const { return "file://" + (root_ / page).string(); }

void Inspection::fault(const std::string& page, const std::string& sentence) {
  const std::string whole = fmt::format("{}: {}", page, sentence);
  if (std::ranges::find(faults_, whole) == faults_.end()) faults_.push_back(whole);
}

void Inspection::open(const std::string& page) { browser_.open(url(page)); }

void Inspection::open_whole(const std::string& page) {
  open(page);
  browser_.evaluate(R"js(document.head.insertAdjacentHTML("beforeend",
    "<style>.passage { content-visibility: visible !important }</style>"))js");
}

void Inspection::look_at(const std::string& page, const std::string& axe, Widths widths) {
  ++counts_.pages;
  resize(browser_, settings.front().width);
  prefer(browser_, settings.front().colors);
  browser_.take_events();
  open_whole(page);
  static const std::string look = script("look.js"), fit = script("fit.js");
  judge_look(page, browser_.evaluate(look));
  if (!axe.empty()) judge_accessibility(page, axe);
  for (const Setting& setting : settings) {
    if (widths == Widths::smallest && setting.width != 390) continue;
    prefer(browser_, setting.colors);
    resize(browser_, setting.width);
    settle(browser_);
    for (const std::string found : browser_.evaluate(fit))
      fault(page, fmt::format("at a width of {} pixels, {}, {}.", setting.width, setting.colors, found));
  }
  judge_happenings(page);
}

void Inspection::judge_accessibility(const std::string& page, const std::string& axe) {
  // Everything open, so that nothing is left unjudged.
  browser_.evaluate("document.querySelectorAll('details').forEach(part => part.open = true), null");
  browser_.evaluate(axe + ";null");
  // All rules in light; in the dark only the colours differ.
  for (const auto& [colors, rules] : {std::pair{"light", ""}, {"dark", ", runOnly: ['color-contrast']"}}) {
    prefer(browser_, colors);
    settle(browser_);
    const json violations =
        browser_.evaluate(fmt::format("axe.run(document, {{ resultTypes: ['violations'], preload: false{} }})", rules) +
                          ".then(report => report.violations"
                          ".filter(found => ['serious', 'critical'].includes(found.impact))"
                          ".map(found => [found.id, found.help, found.nodes.length, found.nodes[0].html.slice(0, 120),"
                          " (found.nodes[0].any[0]?.message ?? '').slice(0, 160)]))");
    for (const json& found : violations) {
      fault(page, fmt::format("{}: {} ({} times, first at {}; {}), {}.", found[0].get<std::string>(),
                              found[1].get<std::string>(), found[2].get<int>(), found[3].get<std::string>(),
                              found[4].get<std::string>(), colors));
    }
  }
  browser_.evaluate("document.querySelectorAll('.contents details').forEach(part => part.open = false), null");
}

void Inspection::judge_happenings(const std::string& page) {
  std::map<std::string, std::string> asked;
  for (const json& event : browser_.take_events()) {
    const std::string method = event["method"];
    const json& about = event["params"];
    if (method == "Network.requestWillBeSent") {
      const std::string to = about["request"]["url"];
      asked[about["requestId"]] = to;
      if (!starts_with_any(to, {"file:", "data:", "blob:", "about:"})) {
        fault(page, fmt::format("the page asks another machine for {}.", to));
      }
    } else if (method == "Network.loadingFailed") {
      const std::string& to = asked[about["requestId"]];
      if (to.starts_with("file:")) fault(page, fmt::format("{} cannot be loaded.", to.substr(to.rfind('/') + 1)));
    } else if (method == "Runtime.exceptionThrown") {
      const json& details = about["exceptionDetails"];
      fault(page,
            "a script stopped: " + details.value("/exception/description"_json_pointer, details.value("text", "")));
    } else if (method == "Runtime.consoleAPICalled" && (about["type"] == "error" || about["type"] == "assert")) {
      std::string words;
      for (const json& word : about["args"])
        words += " " + word.value("value", json(word.value("description", ""))).dump();
      fault(page, "a script reports an error:" + words);
    } else if (method == "Log.entryAdded" && about["entry"]["level"] == "error" &&
               about["entry"]["source"] != "network") {
      fault(page, "the browser reports an error: " + about["entry"]["text"].get<std::string>());
    }
  }
}

void Inspection::judge_look(const std::string& page, const json& look) {
  for (const std::string element : look["unnumbered"])
    fault(page, fmt::format("{} has no number that is its address.", element));
  for (const std::string number : look["numbers"]) {
    if (!numbers_.insert(number).second) fault(page, fmt::format("the number {} stands twice.", number));
  }
  for (const std::string id : look["twice"]) fault(page, fmt::format("two elements have the id {}.", id));
  for (const std::string text : look["raw_texts"]) fault(page, fmt::format("“{}” is not meant for readers.", text));
  for (const std::string picture : look["stuck"]) fault(page, fmt::format("{} does not move.", picture));
  for (const std::string call : look["unlinked"])
    fault(page, fmt::format("a call of {} does not lead to the page of its exercise.", call));
  for (const std::string landmark : look["landmarks"]) fault(page, fmt::format("the page has no <{}>.", landmark));
  for (const json& picture : look["pictures"]) {
    const std::string name = picture["name"];
    if (!picture["loaded"]) fault(page, fmt::format("the picture {} is not shown.", name));
    if (!picture["described"]) fault(page, fmt::format("the picture {} has no alternative text.", name));
  }
  for (const std::string object : look["objects"]) {
    fault(page,
          fmt::format("{} is a document within the page, which readers may not see; show it as a picture.", object));
  }
  anchors_[page] = look["anchors"].get<std::set<std::string>>();
  for (const json& link : look["links"]) links_.push_back({page, link["name"], link["to"]});
  counts_.formulas += look["formulas"].get<int>();
  counts_.pictures += static_cast<int>(look["pictures"].size());
  counts_.links += static_cast<int>(look["links"].size());
}

void Inspection::read_without_scripts(const std::string& page) {
  browser_.call("Emulation.setScriptExecutionDisabled", {{"value", true}});
  open(page);
  const json hidden = browser_.evaluate(R"(
    [...document.querySelectorAll(".contents p.formulaDsp")].filter(formula => !formula.closest("details"))
      .filter(formula => !(formula.querySelector(".katex-html")?.getBoundingClientRect().height > 10))
      .map(formula => formula.textContent.trim().slice(0, 40)))");
  browser_.call("Emulation.setScriptExecutionDisabled", {{"value", false}});
  for (const std::string formula : hidden)
    fault(page, fmt::format("the formula “{}” is not shown without scripts.", formula));
}

bool Inspection::rest_on_citation(const std::string& page) {
  resize(browser_, 1280);
  open(page);
  const json place = browser_.evaluate(R"js((() => {
    const link = document.querySelector(".textblock a[href*='#eq_']:not(.number)");
    link?.scrollIntoView({ block: "center" });
    const box = link?.getBoundingClientRect();
    return box ? [box.x + 3, box.y + box.height / 2] : null;
  })())js");
  if (place.is_null()) return false;
  const auto shown = [&](const json& x, const json& y, bool wanted) {
    browser_.call("Input.dispatchMouseEvent", {{"type", "mouseMoved"}, {"x", x}, {"y", y}});
    for (int tries = 0; tries < 300; ++tries) {
      if (browser_.evaluate("document.querySelector('iframe.preview')?.style.visibility === ''") == wanted) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  };
  if (!shown(place[0], place[1], true)) fault(page, "a link to a formula shows no preview.");
  if (!shown(5, 5, false)) fault(page, "a preview stays when the pointer has left the link.");
  return true;
}

void Inspection::expect_numbers() {
  for (const std::string& number : numbers_) {
    const auto last = number.rfind('_') + 1;
    const std::string before = number.substr(0, last) + std::to_string(std::stoi(number.substr(last)) - 1);
    if (!before.ends_with("_0") && !numbers_.contains(before))
      faults_.push_back(fmt::format("There is a number {}, but no {}.", number, before));
  }
}

void Inspection::follow_links() {
  for (const Link& link : links_) follow(link);
}

void Inspection::follow(const Link& link) {
  // What lies on other machines may come and go, and is not ours to ask for.
  if (starts_with_any(link.to, {"http:", "https:", "mailto:", "javascript:"})) return;
  const auto hash = link.to.find('#');
  const std::string target = decoded(link.to.substr(0, hash));
  const std::string anchor = hash == std::string::npos ? "" : decoded(link.to.substr(hash + 1));
  const std::string beginning = url("");
  if (!target.starts_with(beginning)) {
    fault(link.page, fmt::format("{} leads outside the site, to {}.", link.name, target.substr(target.find("//") + 2)));
    return;
  }
  const std::string file = target.substr(beginning.size());
  if (!std::filesystem::is_regular_file(root_ / file)) {
    fault(link.page, fmt::format("{} leads to {}, which does not exist.", link.name, file));
  } else if (!anchor.empty() && anchors_.contains(file) && !anchors_[file].contains(anchor)) {
    fault(link.page, fmt::format("{} leads to #{} on {}, which does not exist.", link.name, anchor, file));
  }
}

void Inspection::expect_anchors(const std::set<std::string>& names) {
  for (const std::string& name : names) {
    const auto count = std::ranges::count_if(anchors_, [&](const auto& page) { return page.second.contains(name); });
    if (count != 1) {
      faults_.push_back(fmt::format(
          "#{}, which a diagnosis names for further reading, stands on {} pages instead of one.", name, count));
    }
  }
}

void Inspection::search(const std::string& page, const std::string& question) {
  const auto equals = question.find('=');
  const std::string typed = question.substr(0, equals), words = question.substr(equals + 1);  // npos + 1 is 0
  resize(browser_, 1280);
  open(page);
  browser_.evaluate("document.querySelector('#query')?.focus()");
  browser_.call("Input.insertText", {{"text", typed}});
  json link;
  // The words of the site are loaded at the first letter.
  for (int tries = 0; tries < 300 && link.is_null(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    link = browser_.evaluate("document.querySelector('#places a')?.href ?? null");
  }
  if (link.is_null()) return fault(page, fmt::format("the search for “{}” finds nothing.", typed));
  follow({page, fmt::format("a result of the search for “{}”", typed), link});
  if (browser_.evaluate(
          "[...document.querySelectorAll('#places a')].findIndex(link => /lecture_/.test(link.href)) > 0"))
    fault(page, fmt::format("the search for “{}” has a lecture, but not first.", typed));
  const std::string address = link;
  browser_.open("about:blank");  // or else only the place on the page would change
  browser_.open(address);
  // From the heading with the anchor, or from the top, to the next heading.
  const std::string paragraph = browser_.evaluate(R"((() => {
    const anchor = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    let element = anchor ? anchor.closest("h1, h2, h3, h4") ?? anchor : document.querySelector(".textblock").firstElementChild;
    let text = document.title;
    do { text += " " + element.textContent; element = element.nextElementSibling; }
    while (element && !/^H\d$/.test(element.tagName));
    return text.toLowerCase().replace(/\s+/g, " ");
  })())");
  std::istringstream wanted(words);
  for (std::string word; wanted >> word;) {
    std::ranges::transform(word, word.begin(), [](unsigned char letter) { return std::tolower(letter); });
    if (paragraph.find(word) == std::string::npos) {
      fault(page, fmt::format("the search for “{}” leads to {}, which does not have “{}”.", typed,
                              address.substr(address.rfind('/') + 1), word));
    }
  }
  judge_happenings(page);
}

void Inspection::walk_with_keyboard(const std::string& page) {
  for (const int width : {1280, 390}) {
    resize(browser_, width);
    open(page);
    std::set<std::string> reached;
    for (int tabs = 0; tabs < 60 && reached.size() < 3; ++tabs) {
      press(browser_, "Tab", 9);
      reached.insert(
          browser_.evaluate("document.activeElement.closest('#MSearchBox') ? 'search'"
                            " : document.activeElement.closest('nav, #menu') ? 'navigation' : ''"));
    }
    for (const char* part : {"navigation", "search"}) {
      // On a telephone the search stands in the menu.
      if (!reached.contains(part) && !(width == 390 && std::string(part) == "search" && reached.contains("navigation")))
        fault(page, fmt::format("at a width of {} pixels Tab does not reach the {}.", width, part));
    }
  }
  resize(browser_, 1280, 300);
  for (const auto& [key, code] : {std::pair{"PageDown", 34}, {" ", 32}, {"End", 35}, {"ArrowDown", 40}}) {
    open(page);
    settle(browser_);  // a key before the first paint is dropped
    press(browser_, key, code);
    bool moved = false;
    for (int tries = 0; tries < 300 && !moved; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      moved = browser_.evaluate("scrollY > 0");
    }
    if (!moved) fault(page, fmt::format("the key “{}” does not move the page.", key));
  }
}

Shares Inspection::measure_shares() {
  resize(browser_, 1280);
  settle(browser_);
  static const std::string shares = script("shares.js");
  const json found = browser_.evaluate(shares);
  return {found["code"], found["figures"]};
}

void Inspection::photograph(const std::string& page, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  open_whole(page);
  for (const Setting& setting : settings) {
    resize(browser_, setting.width);
    prefer(browser_, setting.colors);
    settle(browser_);
    const int height = browser_.evaluate("document.documentElement.scrollHeight");
    resize(browser_, setting.width, std::min(height, 16000));
    settle(browser_);
    const json picture = browser_.call("Page.captureScreenshot", {{"format", "png"}});
    const auto file = folder / fmt::format("{}.{}.{}.png", std::filesystem::path(page).stem().string(), setting.width,
                                           setting.colors);
    std::ofstream(file, std::ios::binary) << from_base64(picture["data"].get<std::string>());
  }
}

std::vector<std::string> pages_of(const std::filesystem::path& root) {
  std::vector<std::string> pages;
  if (std::filesystem::is_directory(root)) {
    for (const auto& file : std::filesystem::directory_iterator(root)) {
      if (file.path().extension() == ".html") pages.push_back(file.path().filename());
    }
  }
  if (pages.empty())
    throw std::runtime_error(fmt::format("{} holds no pages: build the target notes first.", root.string()));
  std::ranges::sort(pages);
  return pages;
}

std::set<std::string> anchors_of_diagnoses(const std::filesystem::path& folder) {
  std::set<std::string> notes;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      if (file.path().extension() != ".json") continue;
      // A line with the checksum precedes the results.
      std::istringstream in(read_text(file.path()));
      for (json value; (in >> std::ws).peek() != EOF;) {
        in >> value;
        collect_notes(value, notes);
      }
    }
  }
  if (notes.empty()) {
    throw std::runtime_error(
        fmt::format("{} holds no reference results that name paragraphs of the notes.", folder.string()));
  }
  return notes;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(fmt::format("{} cannot be read.", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace workbook::site
