// Cards, reference results, progress and folders that are damaged: one clear sentence with file and place, no grade.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

/// Exit status 3, nothing on standard output, and one line on standard error that names the place.
void require_failure(const CourseCopy& course, const std::string& command, const std::string& place) {
  const Outcome outcome = course.run(command);
  CHECK(outcome.status == 3);
  CHECK(outcome.out.empty());
  CHECK_MESSAGE(has(outcome.err, place), outcome.err);
  CHECK_MESSAGE(std::ranges::count(outcome.err, '\n') == 1, outcome.err);
}

/// The exercises cannot be judged, the message names the place, and no score is given.
void require_checker_error(const CourseCopy& course, const std::string& place) {
  const Outcome outcome = course.run("check --json");
  CHECK(outcome.status == 3);
  CHECK(outcome.result().at("verdict") == "checker_error");
  CHECK(outcome.result().at("score").is_null());
  CHECK_MESSAGE(has(outcome.result().at("message"), place), outcome.out);
}

}  // namespace

TEST_CASE("a damaged card is named with the place of the damage") {
  const struct {
    const char* from;
    const char* to;
    const char* place;
  } damages[] = {
      {"\"title\": \"Springs\",", "", "title"},
      {"\"title\": \"Springs\"", "\"title\": 7", "title"},
      {"\"points\": 2", "\"points\": \"two\"", "/exercises/0/points"},
      {"\"points\": 2", "\"points\": 0", "points"},
      {"\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 4, \"minutes\": 5", "difficulty"},
      {"\"points\": 2", "\"points\": 2, \"problem\": true, \"difficulty\": 1", "minutes"},
      {"\"points\": 2", "\"points\": 2, \"minutes\": -5", "minutes"},
      {"spring_force", "spring_energy", "spring_energy"},
      {"\"exercises\": [", "\"exercises\": [[], ", "/exercises/0"},
      {"\"builds_on\"", "\"built_on\"", "builds_on"},
      {"}", "", ""},
      {"\"summary\"", "\"sumary\"", "summary"},
      {"\"spring_energy\"", "null", "/exercises/0/name"},
  };
  for (const auto& damage : damages) {
    CAPTURE(damage.to);
    const CourseCopy course;
    replace_in(course.card(), damage.from, damage.to);
    require_failure(course, "check spring_energy --json", damage.place);
    require_failure(course, "list", "card.json");
  }
  const CourseCopy course;
  fs::remove(course.card());
  require_failure(course, "list", "card.json");
}

TEST_CASE("damaged reference results, or some that do not fit the card, are named") {
  const std::function<void(const CourseCopy&)> damages[] = {
      [](const CourseCopy& course) { fs::resize_file(course.reference(), fs::file_size(course.reference()) / 2); },
      [](const CourseCopy& course) { replace_in(course.reference(), "no_half", "no_hald"); },
      [](const CourseCopy& course) { replace_in(course.reference(), "\"format\":", "\"format\":9"); },
      [](const CourseCopy& course) { write(course.reference(), ""); },
      [](const CourseCopy& course) { write(course.reference(), "{}\n{}\n"); },
      [](const CourseCopy& course) { write(course.reference(), std::string("\xff\xfe\0\0", 4)); },
      [](const CourseCopy& course) { fs::remove(course.reference()); },
  };
  for (const auto& damage : damages) {
    const CourseCopy course;
    damage(course);
    require_checker_error(course, "01_springs.json");
  }
  const CourseCopy course;
  replace_in(course.card(), "\"spring_energy\"", "\"spring_entropy\"");
  require_checker_error(course, "01_springs.json");
}

TEST_CASE("a course file that is damaged or missing is named: as wrong usage where it was typed") {
  const CourseCopy course;
  const fs::path file = course.root() / "course.json", alone = course.root() / "alone";
  fs::create_directories(alone);
  fs::copy_file(WORKBOOK_TEST_CHECKER, alone / "checker");
  const auto require = [&](const Outcome& outcome, int status) {
    CHECK(outcome.status == status);
    CHECK_MESSAGE(has(outcome.err, "course.json"), outcome.err);
    CHECK_MESSAGE(std::ranges::count(outcome.err, '\n') == 1, outcome.err);
  };
  for (const char* damaged : {"{", "{}", "[1]", ""}) {
    write(file, damaged);
    require(course.run("list"), 2);
    write(alone / "course.json", damaged);
    require(run_command(fmt::format("'{}' list", (alone / "checker").string()), course.root()), 3);
  }
  fs::remove(file);
  require(course.run("list"), 2);
  fs::create_directory(file);
  require(course.run("list"), 2);
}

TEST_CASE("a damaged progress file is set aside in one sentence, byte for byte, and work goes on") {
  const std::string good = R"({"format": 1, "exercises": {"spring_energy": {"verdict": "passed", "source": "1234"}}})";
  const std::string damages[] = {
      "",
      good.substr(0, good.size() / 2),
      std::string("\0\xff\xfe\x01", 4) + good,
      "[1, 2, 3]",
      R"({"format": 2, "exercises": {}})",
      R"({"exercises": {}})",
      R"({"format": "1", "exercises": {}})",
      R"({"format": 1, "exercises": 7})",
      R"({"format": 1, "exercises": {"spring_energy": 3}})",
      R"({"format": 1, "exercises": {"spring_energy": {"verdict": 1, "source": "1234"}}})",
      R"({"format": 1, "exercises": {"spring_energy": {"verdict": "passed"}}})",
      R"({"format": 1, "exercises": {"spring_energy": {"hints": -3}}})",
      R"({"format": 1, "exercises": {"spring_energy": {"hints": "two"}}})",
      good + good,
      std::string(100000, '['),
  };
  const CourseCopy course;
  const fs::path file = course.root() / ".workbook/progress.json";
  course.solve("spring_energy");
  std::size_t set_aside = 0;
  for (const std::string& damage : damages) {
    CAPTURE(damage.substr(0, 80));
    write(file, damage);
    const Outcome outcome = course.run("check spring_energy");
    CHECK(outcome.status == 0);
    ++set_aside;
    const std::string aside = file.string() + ".damaged" + (set_aside > 1 ? "." + std::to_string(set_aside) : "");
    CHECK_MESSAGE(has(outcome.err, aside), outcome.err);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_MESSAGE((read(aside) == damage), aside);
    CHECK(course.run("list").err.empty());
  }
}

TEST_CASE("a folder in place of the progress file is set aside; one that cannot be written stops no check") {
  CourseCopy().check_story("no_progress");
}
