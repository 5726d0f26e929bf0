// The table of facts: what it shows, and that an empty place in it is found.
#include "lectures/site/slides.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace workbook;
using namespace workbook::site;

namespace {

const std::string notes =
    "# Springs {#lecture_01_springs}\n"
    "<!-- fact 1 -->\n### A spring pulls back {#springs_force}\nText.\n"
    "\\snippet 01_springs/worked_examples.cpp pulling\n"
    "## Next {#springs_next}\n\\snippet 01_springs/worked_examples.cpp elsewhere\n"
    "<!-- fact 2 -->\n### It holds energy {#springs_energy}\nNo example here.\n"
    "## Where the slides need care {#springs_errata}\n\n- A sign.\n\n## Sources {#springs_sources}\n";

std::vector<Card> course() {
  Card card;
  card.lecture = "01_springs";
  card.title = "Springs";
  card.exercises = {{"spring_force", 1, "springs_force", "Write it."}};
  return {card};
}

const Fact pulls{1, "a spring pulls back", {{"S0", "s3"}}, {"spring_force"}};

}  // namespace

TEST_CASE("a fact's paragraph is the one after its mark, with the examples that it quotes") {
  const auto paragraphs = paragraphs_of("01_springs", notes);
  REQUIRE(paragraphs.size() == 2);
  CHECK(paragraphs.at(1).anchor == "springs_force");
  CHECK(paragraphs.at(1).worked_examples == std::vector<std::string>{"pulling"});
  CHECK(paragraphs.at(2).worked_examples.empty());
}

TEST_CASE("an empty place in the table is a fault") {
  const auto paragraphs = paragraphs_of("01_springs", notes);
  CHECK(faults_of_coverage({pulls}, paragraphs, course()).empty());
  const auto fault = [&](const Fact& fact) {
    const auto faults = faults_of_coverage({fact}, paragraphs, course());
    REQUIRE(faults.size() == 1);
    return faults.front();
  };
  CHECK(fault({3, "x", {}, {"spring_force"}}) ==
        "fact 3 (x): no paragraph of the notes has `<!-- fact 3 -->` before a heading with an anchor.");
  CHECK(fault({2, "x", {}, {"spring_force"}}) ==
        "fact 2 (x): its paragraph springs_energy of 01_springs quotes no worked example.");
  CHECK(fault({1, "x", {}, {}}) == "fact 1 (x): no exercise practises it.");
  CHECK(fault({1, "x", {}, {"spring_entropy"}}) == "fact 1 (x): its exercise 'spring_entropy' is on no card.");
}

TEST_CASE("the page has a row in the deck that states the fact, and in no other") {
  const std::string page = slides_page({pulls}, paragraphs_of("01_springs", notes));
  const std::string row =
      "| s3 | a spring pulls back | \\ref springs_force | pulling | \\ref exercise_spring_force \"spring_force\" |";
  const std::size_t first = page.find(row);
  CHECK(first != std::string::npos);
  CHECK(first < page.find("## S1"));
  CHECK(page.find(row, first + 1) == std::string::npos);
}

TEST_CASE("the errata of a lecture end with their section") {
  CHECK(errata_of(notes) == "\n- A sign.\n");
  CHECK(errata_of("# Nothing\n").empty());
  CHECK(errata_page(course(), {notes}).find("## Springs {#errata_01_springs}\n\n- A sign.") != std::string::npos);
}

TEST_CASE("a list of facts that cannot be read is named") {
  CHECK_THROWS_WITH(read_facts("no/such/facts.json"), "no/such/facts.json: the list of facts is missing.");
}
