/// @file
/// site_pages SOURCE FIGURES OUTPUT LECTURE…: writes into OUTPUT the pages of the site that are derived from the cards,
/// after looking at the notes of every lecture. Exit status: 0 written, 1 not written, for the reasons that are
/// printed, 2 wrong usage.
#include "lectures/site/notes_check.hpp"
#include "lectures/site/pages.hpp"
#include "lectures/site/slides.hpp"
#include "lectures/site/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>

using namespace workbook;
using namespace workbook::site;

namespace {

void write_pages(const std::filesystem::path& source, const std::filesystem::path& output,
                 const std::vector<Card>& course) {
  // Parts are quoted by the notes; Doxygen must not take them for pages of their own.
  const std::filesystem::path parts = output / "parts";
  const std::filesystem::path exercises = output / "exercises";
  std::filesystem::remove_all(output);
  std::filesystem::create_directories(parts);
  std::filesystem::create_directories(exercises);
  std::vector<std::string> contracts;
  for (const Card& card : course) {
    const std::string header = "include/rigid/" + card.contract + ".hpp";
    contracts.push_back(read_text(source / header, header));
  }
  write_text(output / "index.md", first_page(course));
  write_text(output / "exercises.md", exercises_page(course, contracts));
  write_text(output / "course_map.dot", course_map(course));
  for (std::size_t lecture = 0; lecture < course.size(); ++lecture) {
    const Card& card = course[lecture];
    write_text(parts / (card.lecture + ".card.md"), lecture_card(course, lecture));
    write_text(parts / (card.lecture + ".exercises.md"), exercise_table(card, contracts[lecture]));
    write_text(parts / (card.lecture + ".links.md"), lecture_links(course, lecture));
    for (std::size_t exercise = 0; exercise < card.exercises.size(); ++exercise) {
      write_text(exercises / (card.exercises[exercise].name + ".md"),
                 exercise_page(course, lecture, exercise, contracts[lecture]));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: site_pages SOURCE FIGURES OUTPUT LECTURE…\n");
    return 2;
  }
  try {
    const std::filesystem::path source = argv[1];
    std::vector<Card> course;
    for (int i = 4; i < argc; ++i) course.push_back(read_card(source / "lectures", argv[i]));
    std::vector<std::string> notes;
    std::map<int, Paragraph> paragraphs;
    std::vector<std::string> faults;
    for (const Card& card : course) {
      const std::string shown = "lectures/" + card.lecture + "/notes.md";
      notes.push_back(read_text(source / shown, shown));
      paragraphs.merge(paragraphs_of(card.lecture, notes.back()));
      std::ranges::copy(faults_of_notes(card.lecture, notes.back(), argv[2]), std::back_inserter(faults));
    }
    const std::vector<Fact> facts = read_facts(source / "lectures/site/facts.json");
    std::ranges::copy(faults_of_coverage(facts, paragraphs, course), std::back_inserter(faults));
    for (const std::string& sentence : faults) fmt::print(stderr, "{}\n", sentence);
    if (!faults.empty()) return 1;
    write_pages(source, argv[3], course);
    write_text(std::filesystem::path(argv[3]) / "from_the_slides.md", slides_page(facts, paragraphs));
    write_text(std::filesystem::path(argv[3]) / "errata.md", errata_page(course, notes));
    return 0;
  } catch (const std::filesystem::filesystem_error& error) {
    fmt::print(stderr, "{} cannot be written: {}.\n", error.path1().string(), error.code().message());
    return 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
