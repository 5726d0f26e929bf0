/// @file
/// The pages and parts of pages that are derived from the cards: texts in Markdown for Doxygen, and the course map for
/// Graphviz.
#pragma once

#include "checker/course/card.hpp"

#include <string>
#include <vector>

namespace workbook::site {

/// The first page: what the course is, the course map, and a list of the lectures.
std::string first_page(const std::vector<Card>& course);

/// All exercises in the order of the course; every page of an exercise hangs below this one.
/// @param contracts the text of each lecture's contract
std::string exercises_page(const std::vector<Card>& course, const std::vector<std::string>& contracts);

/// The page of one exercise: its contract, where to read, and what to type. Its hints stay with the checker, so that
/// nobody reads them by accident.
/// @param course   the cards
/// @param lecture  index of the lecture in the course
/// @param exercise index of the exercise in the lecture
/// @param contract text of the lecture's contract
std::string exercise_page(const std::vector<Card>& course, std::size_t lecture, std::size_t exercise,
                          const std::string& contract);

/// Top of a lecture's page: its source slides, what it builds on, its contract. Quoted by \\lecture_card.
std::string lecture_card(const std::vector<Card>& course, std::size_t lecture);

/// The lecture's exercises as a table. Quoted by \\exercises.
std::string exercise_table(const Card& card, const std::string& contract);

/// Bottom of a lecture's page: the way to the lecture before, the course map and the next lecture.
/// Quoted by \\lecture_links.
std::string lecture_links(const std::vector<Card>& course, std::size_t lecture);

/// The course map in the language of Graphviz: an arrow leads from a lecture to each one that builds on it, but
/// for arrows that follow from others. A name that is no lecture of the course is left out here; the checker's
/// self-check refuses it.
std::string course_map(const std::vector<Card>& course);

/// The first sentence of a function's comment in a contract.
/// @throws std::runtime_error when the contract does not declare it, or without a comment.
std::string first_sentence(const Card& card, const std::string& function, const std::string& contract);

/// The declaration of a function in a contract, without its comment.
/// @throws std::runtime_error when the contract does not declare it.
std::string declaration(const Card& card, const std::string& function, const std::string& contract);

}  // namespace workbook::site
