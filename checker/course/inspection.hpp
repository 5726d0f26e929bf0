/// @file
/// Is the workbook itself in order? Each function returns sentences that name a file and the cure; none if all is well.
#pragma once

#include "checker/course/course.hpp"
#include "checker/data/reference_results.hpp"

#include <string>
#include <vector>

namespace workbook {

/// Exercise names that stand on two cards, parts of a lecture that are missing, files that no card lists.
std::vector<std::string> faults_of_files(const Course& course);

/// Hints: three per exercise, each different.
std::vector<std::string> faults_of_hints(const Course& course, const Exercise& exercise);

/// A stub that differs from what its card makes.
std::vector<std::string> faults_of_stub(const Course& course, const Exercise& exercise,
                                        const ExerciseReference& reference);

/// A signature that the contract does not declare.
std::vector<std::string> faults_of_contract(const Course& course, const Exercise& exercise,
                                            const ExerciseReference& reference);

/// Anchors that the card, a misconception or a property points to and the notes do not have; snippets of the notes
/// whose marks are missing; facts of the card that no paragraph teaches.
std::vector<std::string> faults_of_notes(const Course& course, const Card& card, const LectureReference& reference);

}  // namespace workbook
