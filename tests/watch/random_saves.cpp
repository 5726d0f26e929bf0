// Saves at random moments, most of them while a check runs: none is lost.
#include "tests/watch/saving.hpp"
#include "tests/watch/terminal_session.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <map>
#include <random>

using namespace workbook::testing;
using std::chrono::milliseconds;

namespace {

/// The text of an exercise, right or wrong, with a number that its verdict shows.
std::string content(const CourseCopy& course, const std::string& name, bool right, int number) {
  if (right) return read(course.solution(name)) + fmt::format("// content {}\n", number);
  return fmt::format(
      "#include <rigid/springs.hpp>\n#include <stdexcept>\nnamespace rigid {{\n{} {}(double, const Vector3d&) {{\n"
      "  throw std::runtime_error(\"content {}.\");\n}}\n}}\n",
      name == "spring_energy" ? "double" : "Vector3d", name, number);
}

/// After every pause that is longer than a check takes, the verdict on the file that was saved last is to be seen, and
/// whatever other file was saved has its verdict, too.
void save_at_random(int saves, int saves_between_pauses, unsigned seed, TerminalOptions options) {
  const CourseCopy course;
  options.columns = 120;  // the number stands at the end of a long line
  TerminalSession watch(course, {}, options);
  REQUIRE(watch.shows({"Waiting"}));
  std::mt19937 random(seed);
  const auto below = [&](int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random); };
  int fresh = 100;
  std::map<std::string, std::string> verdicts;  // due for the exercises that were saved
  for (int i = 1; i <= saves; ++i) {
    const bool pauses = i % saves_between_pauses == 0 || i == saves;
    const std::string name = below(5) == 0 ? "spring_force" : "spring_energy";
    const bool right = below(2) == 0;
    // A few contents come again and again, so that most checks need no compiler and end at all sorts of moments.
    const int number = pauses || below(10) == 0 ? fresh++ : below(3);
    const Way& way = ways[static_cast<std::size_t>(below(5))];
    way.save(course.exercise(name), content(course, name, right, number), [&] { watch.wait(milliseconds(below(15))); });
    verdicts[name] = right ? "passed" : "uncaught_exception";
    if (!pauses) {
      watch.wait(milliseconds(below(80)));
      continue;
    }
    CAPTURE(i);
    CAPTURE(name);
    CAPTURE(std::string(way.name));
    for (const auto& due : verdicts) {
      const bool is_judged = due.first == name ? watch.judges(due.first, due.second)
                                               : watch.until([&] { return watch.has_verdict(due.first, due.second); });
      CHECK_MESSAGE(is_judged, watch.screen());
    }
    if (!right) CHECK_MESSAGE(watch.shows({fmt::format("content {}.", number)}), watch.screen());
    verdicts.clear();
  }
  watch.type("q");
  CHECK(watch.ends() == 0);
  CHECK(nothing_left_running());
}

}  // namespace

TEST_CASE("200 saves at random moments, and none is lost" * doctest::test_suite("thorough")) {
  save_at_random(200, 12, 1, {});
}

TEST_CASE("40 saves at random moments in a folder without events, and none is lost" * doctest::test_suite("thorough")) {
  save_at_random(40, 8, 2, {.environment = {"WORKBOOK_POLL=1"}});
}
