// The programs that make and judge the site, as programs: when they cannot do their work they say why in one sentence,
// and end with a status of their own.
#include "tests/support/files.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

const fs::path scratch = WORKBOOK_TEST_SCRATCH;

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

Outcome run(const std::string& command) {
  const fs::path out = scratch / "out.txt", err = scratch / "err.txt";
  fs::create_directories(scratch);
  const int status = run_in_shell(fmt::format("{} >'{}' 2>'{}'", command, out.string(), err.string()));
  return {status, read(out), read(err)};
}

void check_refused(const Outcome& outcome, int status, const std::string& sentence) {
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  CHECK_MESSAGE(has(outcome.err, sentence), outcome.err);
  CHECK(std::ranges::count(outcome.err, '\n') == 1);
}

/// The tiny course, with all that its page of notes needs. Each test damages a copy of its own.
class Source {
 public:
  Source() : root_(scratch / "course") {
    fs::remove_all(root_);
    fs::remove_all(output());
    fs::create_directories(scratch);
    fs::copy(WORKBOOK_TEST_COURSE, root_, fs::copy_options::recursive);
    write(facts(), "[]");
    write(notes(),
          read(notes()) + "\n\\lecture_card{01_springs}\n\\exercises{01_springs}\n\\lecture_links{01_springs}\n");
  }

  fs::path facts() const { return root_ / "lectures/site/facts.json"; }
  fs::path notes() const { return root_ / "lectures/01_springs/notes.md"; }
  fs::path card() const { return root_ / "lectures/01_springs/card.json"; }
  static fs::path output() { return scratch / "pages"; }

  Outcome pages(const fs::path& into = output()) const {
    return run(fmt::format("'{}' '{}' '{}' '{}' 01_springs", SITE_PAGES_PROGRAM, root_.string(), scratch.string(),
                           into.string()));
  }

 private:
  fs::path root_;
};

Outcome check_site(const std::string& arguments) { return run(fmt::format("'{}' {}", CHECK_SITE_PROGRAM, arguments)); }

}  // namespace

TEST_CASE("site_pages writes the pages of a sound course and says nothing") {
  const Outcome outcome = Source().pages();
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK_MESSAGE(outcome.err.empty(), outcome.err);
  for (const char* page : {"index.md", "exercises/spring_force.md", "parts/01_springs.card.md", "from_the_slides.md"})
    CHECK_MESSAGE(fs::exists(Source::output() / page), page);
}

TEST_CASE("site_pages without a lecture says how it is used") {
  check_refused(run(fmt::format("'{}' source figures output", SITE_PAGES_PROGRAM)), 2,
                "usage: site_pages SOURCE FIGURES OUTPUT LECTURE…");
}

TEST_CASE("site_pages names the file that it misses or cannot understand") {
  check_refused(run(fmt::format("'{}' /nowhere figures output 01_springs", SITE_PAGES_PROGRAM)), 1,
                "/nowhere/lectures/01_springs/card.json: the card of the lecture is missing or cannot be read.");
  {
    const Source source;
    fs::remove(source.notes());
    check_refused(source.pages(), 1, "lectures/01_springs/notes.md cannot be read.");
  }
  {
    const Source source;
    fs::remove(source.facts());
    check_refused(source.pages(), 1, source.facts().string() + ": the list of facts is missing.");
  }
  {
    const Source source;
    write(source.facts(), R"([{"number": 1, "number": 2}])");
    check_refused(source.pages(), 1, source.facts().string() + ": [0]: the key “number” stands here twice.");
  }
  {
    const Source source;
    replace_in(source.card(), "\"title\"", "\"title\": \"Waves\", \"title\"");
    check_refused(source.pages(), 1, source.card().string() + ": top level: the key “title” stands here twice.");
  }
}

TEST_CASE("site_pages names a folder that it cannot write, and writes nothing where the notes have faults") {
  const Source source;
  const fs::path occupied = scratch / "occupied";
  write(occupied, "a file, not a folder");
  check_refused(source.pages(occupied / "pages"), 1, occupied.string());
  CHECK(has(source.pages(occupied / "pages").err, "cannot be written"));

  replace_in(source.notes(), "\\exercises{01_springs}", "");
  check_refused(source.pages(), 1, "lectures/01_springs/notes.md: the page lacks \\exercises{01_springs}.");
  CHECK_FALSE(fs::exists(Source::output()));
}

TEST_CASE("check_site with wrong arguments says which, and with --help what it does") {
  const Outcome nothing = check_site("");
  CHECK(nothing.status == 2);
  CHECK_MESSAGE(has(nothing.err, "SITE is required"), nothing.err);
  const Outcome unknown = check_site("site --pigeon");
  CHECK(unknown.status == 2);
  CHECK_MESSAGE(has(unknown.err, "--pigeon"), unknown.err);
  const Outcome help = check_site("--help");
  CHECK(help.status == 0);
  CHECK(has(help.out, "--references"));
}

TEST_CASE("check_site names a folder without pages, and a browser that is not there") {
  check_refused(check_site("/nowhere"), 3, "/nowhere holds no pages: build the target notes first.");
  check_refused(check_site(fmt::format("'{}' --chromium /no/chromium", SITE_PAGES)), 3,
                "/no/chromium cannot be started: install the package chromium.");
}

TEST_CASE("check_site ends with 0 where nothing is wrong and with 1 where something is") {
  const Outcome sound = check_site(fmt::format("'{}' --page navigation.html", SITE_PAGES));
  CHECK_MESSAGE(sound.status == 0, sound.out);
  CHECK(has(sound.out, "1 pages, "));
  const Outcome broken = check_site(fmt::format("'{}' --page missing_picture.html", SITE_PAGES));
  CHECK(broken.status == 1);
  CHECK_MESSAGE(has(broken.out, "nowhere.svg"), broken.out);
}

TEST_CASE("check_site says that a folder has no reference results") {
  check_refused(check_site(fmt::format("'{}' --page navigation.html --references /nowhere", SITE_PAGES)), 3,
                "/nowhere holds no reference results that name paragraphs of the notes.");
}
