// A copy for students goes from one release to the next, and nothing of the student's is lost.
#include "checker/course/release.hpp"

#include "tests/program/program.hpp"

#include <doctest/doctest.h>

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
  for (const char* damage : {"", "{", R"({"number": 2, "seed": 1, "changes": [], "files": {"../outside": "x"}})",
                             R"({"number": 2, "seed": 1, "changes": [], "files": {"/etc/passwd": "x"}})"}) {
    write(next / ".release.json", damage);
    CHECK_THROWS_AS(updated(next, copy), UsageError);
  }
  fs::remove(next / ".release.json");
  CHECK_THROWS_AS(updated(next, copy), UsageError);
  CHECK(read(copy / "lectures/01/notes.md") == "one");
  const CourseCopy course;
  CHECK(course.run("update .").status == 2);  // it was never handed out
}
