// Cards and reference results that are damaged: one clear sentence with file and place, exit status 3, no grade.
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

using namespace workbook::testing;
namespace fs = std::filesystem;

namespace {

void require_checker_error(const CourseCopy& course, const std::string& sentence) {
  for (const char* command : {"check spring_energy", "check spring_energy --json"}) {
    const Outcome outcome = course.run(command);
    CHECK(outcome.status == 3);
    CHECK(outcome.out.empty());
    CHECK_MESSAGE(has(outcome.err, sentence), outcome.err);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

struct Damage {
  const char* from;
  const char* to;
  const char* sentence;
};

}  // namespace

TEST_CASE("a damaged card is named with the place of the damage") {
  const Damage damages[] = {
      {"\"title\": \"Springs\",", "", "card.json: title is missing."},
      {"\"title\": \"Springs\"", "\"title\": 7", "card.json: title has the wrong type."},
      {"\"points\": 2", "\"points\": \"two\"", "card.json: exercises[0].points has the wrong type."},
      {"\"points\": 2", "\"points\": 0", "card.json: exercises[0].points should be a positive number."},
      {"\"points\": 2", "\"points\": 2, \"points\": 3", "card.json: exercises[0]: the key “points” stands here twice."},
      {"\"title\"", "\"exercises\": [], \"title\"", "card.json: top level: the key “exercises” stands here twice."},
      {"spring_force", "spring_energy", "'spring_energy' stands on the card twice"},
      {"\"exercises\": [", "\"exercises\": [[], ", "card.json: exercises[0] should be an object"},
      {"\"builds_on\"", "\"built_on\"", "card.json: builds_on is missing."},
      {"}", "", "card.json: not valid JSON"},
      {"\"summary\"", "\"sumary\"", "card.json: summary is missing."},
      {"\"spring_energy\"", "null", "card.json: exercises[0].name has the wrong type."},
  };
  for (const Damage& damage : damages) {
    CAPTURE(damage.sentence);
    const CourseCopy course;
    replace_in(course.card(), damage.from, damage.to);
    require_checker_error(course, damage.sentence);
  }
  const CourseCopy course;
  fs::remove(course.card());
  require_checker_error(course, "the card of the lecture is missing");
}

TEST_CASE("an exercise on the card that the reference results do not have is a checker error") {
  const CourseCopy course;
  replace_in(course.card(), "\"spring_energy\"", "\"spring_entropy\"");
  const Outcome outcome = course.run("check spring_entropy");
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "01_springs.json: exercises: 'spring_entropy' is missing"));
}

TEST_CASE("damaged reference results are named with the place of the damage") {
  const auto change = [](const std::function<void(nlohmann::json&)>& damage) {
    return [damage](const fs::path& file) {
      auto document = nlohmann::json::parse(read(file));
      damage(document);
      write(file, document.dump());
    };
  };
  using nlohmann::json;
  struct Case {
    std::function<void(const fs::path&)> damage;
    const char* sentence;
  };
  const Case cases[] = {
      {[](const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); }, "01_springs.json"},
      {[](const fs::path& file) { write(file, ""); }, "01_springs.json"},
      {[](const fs::path& file) { fs::remove(file); }, "01_springs.json"},
      {change([](json& d) { d["format"] = 2; }), "format"},
      {change([](json& d) { d["exercises"][0]["cases"][0]["expected"] = nullptr; }), "exercises[0].cases[0].expected"},
      {change([](json& d) { d["exercises"][0]["cases"][0]["expected"] = "nine"; }), "exercises[0].cases[0].expected"},
      {change([](json& d) { d["exercises"][0]["cases"][0]["inputs"] = json::array(); }),
       "exercises[0].cases[0].inputs"},
      {change([](json& d) { d["exercises"][0]["cases"][0].erase("tolerance"); }), "exercises[0].cases[0]"},
      {change([](json& d) { d["exercises"] = 3; }), "exercises"},
      {change([](json& d) { d.erase("seed"); }), "seed"},
      {change([](json& d) { d["exercises"][0]["cases"][0]["tolerance"] = -1; }), "exercises[0].cases[0].tolerance"},
      {[](const fs::path& file) { write(file, std::string("\xff\xfe\0\0", 4)); }, "01_springs.json"},
  };
  for (const Case& each : cases) {
    CAPTURE(each.sentence);
    const CourseCopy course;
    each.damage(course.reference());
    const Outcome outcome = course.run("check spring_energy --json");
    CHECK(outcome.status == 3);
    CHECK(outcome.out.empty());
    CHECK_MESSAGE(has(outcome.err, each.sentence), outcome.err);
  }
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
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  std::size_t set_aside = 0;
  for (const std::string& damage : damages) {
    CAPTURE(damage.substr(0, 80));
    write(file, damage);
    const Outcome outcome = course.run("check spring_energy");
    CHECK(outcome.status == 0);
    CHECK(has(outcome.out, "✓ spring_energy"));
    ++set_aside;
    const std::string aside = file.string() + ".damaged" + (set_aside > 1 ? "." + std::to_string(set_aside) : "");
    CHECK_MESSAGE(has(outcome.err, "it is set aside as " + aside + " and counting starts afresh."), outcome.err);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_MESSAGE((read(aside) == damage), aside);
    CHECK(course.run("list").err.empty());
    CHECK(has(course.run("list").out, "✓ spring_energy"));
  }
}

TEST_CASE("a folder or a link to nowhere in place of the progress file is set aside too") {
  const CourseCopy course;
  const fs::path file = course.root() / ".workbook/progress.json";
  fs::create_directories(file / "within");
  CHECK(has(course.run("list").err, "it is set aside as " + file.string() + ".damaged"));
  CHECK(fs::is_directory(file.string() + ".damaged/within"));
  CHECK(course.run("hint spring_energy").status == 0);
  CHECK(has(course.run("hint spring_energy").out, "Hint 2 of 3"));
}

TEST_CASE("a course that is not there is a checker error") {
  const CourseCopy course;
  write(course.root() / "course.json", "{");
  CHECK(course.run("list").status == 3);
  CHECK(has(course.run("list").err, "build the workbook again"));
  fs::remove(course.root() / "course.json");
  CHECK(has(course.run("list").err, "the course's file is missing"));
}

TEST_CASE("trouble of our own is no zero") {
  const CourseCopy course;
  fs::copy_file(course.solution("spring_energy"), course.exercise("spring_energy"),
                fs::copy_options::overwrite_existing);
  // A toolchain whose compiler is gone.
  auto toolchain = nlohmann::json::parse(read(WORKBOOK_TEST_TOOLCHAIN));
  toolchain["compiler"] = "/nowhere/g++";
  write(course.root() / "toolchain.json", toolchain.dump());
  auto description = nlohmann::json::parse(read(course.root() / "course.json"));
  description["toolchain"] = (course.root() / "toolchain.json").string();
  description["scratch"] = (course.root() / "scratch").string();
  write(course.root() / "course.json", description.dump());

  const Outcome outcome = course.run("check spring_energy --json");
  CHECK(outcome.status == 3);
  const auto result = outcome.json().at("results").at(0);
  CHECK(result.at("verdict") == "checker_error");
  CHECK(result.at("score").is_null());
  CHECK(course.run("doctor").status == 3);
}

TEST_CASE("seeds need the solutions, and the checker says so where there are none") {
  const CourseCopy course;
  fs::remove(course.root() / "reference/reference_01_springs");
  const Outcome outcome = course.run("check spring_energy --seed 7");
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "has reference results for seed 1 only"));
}
