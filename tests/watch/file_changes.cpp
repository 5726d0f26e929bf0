// Which files have changed: with the system's events, and by looking only.
#include "checker/watch/file_changes.hpp"
#include "checker/course/progress.hpp"
#include "tests/program/program.hpp"
#include "tests/watch/saving.hpp"

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>
#include <vector>

using namespace workbook;
using namespace workbook::testing;
namespace fs = std::filesystem;
using Events = FileChanges::Events;
using std::chrono::milliseconds;

namespace {

/// Two files in a folder of their own.
struct Files {
  Files() {
    fs::remove_all(folder);
    write(one, "first");
    write(two, "second");
  }
  ~Files() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  fs::path folder = fs::path(WORKBOOK_TEST_SCRATCH) / "changes" / "exercises";
  fs::path one = folder / "one.cpp";
  fs::path two = folder / "two.cpp";
};

/// What is reported within that time.
std::vector<std::size_t> changes_within(FileChanges& changes, milliseconds time) {
  std::vector<std::size_t> all;
  const auto end = Clock::now() + time;
  while (Clock::now() < end) {
    for (const std::size_t index : changes.collect()) all.push_back(index);
    std::this_thread::sleep_for(milliseconds(2));
  }
  return all;
}

/// What is reported first.
std::vector<std::size_t> first_change(FileChanges& changes, milliseconds at_most) {
  const auto end = Clock::now() + at_most;
  while (Clock::now() < end) {
    std::vector<std::size_t> found = changes.collect();
    if (!found.empty()) return found;
    std::this_thread::sleep_for(milliseconds(2));
  }
  return {};
}

const std::vector<std::size_t> nothing;
const std::vector<std::size_t> the_first{0};

}  // namespace

TEST_CASE("every way of saving is noticed once it is finished, with events and without") {
  for (const Events events : {Events::wanted, Events::unwanted}) {
    for (const Way way : all_ways) {
      CAPTURE(std::string(to_string(way)));
      CAPTURE(events == Events::wanted);
      const Files files;
      FileChanges changes({files.one, files.two}, events);
      CHECK(changes.trouble().empty());
      save(files.one, "something else of " + std::string(to_string(way)), way);
      CHECK(changes_within(changes, milliseconds(events == Events::wanted ? 100 : 600)) == the_first);
    }
  }
}

TEST_CASE("with events a save is noticed at once") {
  const Files files;
  FileChanges changes({files.one, files.two});
  changes.collect();
  const auto begun = Clock::now();
  save(files.two, "new");
  CHECK(first_change(changes, milliseconds(2000)) == std::vector<std::size_t>{1});
  CHECK(Clock::now() - begun < milliseconds(200));
}

TEST_CASE("the same content saved again is no change, and neither is what editors leave beside the file") {
  for (const Events events : {Events::wanted, Events::unwanted}) {
    const Files files;
    FileChanges changes({files.one, files.two}, events);
    for (const Way way : all_ways) save(files.one, "first", way);
    for (const char* name : {"one.cpp~", ".one.cpp.swp", "4913", "#one.cpp#", "one.cpp.bak", "three.cpp"})
      write(files.folder / name, "x");
    CHECK(changes_within(changes, milliseconds(600)) == nothing);
  }
}

TEST_CASE("a file that is being written is not reported before its writer pauses") {
  const Files files;
  FileChanges changes({files.one, files.two});
  std::ofstream slow(files.one, std::ios::trunc);
  CHECK(changes_within(changes, milliseconds(60)) == nothing);
  slow << "half" << std::flush;
  CHECK(changes_within(changes, milliseconds(60)) == nothing);
  slow << " and half" << std::flush;
  slow.close();
  CHECK(changes_within(changes, milliseconds(100)) == the_first);
}

TEST_CASE("a writer that never closes the file is noticed by the look that comes now and then") {
  const Files files;
  FileChanges changes({files.one, files.two});
  changes.collect();
  std::ofstream open_for_ever(files.one, std::ios::trunc);
  open_for_ever << "written and not closed" << std::flush;
  CHECK(first_change(changes, milliseconds(3000)) == the_first);
}

TEST_CASE("a change that keeps size, time and place of the file is seen by looking") {
  const Files files;
  FileChanges changes({files.one, files.two}, Events::unwanted);
  const auto time = fs::last_write_time(files.one);
  std::fstream(files.one, std::ios::in | std::ios::out) << "FIRST";
  fs::last_write_time(files.one, time);
  REQUIRE(read(files.one) == "FIRST");
  CHECK(first_change(changes, milliseconds(2000)) == the_first);
}

TEST_CASE("a file that is deleted is reported, and again when it is back") {
  for (const Events events : {Events::wanted, Events::unwanted}) {
    const Files files;
    FileChanges changes({files.one, files.two}, events);
    fs::remove(files.one);
    CHECK(first_change(changes, milliseconds(3000)) == the_first);
    write(files.one, "first");
    CHECK(first_change(changes, milliseconds(3000)) == the_first);
  }
}

TEST_CASE("a folder may go and come back: its files are not reported for that, but for what changed in them") {
  for (const Events events : {Events::wanted, Events::unwanted}) {
    const auto a_look = milliseconds(events == Events::wanted ? 1200 : 500);
    const Files files;
    FileChanges changes({files.one, files.two}, events);
    CHECK(changes.missing_folders().empty());
    const fs::path away = files.folder.string() + ".away";
    fs::remove_all(away);
    fs::rename(files.folder, away);
    CHECK(changes_within(changes, a_look) == nothing);
    CHECK(changes.missing_folders() == std::vector<fs::path>{files.folder});
    fs::rename(away, files.folder);
    CHECK(changes_within(changes, a_look) == nothing);
    CHECK(changes.missing_folders().empty());

    fs::remove_all(files.folder);
    CHECK(changes_within(changes, a_look) == nothing);
    write(files.one, "new");
    write(files.two, "second");
    CHECK(changes_within(changes, a_look) == the_first);
    // Events are back as well.
    save(files.two, "new");
    CHECK(first_change(changes, milliseconds(3000)) == std::vector<std::size_t>{1});
  }
}

TEST_CASE("a folder above the files may be moved away and another put in its place") {
  const Files files;
  FileChanges changes({files.one, files.two});
  const fs::path above = files.folder.parent_path();
  const fs::path away = above.string() + ".away";
  fs::remove_all(away);
  fs::rename(above, away);
  CHECK(changes_within(changes, milliseconds(1200)) == nothing);
  write(files.one, "in the new place");
  write(files.two, "second");
  CHECK(first_change(changes, milliseconds(3000)) == the_first);
  fs::remove_all(away);
}

TEST_CASE("a file that is to be reported again is, although nothing changed") {
  const Files files;
  FileChanges changes({files.one, files.two});
  changes.report_again(0);
  CHECK(changes_within(changes, milliseconds(100)) == the_first);
  CHECK(changes_within(changes, milliseconds(100)) == nothing);

  // Even if its folder is away in between.
  const fs::path away = files.folder.string() + ".away";
  fs::remove_all(away);
  fs::rename(files.folder, away);
  changes.report_again(0);
  CHECK(changes_within(changes, milliseconds(100)) == nothing);
  fs::rename(away, files.folder);
  CHECK(first_change(changes, milliseconds(3000)) == the_first);
}

TEST_CASE("content that was seen elsewhere is no change, and the content before it is one") {
  const Files files;
  FileChanges changes({files.one, files.two});
  write(files.one, "seen elsewhere");
  changes.know(0, workbook::fingerprint(files.one));
  CHECK(changes_within(changes, milliseconds(100)) == nothing);
  write(files.one, "first");
  CHECK(changes_within(changes, milliseconds(100)) == the_first);
}

TEST_CASE("where the system gives no events, the files are looked at and the reason is kept") {
  const Files files;
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  const int next = ::dup(0);
  ::close(next);
  rlimit none = before;
  none.rlim_cur = static_cast<rlim_t>(next);  // not one more descriptor
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  FileChanges changes({files.one, files.two});
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
  CHECK(changes.trouble() == "Too many open files");
  CHECK(changes.descriptor() == -1);
  changes_within(changes, milliseconds(400));  // could not read the files, either
  save(files.one, "new");
  CHECK(first_change(changes, milliseconds(2000)) == the_first);
}
