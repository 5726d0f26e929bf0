/// @file
/// What is wrong with a site, as its readers meet it in a browser: one sentence per fault.
#pragma once

#include "tests/site/browser.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace workbook::site {

struct Counts {
  int pages = 0;
  int formulas = 0;
  int pictures = 0;
  int links = 0;
};

/// Of the height of a lecture, with everything folded, in percent.
struct Shares {
  double code = 0;  ///< with printed output
  double figures = 0;
};

class Inspection {
 public:
  /// @param root the folder of the site, opened as files
  Inspection(Browser& browser, const std::filesystem::path& root);

  /// How closely to look: at four widths, in some of the colours, or for one of many pages made alike at the smallest.
  enum class Widths { all, smallest };

  /// Opens a page and judges all that can be seen on it alone.
  /// @param axe  the text of axe-core, which judges accessibility in light and dark; "" leaves that out
  void look_at(const std::string& page, const std::string& axe = "", Widths widths = Widths::all);

  /// Expects the first result of a search to lead to a paragraph that holds the words, in a lecture if any result does.
  /// A question TYPED=WORDS has a mistake: other words are to be found than those that are typed.
  void search(const std::string& page, const std::string& question);

  /// Presses Tab until the navigation and the search have had the focus, and the keys that turn pages.
  void walk_with_keyboard(const std::string& page);

  /// Opens a page without its scripts and expects every formula on a line of its own to be shown.
  void read_without_scripts(const std::string& page);

  /// Rests the pointer on the first link to a numbered formula and expects a preview that goes when the pointer does.
  /// Returns false if the page has no such link.
  bool rest_on_citation(const std::string& page);

  /// Expects the numbers of formulas and figures on the pages looked at so far to have no gaps.
  void expect_numbers();

  /// Judges the links between the pages looked at so far.
  void follow_links();

  /// Expects each name, such as a diagnosis gives for further reading, to be an anchor on exactly one page.
  void expect_anchors(const std::set<std::string>& names);

  /// Of the page that was looked at last.
  Shares measure_shares();

  /// Writes pictures of the page at every width, in some of the colours.
  void photograph(const std::string& page, const std::filesystem::path& folder);

  const std::vector<std::string>& faults() const { return faults_; }
  const Counts& counts() const { return counts_; }

  void fault(const std::string& page, const std::string& sentence);

 private:
  struct Link {
    std::string page;
    std::string name;
    std::string to;
  };

  std::string url(const std::string& page) const;
  void open(const std::string& page);
  /// Laid out to its end, which readers get part by part.
  void open_whole(const std::string& page);
  void judge_happenings(const std::string& page);
  void judge_look(const std::string& page, const nlohmann::json& look);
  void judge_accessibility(const std::string& page, const std::string& axe);
  void follow(const Link& link);

  Browser& browser_;
  std::filesystem::path root_;
  std::vector<std::string> faults_;
  std::map<std::string, std::set<std::string>> anchors_;  ///< of each page
  std::set<std::string> numbers_;                         ///< eq_6_12, fig_6_3
  std::vector<Link> links_;
  Counts counts_;
};

/// All pages of a site in the order of their names; what lies in folders belongs to the pages, not to the readers.
/// @throws std::runtime_error when there is none.
std::vector<std::string> pages_of(const std::filesystem::path& root);

/// Every paragraph to which the diagnoses of the reference results refer: the values of all keys "notes" in the JSON
/// files of a folder.
/// @throws std::runtime_error when the folder holds no such file.
std::set<std::string> anchors_of_diagnoses(const std::filesystem::path& folder);

/// @throws std::runtime_error when the file cannot be read.
std::string read_text(const std::filesystem::path& file);

}  // namespace workbook::site
