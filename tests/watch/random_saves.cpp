// Saves at random moments, most of them while a check runs: none is lost.
#include "checker/course/progress.hpp"
#include "tests/watch/saving.hpp"
#include "tests/watch/watched.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <random>
#include <set>
#include <string>

using namespace workbook::testing;
using std::chrono::milliseconds;

namespace {

/// The text of an exercise, right or wrong, with a number that its verdict shows.
std::string content(const CourseCopy& course, const std::string& name, bool right, int number) {
  if (right) return read(course.solution(name)) + fmt::format("// content {}\n", number);
  const bool energy = name == "spring_energy";
  return fmt::format(
      "#include <rigid/springs.hpp>\n#include <stdexcept>\nnamespace rigid {{\n{} {}(double, const Vector3d&) {{\n"
      "  throw std::runtime_error(\"content {}.\");\n}}\n}}\n",
      energy ? "double" : "Vector3d", name, number);
}

/// The verdict on the file as it is now has been given.
bool is_judged(const CourseCopy& course, const std::string& name) {
  const std::string text = read(course.root() / ".workbook/progress.json");
  if (text.empty()) return false;
  const auto exercises = nlohmann::json::parse(text).at("exercises");
  return exercises.contains(name) &&
         exercises.at(name).value("source", "") == workbook::fingerprint(course.exercise(name));
}

/// After every pause that is longer than a check takes, the verdict on the file that was saved last is to be seen, and
/// whatever other file was saved has its verdict, too.
void save_at_random(int saves, int saves_between_pauses, unsigned seed, TerminalOptions options) {
  const CourseCopy course;
  options.columns = 120;  // the number stands at the end of a long line
  WatchedTerminal watch(course, {}, options);
  REQUIRE(watch.shows({"Waiting"}));
  std::mt19937 random(seed);
  const auto below = [&](int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random); };
  int fresh = 100;
  std::set<std::string> touched;
  for (int i = 1; i <= saves; ++i) {
    const bool pauses = i % saves_between_pauses == 0 || i == saves;
    const std::string name = below(5) == 0 ? "spring_force" : "spring_energy";
    const bool right = below(2) == 0;
    // A few contents come again and again, so that most checks need no compiler and end at all sorts of moments.
    const int number = pauses || below(10) == 0 ? fresh++ : below(3);
    const Way way = all_ways[below(5)];
    save(course.exercise(name), content(course, name, right, number), way,
         [&] { watch.wait(milliseconds(below(15))); });
    touched.insert(name);
    if (!pauses) {
      watch.wait(milliseconds(below(80)));
      continue;
    }
    CAPTURE(i);
    CAPTURE(name);
    CAPTURE(number);
    CAPTURE(std::string(to_string(way)));
    for (const std::string& each : touched) CHECK(watch.until([&] { return is_judged(course, each); }));
    const bool shown = right ? watch.shows({"✓ " + name + "  passed"})
                             : watch.shows({"✗ " + name + "  uncaught exception", fmt::format("content {}.", number)});
    CHECK_MESSAGE(shown, watch.screen());
  }
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(nothing_left_running());
}

}  // namespace

TEST_CASE("200 saves at random moments, and none is lost") { save_at_random(200, 12, 1, {}); }

TEST_CASE("saves at random moments in a folder without events, and none is lost") {
  TerminalOptions options;
  options.environment = {"WORKBOOK_POLL=1"};
  save_at_random(40, 8, 2, options);
}
