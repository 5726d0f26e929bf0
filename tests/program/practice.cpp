// Predictions before a function is written, reviews of one that was, and a change that changed no value.
#include "checker/base/formulas.hpp"
#include "tests/program/program.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <regex>

using namespace workbook::testing;

namespace {

/// The cases that `predict` offers, by number, with the right result for each.
std::string offered(const CourseCopy& course, const std::string& exercise) {
  return course.run("predict " + exercise).out;
}

}  // namespace

TEST_CASE("predictions are judged, and the wrong functions that would agree are told") {
  const CourseCopy course;
  CHECK(has(offered(course, "spring_energy"), "1 k = 1, x = (0, 1, 0)"));
  const Outcome right = course.run("predict spring_energy 1=0.5");
  CHECK(has(right.out, "case 1: right"));
  CHECK(has(right.out, " would return the same."));
  CHECK(has(right.out, " from the right one: k = "));
  CHECK(right.status == 1);
  const Outcome wrong = course.run("predict spring_energy 1=1");
  CHECK(has(wrong.out, "case 1: not what comes out"));
  CHECK(wrong.status == 1);
  CHECK(has(wrong.out, "A function with this mistake returns it: The factor ½ is missing."));
  // With three digits, in any notation.
  CHECK(has(course.run("predict spring_force '1=(0; -1.001, 0)'").out, "case 1: right"));
}

TEST_CASE("of a problem a prediction tells no mistake by name before the third try") {
  const CourseCopy course;
  replace_in(course.card(), "\"points\": 2,", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 10,");
  CHECK_FALSE(has(course.run("predict spring_energy 1=1").out, "½"));
  course.run("hint spring_energy");
  CHECK(has(course.run("predict spring_energy 1=1").out, "½"));
}

TEST_CASE("a hint without a name is that of the exercise that was checked last") {
  const CourseCopy course;
  write(course.exercise("spring_force"), "namespace rigid { int nothing; }\n");
  course.run("check spring_force");
  CHECK(has(course.run("hint").out, "Hint 1 of 3 for spring_force"));
  course.solve("spring_force");
  course.run("check spring_force");
  CHECK(has(course.run("hint").out, "for spring_energy"));
}

TEST_CASE("a solution shows its derivation in words and signs, and no TeX is left in any of the course") {
  const CourseCopy course;
  write(course.root() / "solutions/01_springs/derivations/spring_energy.md",
        "# By work\n\nThe work is\n\\f[ E = \\int F\\,\\dd x = \\tfrac12 k x^2 . \\f]\n");
  const Outcome shown = course.run("solution spring_energy --now", "COLUMNS=80");
  CHECK_MESSAGE(has(shown.out, "By work\n\nThe work is\n\n    E = ∫ F d x = (1/2) k x².\n"), shown.out);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(fmt::format("{}/solutions", WORKBOOK_ROOT)))
    if (entry.path().parent_path().filename() == "derivations")
      CHECK_MESSAGE(!has(workbook::with_readable_formulas(read(entry.path())), "\\"), entry.path().string());
}

TEST_CASE("limits are asked first, and a right prediction is told the reason") {
  const CourseCopy course;
  const std::string asked = offered(course, "spring_force");
  CHECK(has(asked, "in these limits?"));
  const auto place = [&](const char* part) { return asked.find(part); };
  CHECK(place("at rest: k = 2, x = (0, 0, 0)") < place("a very soft spring: k = 1e-09"));
  CHECK(place("a very soft spring: k = 1e-09") < place("And here?"));
  const std::string number = std::to_string(std::stoi(asked.substr(asked.rfind('\n', place("at rest")))));
  CHECK(has(course.run("predict spring_force '" + number + "=(0, 0, 0)'").out, "Nothing is stretched."));
  CHECK_FALSE(has(course.run("predict spring_force '" + number + "=(0, 1, 0)'").out, "Nothing is stretched."));
  CHECK_FALSE(has(offered(course, "spring_energy"), "limits"));
}

TEST_CASE("a problem tells where it fails, then a region, then the mistake by name; or all after a hint") {
  const CourseCopy course;
  replace_in(course.card(), "\"points\": 2,", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 10,");
  const auto told = [&](const std::string& arguments = "") {
    const auto result = nlohmann::json::parse(course.run("check spring_energy --json" + arguments).out)["results"][0];
    std::string names = fmt::format("{}:", result["stage"].get<int>());
    for (const auto& diagnosis : result["diagnosis"]) names += " " + diagnosis["name"].get<std::string>();
    return names;
  };
  course.answer_energy("return k * x.squaredNorm();");
  const std::string first = told();
  CHECK(first == "1: where");
  CHECK(told() == first);  // the same text is no further try
  CHECK_FALSE(has(course.run("check spring_energy --full").out, "half"));
  CHECK(told(" --file lectures/01_springs/exercises/spring_force.cpp").starts_with("3:"));
  course.answer_energy("return x.squaredNorm() * k;");
  CHECK(told().starts_with("2:"));
  course.answer_energy("return x.dot(x) * k;");
  const std::string third = told();
  CHECK(third.starts_with("3:"));
  CHECK(third != "3:");
  CHECK(third.find("where") == std::string::npos);

  // Of a mistake in the code everything is told at once, and of all after a hint.
  const CourseCopy other;
  replace_in(other.card(), "\"points\": 2,", "\"points\": 2, \"problem\": true, \"difficulty\": 1, \"minutes\": 10,");
  other.answer_energy("return 1/2 * k * x.squaredNorm();");
  CHECK(has(other.run("check spring_energy").out, "divides whole numbers"));
  other.answer_energy("return k * x.squaredNorm();");
  other.run("hint spring_energy");
  CHECK(has(other.run("check spring_energy --json").out, "\"stage\": 3"));
}

TEST_CASE("an editor finds each reason at its line and column") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm() / y;");
  const auto tasks = nlohmann::json::parse(read(std::filesystem::path(WORKBOOK_ROOT) / ".vscode/tasks.json"));
  const nlohmann::json& pattern = tasks["tasks"][0]["problemMatcher"]["pattern"];
  const std::string screen = course.run("check spring_energy", "COLUMNS=1000").out;
  std::smatch found;
  REQUIRE(std::regex_search(screen, found, std::regex(pattern["regexp"].get<std::string>(), std::regex::multiline)));
  CHECK(found[pattern["file"].get<std::size_t>()] == "spring_energy.cpp");
  CHECK(found[pattern["line"].get<std::size_t>()] == "4");
  CHECK(found[pattern["column"].get<std::size_t>()] == "30");
  CHECK(has(found[pattern["message"].get<std::size_t>()].str(), "`y`"));
  // The same mistake in two lines stands at the first one.
  const std::string twice = "  Why    spring_energy.cpp:4:9, 5:9: A double";
  REQUIRE(std::regex_search(twice, found, std::regex(pattern["regexp"].get<std::string>(), std::regex::multiline)));
  CHECK(found[pattern["column"].get<std::size_t>()] == "9");
  CHECK(found[pattern["message"].get<std::size_t>()] == "A double");
}

TEST_CASE("after a pass a function is shown on real data, with errors where they are known") {
  const CourseCopy course;
  const auto body = [&](const char* text) { course.answer_energy(text); };
  body("return 0.5 * k * x.squaredNorm();");
  CHECK(has(course.run("check spring_energy").out,
            "Your function on a luggage scale, read to 0.02 J: E = 2.453 ± 0.020 J."));
  const nlohmann::json result = nlohmann::json::parse(course.run("check spring_energy --json").out)["results"][0];
  const nlohmann::json& real = result["measured"][0];
  CHECK(real["name"] == "a luggage scale, read to 0.02 J");
  CHECK(real["result"].get<double>() == doctest::Approx(2.4525));
  CHECK(real["errors"] == std::vector<double>{0.02});
  body("return k * x.squaredNorm();");
  CHECK_FALSE(has(course.run("check spring_energy").out, "luggage scale"));
  CHECK_FALSE(has(course.run("check spring_energy --json").out, "luggage scale"));
  // What it does there decides nothing.
  body("if (k == 1962) throw 3; return 0.5 * k * x.squaredNorm();");
  const Outcome thrown = course.run("check spring_energy");
  CHECK(thrown.status == 0);
  CHECK(has(thrown.out, "Your function on a luggage scale, read to 0.02 J: no result."));
}

TEST_CASE("a prediction that cannot be read is refused with an example") {
  const CourseCopy course;
  for (const char* odd : {"1", "1=", "1='0 0'", "99999=1", "=1"}) {
    const Outcome refused = course.run(fmt::format("predict spring_force {}", odd));
    CHECK_MESSAGE(refused.status == 2, odd);
  }
}

TEST_CASE("an exercise of an earlier lecture comes back when it is due, and its first verdict is kept") {
  const CourseCopy course;
  const auto on = [&](const char* day, const std::string& command) {
    return course.run(command, fmt::format("WORKBOOK_TODAY={}", day));
  };
  CHECK(has(on("2026-03-01", "review").out, "Nothing to review yet"));
  course.solve("spring_energy");
  on("2026-03-01", "check spring_energy");
  // There is one lecture only; the one after it is begun.
  replace_in(course.root() / ".workbook/progress.json", "\"exercises\": {",
             "\"exercises\": {\n\"pendulum_period\": {\"verdict\": \"wrong_value\", \"source\": \"\"},");
  std::filesystem::create_directories(course.root() / "lectures/02_pendulums");
  write(course.root() / "lectures/02_pendulums/card.json",
        R"({"title": "Pendulums", "summary": "", "slides": [], "builds_on": [], "contract": "springs", "facts": [1],
            "exercises": [{"name": "pendulum_period", "points": 1, "notes": "n", "task": "The period."}]})");
  CHECK(has(on("2026-03-01", "review").out, "Nothing is due today"));
  CHECK(has(on("2026-03-02", "list").out, "review        10 min  spring_energy"));
  CHECK_FALSE(has(on("2026-03-01", "list").out, "review  "));
  const Outcome due = on("2026-03-02", "review");
  CHECK_MESSAGE(has(due.out, ".workbook/review/spring_energy.cpp"), due.said());
  const auto file = course.root() / ".workbook/review/spring_energy.cpp";
  CHECK(has(read(file), "TODO"));
  CHECK(on("2026-03-02", "review").status == 1);  // not started
  replace_in(file, "throw NotStarted{};", "return k * x.squaredNorm();");
  const Outcome first = on("2026-03-02", "review"), again = on("2026-03-02", "review");
  CHECK(has(first.out, "wrong value"));
  CHECK(first.out == again.out);  // at the same cases
  replace_in(file, "return k", "return 0.5 * k");
  const Outcome passed = on("2026-03-03", "review");
  CHECK(passed.status == 0);
  CHECK_MESSAGE(has(passed.out, "Reviews so far:\n  2026-03-03  wrong value at the first try\n"), passed.out);
  CHECK(!has(passed.out, "passed at the first try"));
  CHECK(!std::filesystem::exists(file));
  // The exercise's own verdict is as it was, and the next time comes after a day again.
  CHECK(has(course.run("list").out, "passed"));
  CHECK(has(on("2026-03-03", "review").out, "Nothing is due today"));
  CHECK(has(on("2026-03-04", "review").out, "Write it again"));
}

TEST_CASE("after a pass comes a question with one right answer, and the first answer is kept") {
  const CourseCopy course;
  CHECK(course.run("question spring_force").status == 1);  // it does not pass yet
  course.solve("spring_force");
  CHECK(has(course.run("check spring_force").out, "question spring_force"));
  CHECK(has(course.run("question spring_force").out, "Right is"));
  CHECK(course.run("question spring_force d").status == 2);
  std::string right;
  std::vector<std::string> wrong;
  for (const char* answer : {"a", "b", "c"}) {
    const CourseCopy other;
    other.solve("spring_force");
    other.run("check spring_force");
    const bool is_right = other.run(fmt::format("question spring_force {}", answer)).status == 0;
    CHECK(has(read(other.root() / ".workbook/progress.json"), fmt::format("\"answered_right\": {}", is_right)));
    is_right ? right = answer : wrong.emplace_back(answer);
  }
  CHECK((!right.empty() && wrong.size() == 2));
  const Outcome first = course.run("question spring_force " + wrong.at(0));
  CHECK(has(first.out, "it would have returned"));
  CHECK(course.run("question spring_force " + right).status == 0);
  CHECK(has(read(course.root() / ".workbook/progress.json"), "\"answered_right\": false"));
  CHECK_FALSE(has(course.run("check spring_force").out, "question spring_force"));
  course.run("report --html page.html");
  CHECK(has(read(course.root() / "page.html"), "answered wrong at first"));
}

TEST_CASE("a change that changes no value is told, and the next hint is offered") {
  const CourseCopy course;
  course.answer_energy("return k * x.squaredNorm();");
  CHECK(!has(course.run("check spring_energy").out, "has changed no value"));
  CHECK(!has(course.run("check spring_energy").out, "has changed no value"));  // the same file
  course.answer_energy("return x.squaredNorm() * k;");
  CHECK(has(course.run("check spring_energy").out, "has changed no value"));
  course.answer_energy("return 2 * k * x.squaredNorm();");
  CHECK(!has(course.run("check spring_energy").out, "has changed no value"));
}
