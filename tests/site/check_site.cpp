/// @file
/// check_site: opens every page of the notes in a browser and says what is wrong with it. Exit status: 0 nothing is
/// wrong, 1 something is, 2 wrong usage, 3 the pages could not be looked at.
#include "tests/site/inspection.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <exception>

using namespace workbook::site;

int main(int argc, char** argv) {
  CLI::App app(
      "Opens every page of a site in headless Chromium and says, in one sentence each, what is wrong with it.");
  std::filesystem::path root;
  std::filesystem::path chromium = SITE_CHROMIUM;
  std::filesystem::path references;
  std::filesystem::path pictures;
  std::vector<std::string> only;
  std::string word;
  app.add_option("SITE", root, "folder of the built site")->required();
  app.add_option("--chromium", chromium, "the browser")->capture_default_str();
  app.add_option("--references", references, "folder of reference results; the paragraphs they name must exist");
  app.add_option("--search", word, "a word that the search of the first page must find");
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
    Browser browser(chromium);
    Inspection inspection(browser, root);
    if (!pictures.empty()) {
      for (const std::string& page : pages) inspection.photograph(page, pictures);
      return 0;
    }
    for (const std::string& page : pages) inspection.look_at(page);
    inspection.follow_links();
    if (!word.empty()) {
      inspection.search("index.html", word);
      inspection.walk_with_keyboard("index.html");
    }
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
