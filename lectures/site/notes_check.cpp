#include "lectures/site/notes_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>

namespace workbook::site {

namespace {

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
}

class Page {
 public:
  Page(const std::string& folder, const std::string& text)
      : shown_("lectures/" + folder + "/notes.md"), folder_(folder), text_(text) {}

  std::vector<std::string> faults(const std::filesystem::path& figures) {
    for (const char* part : {"lecture_card", "exercises", "lecture_links"})
      require(fmt::format("\\{}{{{}}}", part, folder_));
    refuse_bare_images();
    refuse_quoted_formulas();
    std::set<std::string> shown_figures;
    static const std::regex figure(R"(\\figure\{([^}]*)\})");
    for (std::sregex_iterator match(text_.begin(), text_.end(), figure), end; match != end; ++match) {
      const auto at = static_cast<std::size_t>(match->position());
      look_at_figure((*match)[1], at, at + static_cast<std::size_t>(match->length()), figures);
    }
    return faults_;
  }

 private:
  void fault(std::size_t position, const std::string& sentence) {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(position), '\n');
    const std::string whole = fmt::format("{}:{}: {}", shown_, line, sentence);
    if (std::ranges::find(faults_, whole) == faults_.end()) faults_.push_back(whole);
  }

  void require(const std::string& part) {
    if (text_.find(part) == std::string::npos) faults_.push_back(fmt::format("{}: the page lacks {}.", shown_, part));
  }

  // Doxygen's own ways to show a picture give it a caption or an alternative text, never both.
  void refuse_bare_images() {
    static const std::regex image(R"(\\image\b|<img\b|!\[)");
    for (std::sregex_iterator match(text_.begin(), text_.end(), image), end; match != end; ++match) {
      fault(static_cast<std::size_t>(match->position()),
            "show pictures by \\figure, which asks for alternative text and caption.");
    }
  }

  // Doxygen takes what stands between straight quotes word by word: a formula there stays TeX, and the anchors below it
  // lead nowhere.
  void refuse_quoted_formulas() {
    bool quoted = false;
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_.compare(i, 2, "\n\n") == 0) quoted = false;
      if (text_[i] == '"') quoted = !quoted;
      if (text_.compare(i, 3, "\\f$") != 0) continue;
      if (quoted) fault(i, "Doxygen does not read formulas between straight quotes: write “ and ”.");
      i = std::min(text_.find("\\f$", i + 3), text_.size() - 3) + 2;
    }
  }

  void look_at_figure(const std::string& name, std::size_t begin, std::size_t after,
                      const std::filesystem::path& figures) {
    if (!std::filesystem::is_regular_file(figures / name)) {
      fault(begin,
            fmt::format("the figure {} does not exist; figures.cpp of the lecture draws LECTURE/NAME.svg.", name));
    }
    const auto caption = text_.find("\\caption", after);
    const auto end = text_.find("\\endfigure", after);
    if (caption == std::string::npos || end == std::string::npos || end < caption) {
      fault(begin, fmt::format("the figure {} needs \\caption and then \\endfigure.", name));
      return;
    }
    const std::string alternative = trimmed(text_.substr(after, caption - after));
    if (alternative.empty()) fault(begin, fmt::format("the figure {} has no alternative text.", name));
    // The alternative text becomes an attribute in double quotes.
    if (alternative.find_first_of("\"<&") != std::string::npos) {
      fault(begin, fmt::format("the alternative text of the figure {} must do without \", < and &.", name));
    }
    if (trimmed(text_.substr(caption + 8, end - caption - 8)).empty()) {
      fault(begin, fmt::format("the figure {} has no caption.", name));
    }
  }

  std::string shown_;
  const std::string& folder_;
  const std::string& text_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of_notes(const std::string& folder, const std::string& notes,
                                         const std::filesystem::path& figures) {
  return Page(folder, notes).faults(figures);
}

}  // namespace workbook::site
