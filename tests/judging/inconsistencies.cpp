// What the checker tells the author of an exercise whose reference results contradict themselves.
#include "checker/judging/inconsistencies.hpp"
#include "tests/judging/made_up.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

namespace workbook::testing {
namespace {

struct Mistake {
  std::string about;
  std::function<void(ExerciseReference&)> make;
  std::vector<std::string> sentences;
};

const std::vector<Mistake> mistakes = {
    {"too few misconceptions",
     [](ExerciseReference& e) { e.misconceptions.pop_back(); },
     {"There are 2 misconceptions, fewer than 3."}},
    {"too few routes", [](ExerciseReference& e) { e.routes.pop_back(); }, {"There are 2 routes, fewer than 3."}},
    {"too few deciding cases",
     [](ExerciseReference& e) {
       for (std::size_t i = 0; i < 3; ++i) e.cases[i].deciding = false;
     },
     {"There are 5 deciding cases, fewer than 6."}},
    {"no worked case", [](ExerciseReference& e) { e.cases[0].group = Group::random; }, {"No case is a worked one."}},
    {"no sweep", [](ExerciseReference& e) { e.sweep = {}; }, {"There is no sweep to plot."}},
    {"a misconception that is right",
     [](ExerciseReference& e) { add_misconception(e, "right", "You are right, and yet.", right_momentum); },
     {"The misconception right is right at all deciding cases."}},
    {"two misconceptions that are one",
     [](ExerciseReference& e) { add_misconception(e, "again", "You add them once.", momentum_with(1, 1)); },
     {"The misconceptions no_two and again have different messages but cannot be told apart at the deciding cases."}},
    {"terms that do not add up",
     [](ExerciseReference& e) { e.terms[1].outputs[3].numbers[0] += 1e-3; },
     {"The terms do not add up to the expected value at the case “generic 3”."}},
    {"a wrong coefficient of a term that vanishes at the others",
     [](ExerciseReference& e) {
       add_term(e, "c", 5, [](const Inputs& inputs) {
         return inputs[0].numbers[0] == 2 && inputs[1].numbers[0] == 0 ? vector({1, 0, 0}) : vector({0, 0, 0});
       });
     },
     {"The terms do not add up to the expected value at the case “at rest”.",
      "The terms are not independent at the deciding cases."}},
    {"terms that depend on each other",
     [](ExerciseReference& e) { add_term(e, "m (u + v)", 0, momentum_with(1, 1)); },
     {"The terms are not independent at the deciding cases."}},
    {"a route that is wrong",
     [](ExerciseReference& e) { e.routes[1].outputs[2].numbers[0] += 1; },
     {"The route “with rounding errors” does not pass: The value is wrong at 1 of 9 cases, first at the case “generic "
      "2”."}},
    {"a property that right results lack",
     [](ExerciseReference& e) { add_property(e, PropertyKind::ascending, "The components ascend."); },
     {"The expected value of the case “the worked one” is not ascending: component 1 is 4, component 2 is 0."}},
};

}  // namespace

TEST_CASE("A sound exercise has nothing to complain of") { CHECK(inconsistencies(sound_momentum()).empty()); }

TEST_CASE("Each mistake of an author is told in a sentence of its own") {
  for (const Mistake& mistake : mistakes) {
    CAPTURE(mistake.about);
    ExerciseReference exercise = sound_momentum();
    mistake.make(exercise);
    const std::vector<std::string> found = inconsistencies(exercise);
    CAPTURE(joined(found));
    for (const std::string& sentence : mistake.sentences) CHECK(std::ranges::count(found, sentence) == 1);
    if (mistake.about != "a property that right results lack") CHECK(found.size() == mistake.sentences.size());
  }
}

TEST_CASE("A misconception that a student's judge would not name is told") {
  // Its agreement is read off at the deciding cases; one more message for the same numbers hides it, if not for all of
  // them.
  ExerciseReference exercise = sound_momentum();
  exercise.misconceptions[0].outputs[8] = vector({1, 1, 1});
  CHECK(inconsistencies(exercise).empty());
  exercise.misconceptions[0].outputs[0] = {2, 1, {1, 1}};  // of a wrong shape it cannot be recognised
  const auto found = inconsistencies(exercise);
  REQUIRE(found.size() == 1);
  CHECK(found[0] ==
        "The misconception no_two is not named when a student has it: The result has the shape 2×1 at the case “the "
        "worked one”, "
        "expected the shape 3×1.");
}

TEST_CASE("Expected values that do not pass their own comparison are told") {
  ExerciseReference exercise = given_results(Kind::matrix3, {three_rows({{1, 0, 0}, {0, 1, 0}, {0, 0, -1}})});
  exercise.arguments = {{"I", Kind::matrix3, units::moment_of_inertia}};
  exercise.cases[0].inputs = {three_rows({{1, 0, 0}, {0, 2, 0}, {0, 0, 3}})};
  exercise.comparison = Comparison::eigenvectors;
  const auto found = inconsistencies(exercise);
  CHECK(std::ranges::count(
            found,
            "The expected values do not pass: The value is wrong at 1 of 1 case, first at the case “number 0”.") == 1);
}

}  // namespace workbook::testing
