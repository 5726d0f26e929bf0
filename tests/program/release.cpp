// A copy for students goes from one release to the next, and nothing of the student's is lost.
#include "checker/course/release.hpp"

#include "tests/program/program.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <map>

using namespace workbook;
using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

/// A release with these files, in a folder of its own.
fs::path made(const std::string& name, const Files& files, const fs::path& before = {}) {
  fs::path folder = fs::path(WORKBOOK_TEST_SCRATCH) / "releases" / name;
  fs::remove_all(folder);
  for (const auto& [file, text] : files) write(folder / file, text);
  std::optional<Release> earlier;
  if (!before.empty()) earlier = read_release(before);
  write_release(folder, 7, "2027-02-01", "notes corrected", earlier);
  return folder;
}

UpdateResult updated(const fs::path& next, const fs::path& copy) {
  return update_copy(next, read_release(next), copy, read_release(copy));
}

const Files first = {{"README.md", "one"},
                     {"lectures/01/notes.md", "one"},
                     {"lectures/01/old.md", "one"},
                     {"lectures/01/exercises/begun.cpp", "stub"},
                     {"lectures/01/exercises/fresh.cpp", "stub"},
                     {"lectures/01/exercises/same.cpp", "stub"}};
const Files second = {{"README.md", "one"},
                      {"lectures/01/notes.md", "two"},
                      {"lectures/01/new.md", "two"},
                      {"lectures/01/exercises/begun.cpp", "stub of two"},
                      {"lectures/01/exercises/fresh.cpp", "stub of two"},
                      {"lectures/01/exercises/same.cpp", "stub"}};

}  // namespace

TEST_CASE("an update brings what is new and leaves what the student has written") {
  const fs::path copy = made("copy", first), next = made("next", second, copy);
  write(copy / "lectures/01/exercises/begun.cpp", "mine");
  write(copy / "lectures/01/exercises/same.cpp", "mine");
  write(copy / "lectures/01/notes.md", "my remarks");
  write(copy / "README.md", "my remarks");
  write(copy / "drafts/spin.cpp", "mine");

  const UpdateResult result = updated(next, copy);
  CHECK(result.own == std::vector<std::string>{"lectures/01/exercises/begun.cpp"});
  CHECK(result.kept == std::vector<std::string>{".workbook/kept/lectures/01/notes.md"});
  CHECK(result.written == 3);
  const Files expected = {{"lectures/01/exercises/begun.cpp", "mine"},
                          {"lectures/01/exercises/same.cpp", "mine"},
                          {"lectures/01/exercises/fresh.cpp", "stub of two"},
                          {"lectures/01/notes.md", "two"},
                          {"lectures/01/new.md", "two"},
                          {"README.md", "my remarks"},
                          {"drafts/spin.cpp", "mine"},
                          {".workbook/kept/lectures/01/notes.md", "my remarks"}};
  for (const auto& [file, text] : expected) CHECK_MESSAGE(read(copy / file) == text, file);
  CHECK(!fs::exists(copy / "lectures/01/old.md"));
  CHECK(read_release(copy).number == 2);

  const UpdateResult again = updated(next, copy);
  CHECK(again.written == 0);
  CHECK(again.kept.empty());
}

TEST_CASE("an update that was stopped goes on, and takes what it has written for no student's work") {
  const fs::path copy = made("copy", first), next = made("next", second, copy);
  write(copy / "lectures/01/notes.md", "two");
  const UpdateResult result = updated(next, copy);
  CHECK(result.kept.empty());
  CHECK(result.written == 3);
}

TEST_CASE("a release that is not whole changes nothing") {
  const std::vector<std::pair<const char*, void (*)(const fs::path&)>> damages = {
      {"another text", [](const fs::path& file) { write(file, "somebody else's"); }},
      {"no file", [](const fs::path& file) { fs::remove(file); }},
      {"a link",
       [](const fs::path& file) {
         fs::rename(file, file.string() + ".away");
         fs::create_symlink(file.string() + ".away", file);
       }},
      {"a linked folder", [](const fs::path& file) {
         fs::rename(file.parent_path(), file.parent_path().string() + ".away");
         fs::create_directory_symlink(file.parent_path().string() + ".away", file.parent_path());
       }}};
  for (const auto& [about, damage] : damages) {
    CAPTURE(about);
    const fs::path copy = made("copy", first), next = made("next", second, copy);
    damage(next / "lectures/01/notes.md");
    try {
      updated(next, copy);
      FAIL_CHECK("not refused");
    } catch (const UsageError& problem) {
      CHECK_MESSAGE(has(problem.what(), "lectures/01"), problem.what());
    }
    for (const auto& [file, text] : first) CHECK_MESSAGE(read(copy / file) == text, file);
    CHECK(read_release(copy).number == 1);
    CHECK(!fs::exists(copy / "lectures/01/new.md"));
  }
}

TEST_CASE("nothing is written through a link of the copy") {
  for (const char* linked : {"lectures/01", "lectures/01/notes.md", ".workbook"}) {
    CAPTURE(linked);
    const fs::path copy = made("copy", first), next = made("next", second, copy),
                   outside = copy.parent_path() / "outside";
    write(copy / "lectures/01/notes.md", "my remarks");
    fs::remove_all(outside);
    if (fs::exists(copy / linked))
      fs::rename(copy / linked, outside);
    else
      fs::create_directories(outside);
    fs::create_symlink(outside, copy / linked);
    CHECK_THROWS_AS(updated(next, copy), UsageError);
    CHECK(read_release(copy).number == 1);
    CHECK(read(copy / "lectures/01/notes.md") == "my remarks");
    CHECK(!fs::exists(outside / "new.md"));
    CHECK(!fs::exists(outside / "kept"));
  }
}

TEST_CASE("an update that cannot go on says what it has done, and goes on later") {
  const fs::path copy = made("copy", first), next = made("next", second, copy);
  fs::create_directories(copy / "lectures/01/new.md/in the way");
  try {
    updated(next, copy);
    FAIL_CHECK("not refused");
  } catch (const UsageError& problem) {
    CHECK_MESSAGE(has(problem.what(), "new.md cannot be written"), problem.what());
    CHECK_MESSAGE(has(problem.what(), "2 of 4 files"), problem.what());
  }
  CHECK(read(copy / "lectures/01/exercises/fresh.cpp") == "stub of two");
  CHECK(read(copy / "lectures/01/notes.md") == "one");
  CHECK(read_release(copy).number == 1);
  fs::remove_all(copy / "lectures/01/new.md");
  CHECK(updated(next, copy).written == 2);
  CHECK(read(copy / "lectures/01/notes.md") == "two");
}

TEST_CASE("programs of a release can be run in the copy") {
  const fs::path copy = made("copy", {{"checker/run", "one"}}), next = made("next", {{"checker/run", "two"}}, copy);
  fs::permissions(next / "checker/run", fs::perms::owner_all);
  CHECK(updated(next, copy).written == 1);
  CHECK(fs::status(copy / "checker/run").permissions() == fs::perms::owner_all);
}

TEST_CASE("the next release of a copy keeps its assignment, and what is locked as long as the solution is the same") {
  CourseCopy().check_story("handing_out");
}

TEST_CASE("the change log names what is new since a release") {
  const fs::path copy = made("copy", first), next = made("next", second, copy);
  const Release release = read_release(next);
  REQUIRE(release.changes.size() == 1);
  CHECK(release.changes.front().release == 2);
  CHECK(release.changes.front().message == "notes corrected");
  CHECK(release.changes.front().files ==
        std::vector<std::string>{"lectures/01/exercises/begun.cpp", "lectures/01/exercises/fresh.cpp",
                                 "lectures/01/new.md", "lectures/01/notes.md", "lectures/01/old.md"});
}

TEST_CASE("what is no release, is damaged, or leads outside is refused before anything is written") {
  const fs::path copy = made("copy", first), next = made("next", second, copy);
  std::vector<std::string> damages = {"", "{"};
  for (const char* file : {"../outside", "/etc/passwd", "a/../../b", "lectures/", ".git", "lectures/.git",
                           ".git/hooks/post-checkout", ".workbook/progress.json", "lectures/.hidden/notes.md"})
    damages.push_back(fmt::format(R"({{"number": 2, "seed": 1, "changes": [], "files": {{"{}": "x"}}}})", file));
  for (const std::string& damage : damages) {
    CAPTURE(damage);
    write(next / ".release.json", damage);
    CHECK_THROWS_AS(updated(next, copy), UsageError);
  }
  fs::remove(next / ".release.json");
  CHECK_THROWS_AS(updated(next, copy), UsageError);
  CHECK(read(copy / "lectures/01/notes.md") == "one");
  const CourseCopy course;
  CHECK(course.run("update .").status == 2);  // it was never handed out
}
