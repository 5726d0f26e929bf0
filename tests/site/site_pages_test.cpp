// The pages that are made from the cards, and what stops the notes before Doxygen sees them.
#include "lectures/site/notes_check.hpp"
#include "lectures/site/pages.hpp"
#include "lectures/site/text_file.hpp"

#include <doctest/doctest.h>

#include <fmt/ranges.h>

#include <filesystem>
#include <fstream>

using namespace workbook;
using namespace workbook::site;

namespace {

const std::vector<Card> course{
    {.lecture = "01_springs",
     .title = "Springs",
     .summary = "Pull and let go.",
     .slides = {"S0 s1", "S1 s2"},
     .builds_on = {},
     .contract = "springs",
     .facts = {},
     .exercises = {{"spring_force", 1, "springs_force", ""}, {"spring_energy", 2.5, "springs_energy", ""}}},
    {.lecture = "02_waves",
     .title = "Waves \"on\" springs",
     .summary = "Many springs.",
     .slides = {"S2 s3"},
     .builds_on = {"01_springs", "09_nowhere"},
     .contract = "waves",
     .facts = {},
     .exercises = {{"wave", 1, "waves_wave", ""}}}};

const std::string springs = R"(/// @file
/// Springs.
#pragma once

namespace rigid {

/// Force of a spring, which
/// pulls back. It is linear.
///
/// See spring_energy().
///
/// @return force, N
double spring_force(double k,
                    double x);

/// Energy of a spring
double spring_energy(double k, double x);

double bare(double x);

}  // namespace rigid
)";

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Faults of the notes of a lecture 01_springs, all of whose figures lie in a folder with the one figure cube.svg.
std::vector<std::string> faults(const std::string& body) {
  const std::filesystem::path figures = std::filesystem::temp_directory_path() / "workbook-figures-of-a-test";
  std::filesystem::create_directories(figures / "01_springs");
  std::ofstream(figures / "01_springs" / "cube.svg") << "<svg/>";
  const std::string sound = "\\lecture_card{01_springs}\n\\exercises{01_springs}\n\\lecture_links{01_springs}\n";
  auto found = faults_of_notes("01_springs", sound + body, figures);
  std::filesystem::remove_all(figures);
  return found;
}

void check_same(const std::vector<std::string>& found, const std::vector<std::string>& expected) {
  CHECK_MESSAGE(found == expected, fmt::format("found:\n{}", fmt::join(found, "\n")));
}

}  // namespace

TEST_CASE("The declaration of a function is read from its contract, over all its lines") {
  CHECK(declaration(course[0], "spring_force", springs) ==
        "double spring_force(double k,\n                    double x);");
  CHECK(declaration(course[0], "spring_energy", springs) == "double spring_energy(double k, double x);");
  CHECK_THROWS_WITH(declaration(course[0], "force", springs),
                    "include/rigid/springs.hpp does not declare force, though the card of 01_springs lists it.");
}

TEST_CASE("The first sentence of a function's comment ends at its full stop or with its paragraph") {
  CHECK(first_sentence(course[0], "spring_force", springs) == "Force of a spring, which pulls back.");
  CHECK(first_sentence(course[0], "spring_energy", springs) == "Energy of a spring");
  CHECK_THROWS_WITH(first_sentence(course[0], "bare", springs),
                    "include/rigid/springs.hpp says nothing about bare: write a comment with /// above it.");
}

TEST_CASE("A formula in the table of a lecture's exercises reaches MathJax, as Doxygen would not let it through") {
  const std::string contract = "/// Law \\f$F = -k_s x\\f$ of Hooke.\ndouble wave(double x);\n";
  CHECK(holds(exercise_table(course[1], contract),
              R"(| \ref exercise_wave "wave" | Law \htmlonly\(F = -k_s x\)\endhtmlonly of Hooke. | 1 |)"));
}

TEST_CASE("The first page lists every lecture with its exercises and points") {
  const std::string page = first_page(course);
  CHECK(holds(page, "- \\ref lecture_01_springs \"01 Springs\": Pull and let go. *2 exercises, 3.5 points.*\n"));
  CHECK(holds(page, "Many springs. *1 exercise, 1 point.*\n"));
}

TEST_CASE("An exercise's page leads to its neighbours, its paragraph and its file") {
  const std::string first = exercise_page(course, 0, 0, springs);
  CHECK(holds(first, "# spring_force {#exercise_spring_force}"));
  CHECK(holds(first, "Exercise 1 of 2 in the lecture \\ref lecture_01_springs \"Springs\", 1 point."));
  CHECK(holds(first, "\\copydoc rigid::spring_force"));
  CHECK(holds(first, "\\ref springs_force in the lecture"));
  CHECK(holds(first, "lectures/01_springs/exercises/spring_force.cpp"));
  CHECK(holds(first, "./checker/run check spring_force"));
  CHECK(holds(first, "\\ref exercise_spring_energy \"spring_energy →\""));
  CHECK_FALSE(holds(first, "←"));
  const std::string last = exercise_page(course, 0, 1, springs);
  CHECK(holds(last, "\\ref exercise_spring_force \"← spring_force\""));
  CHECK(holds(last, "2.5 points."));
}

TEST_CASE("A lecture's card names slides and foundations, and leaves out what is no lecture") {
  CHECK(lecture_card(course, 0) ==
        "<div class=\"lecture-card\">\nSlides: S0 s1; S1 s2. Contract: `rigid/springs.hpp`.\n</div>\n");
  CHECK(holds(lecture_card(course, 1), "Builds on: \\ref lecture_01_springs \"Springs\". Contract"));
}

TEST_CASE("A lecture leads to its neighbours in the course") {
  CHECK_FALSE(holds(lecture_links(course, 0), "←"));
  CHECK(holds(lecture_links(course, 1), "\\ref lecture_01_springs \"← Springs\""));
  CHECK_FALSE(holds(lecture_links(course, 1), "→"));
}

TEST_CASE("The course map has an arrow for each foundation, and quotes its texts") {
  const std::string map = course_map(course);
  CHECK(holds(map, "\"01_springs\" -> \"02_waves\";"));
  CHECK_FALSE(holds(map, "nowhere"));
  CHECK(holds(map, R"(label="02\nWaves \"on\"\nsprings")"));
}

TEST_CASE("The course map leaves out arrows that follow from others") {
  std::vector<Card> longer = course;
  longer.push_back(course[1]);
  longer[2].lecture = "03_sound";
  longer[2].builds_on = {"01_springs", "02_waves"};
  const std::string map = course_map(longer);
  CHECK(holds(map, "\"02_waves\" -> \"03_sound\";"));
  CHECK_FALSE(holds(map, "\"01_springs\" -> \"03_sound\";"));
}

TEST_CASE("Sound notes have no faults") {
  check_same(faults("\\figure{01_springs/cube.svg}\nA cube, seen from above.\n\\caption\nA cube.\n\\endfigure\n"), {});
}

TEST_CASE("Notes without the parts that are made from the card are named with the part") {
  check_same(faults_of_notes("01_springs", "# Springs\n", "."),
             {"lectures/01_springs/notes.md: the page lacks \\lecture_card{01_springs}.",
              "lectures/01_springs/notes.md: the page lacks \\exercises{01_springs}.",
              "lectures/01_springs/notes.md: the page lacks \\lecture_links{01_springs}."});
}

TEST_CASE("A figure that nobody draws is named with its line") {
  check_same(
      faults("\\figure{01_springs/sphere.svg}\nA sphere.\n\\caption\nA sphere.\n\\endfigure\n"),
      {"lectures/01_springs/notes.md:4: the figure 01_springs/sphere.svg does not exist; figures.cpp of the lecture "
       "draws LECTURE/NAME.svg."});
}

TEST_CASE("A figure needs both texts, and an alternative text that can stand in quotes") {
  check_same(faults("\\figure{01_springs/cube.svg}\n\\caption\nA cube.\n\\endfigure\n"),
             {"lectures/01_springs/notes.md:4: the figure 01_springs/cube.svg has no alternative text."});
  check_same(faults("\\figure{01_springs/cube.svg}\nA cube.\n\\caption\n\\endfigure\n"),
             {"lectures/01_springs/notes.md:4: the figure 01_springs/cube.svg has no caption."});
  check_same(faults("\\figure{01_springs/cube.svg}\nA \"cube\".\n\\caption\nA cube.\n\\endfigure\n"),
             {"lectures/01_springs/notes.md:4: the alternative text of the figure 01_springs/cube.svg must do without "
              "\", < and &."});
  check_same(faults("\\figure{01_springs/cube.svg}\nA cube.\n\\endfigure\n"),
             {"lectures/01_springs/notes.md:4: the figure 01_springs/cube.svg needs \\caption and then \\endfigure."});
}

TEST_CASE("Pictures by other means are refused, whichever they are") {
  const std::string sentence = "show pictures by \\figure, which asks for alternative text and caption.";
  check_same(faults("\\image html cube.svg\n<img src=\"cube.svg\">\n![cube](cube.svg)\n"),
             {"lectures/01_springs/notes.md:4: " + sentence, "lectures/01_springs/notes.md:5: " + sentence,
              "lectures/01_springs/notes.md:6: " + sentence});
}

TEST_CASE("A formula in straight quotes is refused; beside them and between curly ones it is welcome") {
  check_same(
      faults("They write \"let \\f$ x \\f$\nvanish\". Here \\f$ y \\f$ does, “so \\f$ z \\f$ too”, \\ref here \"\\f$ w "
             "\\f$\".\n"),
      {"lectures/01_springs/notes.md:4: Doxygen does not read formulas between straight quotes: write “ and ”.",
       "lectures/01_springs/notes.md:5: Doxygen does not read formulas between straight quotes: write “ and ”."});
  check_same(faults("An inch is 1\".\n\nThen \\f$ x \\f$, with an accent: \\f$ \\text{\\\"u}\\f$, and \\f$ y.\n"), {});
}

TEST_CASE("A file that cannot be read or written is named") {
  CHECK_THROWS_WITH(read_text("/no/such/file", "lectures/01_springs/notes.md"),
                    "lectures/01_springs/notes.md cannot be read.");
  CHECK_THROWS_WITH(write_text("/no/such/folder/file", "text"), "/no/such/folder/file cannot be written.");
}
