/// @file
/// check_site: opens every page of the notes in a browser and says what is wrong with it. Exit status: 0 nothing is
/// wrong, 1 something is, 2 wrong usage, 3 the pages could not be looked at.
#include "tests/site/inspection.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <exception>

using namespace workbook::site;

namespace {

constexpr double most_code = 30, least_figures = 15;

void judge_shares(Inspection& inspection, const std::string& page) {
  const Shares shares = inspection.measure_shares();
  fmt::print("{:<42} code and output {:2.0f} % of the height, figures {:2.0f} %\n", page, shares.code, shares.figures);
  if (shares.code > most_code)
    inspection.fault(
        page, fmt::format("code and output take {:.0f} % of the height, more than {:.0f} %.", shares.code, most_code));
  // Lecture 0 is about code.
  if (shares.figures < least_figures && !page.starts_with("lecture_00_"))
    inspection.fault(
        page, fmt::format("figures take {:.0f} % of the height, less than {:.0f} %.", shares.figures, least_figures));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Opens every page of a site in headless Chromium and says, in one sentence each, what is wrong with it.");
  std::filesystem::path root, references, pictures, axe_file;
  std::filesystem::path chromium = SITE_CHROMIUM;
  std::vector<std::string> only, words;
  app.add_option("SITE", root, "folder of the built site")->required();
  app.add_option("--chromium", chromium, "the browser")->capture_default_str();
  app.add_option("--references", references, "folder of reference results; the paragraphs they name must exist");
  app.add_option("--search", words,
                 "words that the search of the first page must find, or TYPED=WORDS; may be repeated");
  app.add_option("--axe", axe_file, "axe.min.js of axe-core, which judges accessibility");
  app.add_option("--pictures", pictures, "write pictures of the pages into this folder and judge nothing");
  app.add_option("--page", only, "only this page, such as index.html; may be repeated");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Also --help ends here, with status 0.
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<std::string> pages = only.empty() ? pages_of(root) : only;
    const std::string axe = axe_file.empty() ? "" : read_text(axe_file);
    Browser browser(chromium);
    Inspection inspection(browser, root);
    if (!pictures.empty()) {
      for (const std::string& page : pages) inspection.photograph(page, pictures);
      return 0;
    }
    // All pages of exercises are made alike: only the first is judged whole.
    bool exercise_judged = false, preview_judged = false;
    for (const std::string& page : pages) {
      const bool is_exercise = page.starts_with("exercise_");
      if (is_exercise && exercise_judged) {
        inspection.look_at(page, "", Inspection::Widths::smallest);
      } else {
        inspection.look_at(page, axe);
      }
      exercise_judged = exercise_judged || is_exercise;
      if (!page.starts_with("lecture_")) continue;
      judge_shares(inspection, page);
      inspection.read_without_scripts(page);
      preview_judged = preview_judged || inspection.rest_on_citation(page);
    }
    inspection.expect_numbers();
    inspection.follow_links();
    for (const std::string& phrase : words) inspection.search("index.html", phrase);
    if (!words.empty()) inspection.walk_with_keyboard("index.html");
    if (!references.empty()) inspection.expect_anchors(anchors_of_diagnoses(references));
    for (const std::string& fault : inspection.faults()) fmt::print("{}\n", fault);
    const Counts& counts = inspection.counts();
    fmt::print("{} pages, {} formulas, {} pictures, {} links: {} faults, in {:.0f} s.\n", counts.pages, counts.formulas,
               counts.pictures, counts.links, inspection.faults().size(),
               std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return inspection.faults().empty() ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 3;
  }
}
