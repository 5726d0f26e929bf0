// Which files have changed: with the system's events, and by looking only.
#include "checker/commands/watch/watch.hpp"
#include "tests/watch/saving.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <unistd.h>

#include <optional>
#include <set>
#include <vector>

using namespace workbook;
using namespace workbook::testing;
namespace fs = std::filesystem;
using std::chrono::milliseconds;

namespace {

/// Two files in a folder of their own, that are watched.
struct Files {
  explicit Files(bool with_events) : events(with_events) {
    fs::remove_all(root);
    write(one, "first");
    write(two, "second");
    changes.emplace(std::vector{one, two}, events);
    CHECK(changes->events_missing().empty() == events);
  }

  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;
  ~Files() { fs::remove_all(root); }

  /// What is reported first within that time, or all of it. Counted in looks, since a busy machine may leave out any
  /// length of time.
  std::set<std::size_t> reports(milliseconds time, bool first_only = true) {
    constexpr milliseconds between_looks{2};
    std::set<std::size_t> all;
    for (auto left = time / between_looks; left > 0 && (all.empty() || !first_only); --left) {
      for (const std::size_t index : changes->collect()) all.insert(index);
      std::this_thread::sleep_for(between_looks);
    }
    return all;
  }
  std::set<std::size_t> reports_in_one_look() { return reports(milliseconds(events ? 1200 : 500), false); }

  bool events;
  /// Of this process, since watch and watch_thorough may run at the same time.
  fs::path root = fs::path(WORKBOOK_TEST_SCRATCH) / fmt::format("changes-{}", getpid());
  fs::path folder = root / "lecture" / "exercises";
  fs::path one = folder / "one.cpp";
  fs::path two = folder / "two.cpp";
  std::optional<FileChanges> changes;
};

const std::set<std::size_t> nothing;
const std::set<std::size_t> the_first{0};
const std::set<std::size_t> the_second{1};
constexpr milliseconds soon{3000};

}  // namespace

TEST_CASE("every way of saving is noticed, with events and without") {
  for (const bool events : {true, false}) {
    for (const Way& way : ways) {
      CAPTURE(std::string(way.name));
      CAPTURE(events);
      Files files(events);
      save(files.one, std::string("something else, saved ") + way.name, way);
      CHECK(files.reports(milliseconds(events ? 100 : 600), false) == the_first);
    }
  }
}

TEST_CASE("with events a save is noticed at once") {
  Files files(true);
  files.changes->collect();
  save(files.two, "new");
  CHECK(files.reports(milliseconds(200)) == the_second);
}

TEST_CASE("the same content saved again is no change, and neither is what editors leave beside the file") {
  for (const bool events : {true, false}) {
    Files files(events);
    write(files.one, "first");
    write(files.one, "first");
    for (const char* name : {"one.cpp~", ".one.cpp.swp", "4913", "#one.cpp#", "one.cpp.bak", "three.cpp"})
      write(files.folder / name, "x");
    CHECK(files.reports_in_one_look() == nothing);
  }
}

TEST_CASE("a file that is being written is not reported before its writer pauses, but if it is never closed") {
  Files files(true);
  files.changes->collect();
  std::ofstream slow(files.one, std::ios::trunc);
  for (int piece = 0; piece < 20; ++piece) {
    CHECK(files.reports(milliseconds(4)) == nothing);
    slow << "piece" << std::flush;
  }
  CHECK(files.reports(soon) == the_first);
}

TEST_CASE("a change that keeps size, time and place of the file is seen by looking") {
  Files files(false);
  const auto time = fs::last_write_time(files.one);
  std::fstream(files.one, std::ios::in | std::ios::out) << "FIRST";
  fs::last_write_time(files.one, time);
  REQUIRE(read(files.one) == "FIRST");
  CHECK(files.reports(soon) == the_first);
}

TEST_CASE("a file that is deleted is reported, and again when it is back") {
  for (const bool events : {true, false}) {
    Files files(events);
    fs::remove(files.one);
    CHECK(files.reports(soon) == the_first);
    write(files.one, "first");
    CHECK(files.reports(soon) == the_first);
  }
}

TEST_CASE("a folder may go and come back: its files are not reported for that, but for what changed in them" *
          doctest::test_suite("thorough")) {
  for (const bool events : {true, false}) {
    Files files(events);
    const fs::path away = files.folder.string() + ".away";
    fs::rename(files.folder, away);
    CHECK(files.reports_in_one_look() == nothing);
    CHECK(files.changes->missing_folders() == std::vector{files.folder});
    fs::rename(away, files.folder);
    CHECK(files.reports_in_one_look() == nothing);
    CHECK(files.changes->missing_folders().empty());

    fs::remove_all(files.folder);
    CHECK(files.reports_in_one_look() == nothing);
    write(files.one, "new");
    write(files.two, "second");
    CHECK(files.reports_in_one_look() == the_first);
    save(files.two, "new");
    CHECK(files.reports(milliseconds(events ? 300 : 3000)) == the_second);  // events are back as well
  }
}

TEST_CASE("a folder above the files may be moved away and another put in its place") {
  Files files(true);
  const fs::path above = files.folder.parent_path();
  fs::rename(above, above.string() + ".away");
  CHECK(files.reports_in_one_look() == nothing);
  write(files.one, "in the new place");
  write(files.two, "second");
  CHECK(files.reports_in_one_look() == the_first);
  save(files.two, "new");
  CHECK(files.reports(milliseconds(300)) == the_second);
}
