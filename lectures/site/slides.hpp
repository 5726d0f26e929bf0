/// @file
/// The page "From the slides to the workbook": what became of every fact of the five decks.
#pragma once

#include "checker/course/card.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace workbook::site {

/// One fact of the slides, as facts.json lists it.
struct Fact {
  int number = 0;
  std::string text;
  std::map<std::string, std::string> where;  ///< deck → slides; empty for what the slides leave out
  std::vector<std::string> exercises;        ///< by name
};

/// @throws std::runtime_error that names the file and what is wrong with it.
std::vector<Fact> read_facts(const std::filesystem::path& file);

/// Where a lecture's notes teach a fact: the paragraph after the comment that names its number.
struct Paragraph {
  std::string lecture;
  std::string anchor;
  std::vector<std::string> worked_examples;  ///< the regions that the paragraph quotes
};

/// The paragraphs of one lecture's notes, by number of the fact.
std::map<int, Paragraph> paragraphs_of(const std::string& lecture, const std::string& notes);

/// Facts without a paragraph, a worked example, an exercise, or with an exercise that no card lists: one sentence each.
std::vector<std::string> faults_of_coverage(const std::vector<Fact>& facts, const std::map<int, Paragraph>& paragraphs,
                                            const std::vector<Card>& course);

/// The page in Markdown: a table for each deck, in the order of its slides, and one for what was added.
std::string slides_page(const std::vector<Fact>& facts, const std::map<int, Paragraph>& paragraphs);

/// What one lecture corrects: the text below its heading "Where the slides need care"; "" without such a heading.
std::string errata_of(const std::string& notes);

/// The page of all errata. @param notes the text of each lecture's notes, in the order of the course
std::string errata_page(const std::vector<Card>& course, const std::vector<std::string>& notes);

}  // namespace workbook::site
