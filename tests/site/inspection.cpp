#include "tests/site/inspection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string_view>
#include <thread>

namespace workbook::site {

using nlohmann::json;

namespace {

struct Setting {
  const char* name;
  int width;
  int height;
  const char* colors;
};

constexpr std::array settings{Setting{"wide-light", 1280, 900, "light"}, Setting{"wide-dark", 1280, 900, "dark"},
                              Setting{"narrow-light", 390, 844, "light"}, Setting{"narrow-dark", 390, 844, "dark"}};

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(fmt::format("{} cannot be read.", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A script of this folder, to be evaluated in the page.
std::string script(const char* name) { return read(std::filesystem::path(SITE_SCRIPTS) / name); }

void resize(Browser& browser, int width, int height) {
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

std::string from_base64(const std::string& text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const auto digit = digits.find(c);
    if (digit == std::string_view::npos) break;
    bits = bits << 6 | static_cast<unsigned>(digit);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

void press(Browser& browser, const char* key, int code) {
  for (const char* type : {"rawKeyDown", "keyUp"}) {
    browser.call("Input.dispatchKeyEvent",
                 {{"type", type}, {"key", key}, {"code", key}, {"windowsVirtualKeyCode", code}});
  }
}

void collect_notes(const json& part, std::set<std::string>& notes) {
  if (part.is_object() && part.contains("notes") && part["notes"].is_string()) notes.insert(part["notes"]);
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

void Inspection::open(const std::string& page) {
  browser_.open(url(page));
  // Formulas are drawn after loading.
  const bool drawn = browser_.evaluate(R"(new Promise(done => {
    if (!window.MathJax) return done(true);
    setTimeout(() => done(false), 10000);
    MathJax.Hub.Register.StartupHook("End", () => { MathJax.Hub.Queue(() => done(true)); });
  }))");
  if (!drawn) fault(page, "the formulas are still not drawn after 10 seconds.");
}

void Inspection::look_at(const std::string& page) {
  ++counts_.pages;
  resize(browser_, settings.front().width, settings.front().height);
  prefer(browser_, settings.front().colors);
  browser_.take_events();
  open(page);
  static const std::string look = script("look.js");
  judge_look(page, browser_.evaluate(look));
  int width = 0;
  for (const Setting& setting : settings) {
    prefer(browser_, setting.colors);
    if (setting.width != width) {
      width = setting.width;
      resize(browser_, setting.width, setting.height);
      // The page's own scripts arrange it anew when its width has changed.
      settle(browser_);
    }
    static const std::string overflow = script("overflow.js");
    const json found = browser_.evaluate(overflow);
    if (found.is_null()) continue;
    fault(page, fmt::format("at a width of {} pixels the page scrolls sideways by {} pixels because of {} (“{}”), {}.",
                            setting.width, found["pixels"].get<int>(), found["element"].get<std::string>(),
                            found["text"].get<std::string>(), setting.colors));
  }
  judge_happenings(page);
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
  for (const json& error : look["formulas"]["errors"]) {
    fault(page, fmt::format("the formula “{}” cannot be shown: {}.", error["formula"].get<std::string>(),
                            error["reason"].get<std::string>()));
  }
  for (const std::string formula : look["raw_formulas"]) {
    fault(page, fmt::format("the formula “{}” is shown as plain text.", formula));
  }
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
  counts_.formulas += look["formulas"]["count"].get<int>();
  counts_.pictures += static_cast<int>(look["pictures"].size());
  counts_.links += static_cast<int>(look["links"].size());
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

void Inspection::search(const std::string& page, const std::string& word) {
  resize(browser_, settings.front().width, settings.front().height);
  open(page);
  browser_.evaluate("document.querySelector('#MSearchField')?.focus()");
  browser_.call("Input.insertText", {{"text", word}});
  // The search listens to keys; one that types nothing tells it that the text has changed.
  press(browser_, "Shift", 16);
  json results = json::array();
  // The results appear in a frame, half a second after the last key.
  for (int tries = 0; tries < 40 && results.empty(); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const json found = browser_.evaluate_in_frame("/search/",
                                                  "[...document.querySelectorAll('.SRResult a[href]')].filter(a => "
                                                  "a.getClientRects().length > 0).map(a => a.href)");
    if (found.is_array()) results = found;
  }
  if (results.empty()) fault(page, fmt::format("the search for “{}” finds nothing.", word));
  for (const std::string result : results) follow({page, fmt::format("a result of the search for “{}”", word), result});
  judge_happenings(page);
}

void Inspection::walk_with_keyboard(const std::string& page) {
  for (const Setting& setting : {settings.front(), settings.back()}) {
    resize(browser_, setting.width, setting.height);
    open(page);
    bool navigation = false;
    bool search = false;
    for (int tabs = 0; tabs < 60 && !(navigation && search); ++tabs) {
      press(browser_, "Tab", 9);
      const std::string focus = browser_.evaluate(
          "document.activeElement.closest('#MSearchBox') ? 'search'"
          " : document.activeElement.closest('#nav-tree, #main-nav, #main-menu-state') ? 'navigation' : ''");
      navigation = navigation || focus == "navigation";
      search = search || focus == "search";
    }
    if (!navigation)
      fault(page, fmt::format("at a width of {} pixels Tab does not reach the navigation.", setting.width));
    if (!search) fault(page, fmt::format("at a width of {} pixels Tab does not reach the search.", setting.width));
  }
}

void Inspection::photograph(const std::string& page, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  open(page);
  for (const Setting& setting : settings) {
    resize(browser_, setting.width, setting.height);
    prefer(browser_, setting.colors);
    settle(browser_);
    // The text scrolls in a column of its own: a window as tall as the column shows all of it.
    const int height = browser_.evaluate(
        "Math.max(document.documentElement.scrollHeight, 60 + (document.querySelector('#doc-content')?.scrollHeight ?? "
        "0)"
        " + (document.querySelector('#nav-path')?.offsetHeight ?? 0)"
        " + (innerWidth < 768 ? document.querySelector('#top')?.offsetHeight ?? 0 : 0))");
    resize(browser_, setting.width, std::min(height, 16000));
    settle(browser_);
    const json picture = browser_.call("Page.captureScreenshot", {{"format", "png"}});
    const auto file = folder / fmt::format("{}.{}.png", std::filesystem::path(page).stem().string(), setting.name);
    std::ofstream(file, std::ios::binary) << from_base64(picture["data"]);
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
      if (file.path().extension() == ".json") collect_notes(json::parse(read(file.path())), notes);
    }
  }
  if (notes.empty()) {
    throw std::runtime_error(
        fmt::format("{} holds no reference results that name paragraphs of the notes.", folder.string()));
  }
  return notes;
}

}  // namespace workbook::site
