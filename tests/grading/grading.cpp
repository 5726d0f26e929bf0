// A class graded by one command.
#include "tests/grading/made_up_class.hpp"

#include "checker/grading/grading.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <random>
#include <set>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

/// What autograders of four systems would have said of a student who passes the first exercise only.
void check_results_for_autograders(const fs::path& out, const std::string& slug) {
  const auto of = [&](const char* folder) { return nlohmann::json::parse(read(out / folder / (slug + ".json"))); };
  const nlohmann::json of_gradescope = of("gradescope"), of_prairielearn = of("prairielearn");
  // By their documents, these keys and no others mean something.
  const auto has_only = [](const nlohmann::json& object, const std::set<std::string>& known) {
    for (const auto& [key, unused] : object.items()) CHECK_MESSAGE(known.contains(key), key);
  };
  has_only(of_gradescope, {"score", "execution_time", "output", "output_format", "test_output_format", "visibility",
                           "stdout_visibility", "extra_data", "tests", "leaderboard"});
  has_only(of_prairielearn, {"gradable", "score", "message", "output", "images", "tests", "format_errors"});
  for (const auto& test : of_gradescope.at("tests"))
    has_only(test, {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags",
                    "visibility", "extra_data"});
  for (const auto& test : of_prairielearn.at("tests")) {
    has_only(test, {"name", "description", "points", "max_points", "message", "output", "images"});
    CHECK(test.at("points").get<double>() <= test.at("max_points").get<double>());
  }
  CHECK(of_gradescope.at("score") == 2);
  CHECK(of_gradescope.at("tests").at(1).at("status") == "failed");
  CHECK(has(of_gradescope.at("tests").at(1).at("output").get<std::string>(), "value is wrong"));
  // Autolab reads the last two lines.
  const auto lines = workbook::lines_of(read(out / "autolab" / (slug + ".txt")));
  REQUIRE(lines.size() == 2);
  CHECK(nlohmann::json::parse(lines[0]).at("Exercises").at("spring_force").at("passed") == false);
  CHECK(nlohmann::json::parse(lines[1]) ==
        nlohmann::json::parse(R"({"scores": {"spring_energy": 2.0, "spring_force": 0.0}})"));
  CHECK(of_prairielearn.at("score").get<double>() == doctest::Approx(2.0 / 3));
  const auto github = of("github_classroom");
  CHECK(github.at("status") == "fail");
  CHECK(github.at("max_score") == 3);
  CHECK(github.at("tests").at(0).at("status") == "pass");
  CHECK(github.at("tests").at(1).at("status") == "fail");
  CHECK(github.at("tests").at(1).at("score") == 0);
  const auto classroom50 = of("classroom50");
  CHECK(classroom50.at("schema") == "classroom50/result/v1");
  CHECK(classroom50.at("owner") == "hans");
  CHECK(classroom50.at("score") == 200);
  CHECK(classroom50.at("max-score") == 300);
  CHECK(classroom50.at("tests").at(0).at("passed") == true);
}

}  // namespace

TEST_SUITE_BEGIN("grading" * doctest::skip(!is_open_to_all()));

TEST_CASE("where a student's time for reasons is used up, verdicts are as ever" * doctest::test_suite("thorough")) {
  const MadeUpClass few;
  few.hand_in_few_files();
  few.check_story("no_time_for_reasons");
}

TEST_CASE("results may lie in a folder whose name is not UTF-8") {
  const MadeUpClass of;
  of.energy("ada", right_energy);
  const Outcome outcome = of.grade("out\xff");
  CHECK_MESSAGE(outcome.status == 0, outcome.said());
}

TEST_CASE("a wrong function is drawn on the reference on its student's page, and only once") {
  const MadeUpClass few;
  few.energy("ada", right_energy);
  few.energy("ben", "return k * x.squaredNorm();");
  const auto page = [&](const char* out, const char* id) {
    return read(few.root() / out / "students" / (std::string(id) + ".html"));
  };
  const std::string before = "<img src=\"data:image/svg+xml;base64,";
  REQUIRE(few.grade().status == 0);
  CHECK(!has(page("out", "ada"), before));
  const std::string drawn = page("out", "ben");
  REQUIRE(has(drawn, before));
  CHECK(has(drawn, "alt=\"Plot of spring_energy: "));
  const std::size_t begin = drawn.find(before) + before.size();
  const std::string picture = workbook::from_base64(drawn.substr(begin, drawn.find('"', begin) - begin));
  for (const char* part : {"<svg", ">yours<", ">reference<"}) CHECK_MESSAGE(has(picture, part), part);
  CHECK(picture.size() < 60'000);

  write(few.root() / "programs/gnuplot", "#!/bin/sh\nexit 1\n");
  fs::permissions(few.root() / "programs/gnuplot", fs::perms::owner_all | fs::perms::others_all);
  const std::string failing = fmt::format("PATH='{}':$PATH", (few.root() / "programs").string());
  const auto results = results_in(few.root() / "out");
  CHECK(has(few.grade("out", "", failing).out, "No mark has changed."));
  CHECK(results_in(few.root() / "out") == results);
  const Outcome bare = few.grade("bare", "", failing);
  REQUIRE_MESSAGE(bare.status == 0, bare.said());
  CHECK(!has(page("bare", "ben"), before));
  CHECK(read(few.root() / "bare/grades.csv") == read(few.root() / "out/grades.csv"));
  CHECK(!has(bare.out, "no plots"));
  CHECK(has(few.grade("bare", "", without_programs).out, "Pages get no plots: gnuplot is not installed"));
}

TEST_CASE("parts of a class, judged by themselves and joined, give the results of a single run" *
          doctest::test_suite("thorough")) {
  const MadeUpClass few;
  few.hand_in_few_files();
  few.energy("dora", right_energy);
  few.check_story("parts");
  CHECK(is_judged_once(few.root() / "joined/journal.jsonl"));
}

TEST_CASE("a damaged journal changes no result" * doctest::test_suite("thorough")) {
  const MadeUpClass few;
  few.energy("ada", right_energy);
  few.energy("ben", "return k * x.squaredNorm();");
  REQUIRE(few.grade().status == 0);
  const auto results = results_in(few.root() / "out");
  const std::string journal = read(few.root() / "out/journal.jsonl");
  std::mt19937 random(3);
  for (int damage = 0; damage < 3; ++damage) {
    std::string damaged = journal;
    if (damage == 0)
      damaged.resize(damaged.size() - 5);
    else
      for (int i = 0; i < 40; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    write(few.root() / "out/journal.jsonl", damaged);
    const Outcome graded = few.grade();
    CHECK_MESSAGE(graded.status == 0, graded.said());
    CHECK(results_in(few.root() / "out") == results);
  }
}

TEST_CASE("assignment and roster: points, lateness, ids of Moodle and Canvas") {
  MadeUpClass().check_story("assignment");
}

TEST_CASE("a roster is read as spreadsheets write it, or refused as a whole") { MadeUpClass().check_story("rosters"); }

TEST_CASE("hints cost points, and values that are right at some cases earn some, where the assignment says so") {
  MadeUpClass().check_story("partial_credit");
}

TEST_CASE(
    "what a wrong answer earns, by table: never more than three quarters, and by groups nothing without the ordinary") {
  const MadeUpClass few;
  const workbook::Course course(few.root() / "course.json");
  const auto rules = [&](const std::string& text) {
    return workbook::Assignment(course, write(few.root() / "assignment.json", text));
  };
  const workbook::Assignment none = rules("{}"), cases = rules(R"({"partial": true, "hint_cost": 0.25})"),
                             groups =
                                 rules(R"({"partial": "groups", "misconceptions": {"away": 0.5, "spring/no": 0.7}})");
  workbook::ExerciseReference reference;
  reference.name = "spring";
  using enum workbook::Group;
  for (const workbook::Group group : {worked, random, special, special, generated, generated})
    reference.cases.emplace_back().group = group;
  workbook::Judgement judged;
  judged.cases_total = reference.cases.size();
  for (unsigned failing = 1; failing < 64; ++failing) {
    CAPTURE(failing);
    judged.verdict = workbook::Verdict::wrong_value;
    judged.failing.clear();
    for (std::size_t k = 0; k < 6; ++k)
      if ((failing >> k) % 2 == 1) judged.failing.push_back(k);
    CHECK(none.share(judged, reference, {"away"}, 0) == 0);
    const double right = 1 - static_cast<double>(judged.failing.size()) / 6;
    CHECK(cases.share(judged, reference, {}, 1) == doctest::Approx(0.75 * std::min(0.75, right)));
    const bool is_ordinary = failing % 4 == 0, is_special = failing / 4 % 4 == 0, is_generated = failing / 16 == 0;
    const double by_groups = is_ordinary ? (is_special || is_generated ? 2.0 / 3 : 1.0 / 3) : 0.0;
    CHECK(groups.share(judged, reference, {"other"}, 0) == doctest::Approx(by_groups));
    CHECK(groups.share(judged, reference, {"away", "other"}, 0) == doctest::Approx(std::max(0.5, by_groups)));
    CHECK(groups.share(judged, reference, {"away", "no"}, 0) == doctest::Approx(0.7));
  }
  judged.failing = {5};
  for (int number = 0; number <= static_cast<int>(workbook::Verdict::checker_error); ++number) {
    judged.verdict = static_cast<workbook::Verdict>(number);
    CAPTURE(workbook::to_string(judged.verdict));
    const bool has_values =
        judged.verdict == workbook::Verdict::wrong_value || judged.verdict == workbook::Verdict::non_finite_value;
    CHECK(cases.share(judged, reference, {}, 5) == 0);  // no hint costs more than all
    CHECK(cases.share(judged, reference, {"away"}, 0) == (judged.passed() ? 1 : has_values ? 0.75 : 0));
    CHECK(groups.share(judged, reference, {"no"}, 0) == doctest::Approx(judged.passed() ? 1 : has_values ? 0.7 : 0));
  }
  // A group that an exercise does not have earns nothing.
  reference.cases.resize(4);
  judged.verdict = workbook::Verdict::wrong_value;
  judged.failing = {2};
  judged.cases_total = 4;
  CHECK(groups.share(judged, reference, {}, 0) == 0.5);
  for (auto& each : reference.cases) each.group = special;
  CHECK(groups.share(judged, reference, {}, 0) == 0);
}

TEST_CASE("points, excuses, due dates and comments by hand count, are kept, and are shown wherever marks are") {
  const MadeUpClass few;
  few.hand_in_few_files();  // ada has both right, ben one half, cleo none
  few.check_story("by_hand");
}

TEST_CASE("of several attempts the last or the best one counts" * doctest::test_suite("thorough")) {
  MadeUpClass().check_story("attempts");
}

TEST_CASE("one group of results is judged again, and given reference results take the place of a seed" *
          doctest::test_suite("thorough")) {
  const MadeUpClass few;
  few.hand_in_few_files();
  few.check_story("judging_again");
}

TEST_CASE("results are written as other systems read them") {
  const MadeUpClass few;
  few.energy("hans", right_energy);
  few.force("hans", "return k * x;");
  REQUIRE(few.grade().status == 0);
  CHECK(!fs::exists(few.root() / "out/classroom50"));  // it makes sense in the runner of that system only
  const char* runner =
      "CLASSROOM=physics ASSIGNMENT=springs ASSIGNMENT_TYPE=individual OWNER=hans SUBMISSION_TAG=submit/1 "
      "COMMIT_URL=https://example.org/c RELEASE_URL=https://example.org/r REVIEW_URL=https://example.org/v";
  const Outcome graded = few.run("grade submissions --out out --allow-reduced --seed 1", runner);
  REQUIRE_MESSAGE(graded.status == 0, graded.said());
  check_results_for_autograders(few.root() / "out", "hans");
}

TEST_CASE("nothing is graded in a weaker sandbox than was agreed to, nor into somebody's folder") {
  MadeUpClass().check_story("not_graded");
}

TEST_CASE("whose mark has changed, and why") {
  const auto document = [](int seed, const std::string& made_from, const std::string& verdict, double points,
                           int students) {
    nlohmann::ordered_json all = {{"seed", seed}, {"students", nlohmann::ordered_json::array()}};
    for (int k = 0; k < students; ++k) {
      const double score = verdict == "passed" ? points : 0.0;
      all["students"].push_back({{"id", "s" + std::to_string(k)},
                                 {"score", score},
                                 {"possible", verdict == "checker_error" ? 0.0 : points},
                                 {"late_factor", 1.0},
                                 {"results",
                                  {{{"exercise", "e"},
                                    {"verdict", verdict},
                                    {"score", score},
                                    {"points", points},
                                    {"made_from", made_from}}}}});
    }
    return all;
  };
  const auto before = document(1, "a", "wrong_value", 1, 1);
  const auto line = [&](const nlohmann::ordered_json& old, nlohmann::ordered_json now) {
    return workbook::compare_with(old, now).at(0);
  };
  CHECK(line(before, document(1, "b", "passed", 1, 1)) ==
        "s0: 1 of 1 points, before 0 of 1: e was wrong value and is passed, with another file.");
  CHECK(line(before, document(2, "a", "passed", 1, 1)) ==
        "s0: 1 of 1 points, before 0 of 1: e was wrong value and is passed, with other cases.");
  CHECK(line(before, document(1, "a", "passed", 1, 1)) ==
        "s0: 1 of 1 points, before 0 of 1: e was wrong value and is passed, by another checker.");
  // What could not be judged before, on a full disk for example, has no other reason.
  CHECK(line(document(1, "a", "checker_error", 1, 1), before) ==
        "s0: 0 of 1 points, before 0 of 0: e was not judged and is wrong value.");
  // Who is excused from the whole has other points for everything.
  auto excused = document(1, "a", "passed", 0, 1);
  excused["students"][0]["by_hand"] = "excused: Ill";
  CHECK(line(document(1, "a", "passed", 1, 1), excused) == "s0: 0 of 0 points, before 1 of 1: by hand: excused: Ill.");
  // One reason for many is one line.
  auto more = document(1, "a", "passed", 2, 60);
  const auto many = workbook::compare_with(document(1, "a", "passed", 1, 60), more);
  CHECK(many ==
        std::vector<std::string>{"60 students: e has other points. The first: s0: 2 of 2 points, before 1 of 1."});
}

TEST_CASE("tables are read as they are written") {
  const workbook::Table table = {{"a", "b\"c", "d,e"}, {"", "f\ng", "ü"}};
  CHECK(workbook::read_csv(workbook::write_csv(table)) == table);
  CHECK(workbook::write_csv({{"=1+1", "-1", "@x", "a=b"}}) == "'=1+1,'-1,'@x,a=b\r\n");
  // Whoever takes semicolons for the ends of cells, and wide letters for plain ones.
  CHECK(workbook::write_csv({{"x;=1+1"}, {"x; \"+1"}, {"x,@y"}, {"x\n-1"}}) ==
        "\"x;'=1+1\"\r\n\"x; \"\"'+1\"\r\n\"x,'@y\"\r\n\"x\n'-1\"\r\n");
  for (const char* wide : {"\uff1d", "\uff0b", "\uff0d", "\uff20"})
    CHECK(workbook::write_csv({{std::string(wide) + "1"}}) == "'" + std::string(wide) + "1\r\n");
}

TEST_SUITE_END();
