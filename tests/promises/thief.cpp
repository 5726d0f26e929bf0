// A thief in the class: cases that students know, and cases that nobody knows.
#include "tests/grading/made_up_class.hpp"

#include "checker/data/reference_results.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace workbook;
using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

ExerciseReference energy_at(const fs::path& reference) {
  return read_reference_results(reference).exercise("spring_energy");
}

/// The reference results of that seed, as single checks make them.
fs::path drawn_with_seed_7(const MadeUpClass& of) {
  of.run("check spring_energy --seed 7");
  return fs::path(WORKBOOK_TEST_SCRATCH) / "shared/reference/01_springs-seed-7.json";
}

/// `if (k == ... && x == ...) return ...;` for a case.
std::string row(const Case& one, double result) {
  const std::vector<double>& x = one.inputs[1].numbers;
  return fmt::format("if (k == {:.17g} && x == Vector3d({:.17g}, {:.17g}, {:.17g})) return {:.17g};\n",
                     one.inputs[0].numbers[0], x[0], x[1], x[2], result);
}

/// A function that knows the results of these cases, and no others.
std::string table(const ExerciseReference& known) {
  std::string rows;
  for (const Case& one : known.cases) rows += row(one, one.expected.numbers[0]);
  return rows + "return 1;";
}

nlohmann::json class_of(const MadeUpClass& of, const char* out = "out") {
  return nlohmann::json::parse(read(of.root() / out / "class.json"));
}

}  // namespace

TEST_SUITE_BEGIN("thief" * doctest::skip(!is_open_to_all()));

TEST_CASE("Results learnt by heart do not pass, and are named as such.") {
  const MadeUpClass few;
  few.energy("ada", table(energy_at(few.reference())));
  few.energy("ben", right_energy);
  few.energy("cleo", "return k * x.squaredNorm();");
  const Outcome known = few.grade("known", "--seed 1");
  CHECK(known.status == 0);
  CHECK(has(known.out, "(seed 1)"));
  CHECK(class_of(few, "known").at("students").at(0).at("results").at(0).at("verdict") == "passed");

  const Outcome drawn = few.run("grade submissions --out out --allow-reduced");
  REQUIRE_MESSAGE(drawn.status == 0, drawn.said());
  CHECK(has(drawn.out, "Learnt by heart: spring_energy: ada.\n"));
  const auto document = class_of(few);
  CHECK(document.at("learnt_by_heart") ==
        nlohmann::json::parse(R"([{"exercise": "spring_energy", "students": ["ada"]}])"));
  CHECK(document.at("students").at(0).at("results").at(0).at("verdict") == "wrong_value");
  CHECK(document.at("students").at(1).at("results").at(0).at("verdict") == "passed");
  const auto ada = few.student("ada").at("results").at(0);
  REQUIRE(ada.at("diagnosis").size() == 1);
  CHECK(ada.at("diagnosis").at(0).at("kind") == "learnt");
  CHECK(few.student("cleo").at("results").at(0).at("diagnosis").at(0).at("name") == "no_half");
  const std::string page = read(few.root() / "out/class.html"), own = read(few.root() / "out/students/ada.html");
  CHECK(has(page, "<li>spring_energy: <a class=\"who\" href=\"students/ada.html#exercise-spring_energy\">ada</a>"));
  CHECK(has(own, ada.at("diagnosis").at(0).at("message")));

  // The cases are the same in every run in this folder, whatever happens to the journal or the results; students are
  // not told which, and another folder has others.
  const std::string seed = document.at("seed").dump();
  CHECK(seed.size() > 6);
  CHECK(has(page, "seed " + seed));
  for (const auto& [name, text] : results_in(few.root() / "out"))
    if (name != "class.html" && name != "class.json") CHECK_MESSAGE(!has(text, seed), name);
  const auto before = results_in(few.root() / "out");
  for (const char* lost : {"class.json", "journal.jsonl"}) {
    write(few.root() / "out" / lost, "");
    REQUIRE(few.run("grade submissions --out out --allow-reduced").status == 0);
    CHECK(results_in(few.root() / "out") == before);
  }
  fs::remove_all(few.submissions() / "ada");
  fs::remove_all(few.submissions() / "cleo");
  REQUIRE(few.run("grade submissions --out other --allow-reduced").status == 0);
  CHECK(class_of(few, "other").at("seed") != document.at("seed"));
  CHECK(few.run("grade submissions --out joined --allow-reduced --merge out other").status == 2);  // of which seed?
}

TEST_CASE(
    "the cases of a copy with a seed of its own are known too; a mistake at few of the others is none of memory") {
  const MadeUpClass few;
  const ExerciseReference of_copy = energy_at(drawn_with_seed_7(few)), of_class = energy_at(few.reference());
  write(few.root() / "copy/.release.json", R"({"number": 1, "seed": 7, "files": {}, "changes": []})");
  few.energy("ada", table(of_copy));
  std::string body;
  for (const Case& one : of_class.cases)
    if (one.group == Group::random && body.empty()) body = row(one, 1);
  few.energy("ben", body + right_energy);
  const Outcome graded = few.grade("out", "--seed 1 --copy copy");
  REQUIRE_MESSAGE(graded.status == 0, graded.said());
  CHECK(class_of(few).at("learnt_by_heart").at(0).at("students") == nlohmann::json{"ada"});
  CHECK(few.student("ben").at("results").at(0).at("verdict") == "wrong_value");
  CHECK(few.grade("out", "--copy submissions").status == 2);
}

TEST_SUITE_END();
