/// @file
/// Is the workbook itself in order? Each function returns sentences that name a file and the fix; none if all is well.
#pragma once

#include "checker/course/course.hpp"
#include "checker/data/reference_results.hpp"

namespace workbook {

using Sentences = std::vector<std::string>;

/// The file as sentences name it: from the top level of the course on.
std::string in_course(const Course& course, const fs::path& file);

/// Exercises that stand on two cards.
Sentences faults_of_cards(const Course& course);

/// Parts of a lecture that are missing, all of them in one message; files that belong to no exercise; lectures that it
/// builds on and that do not exist.
Sentences faults_of_lecture(const Course& course, const Card& card);

/// Files among the exercises of a lecture that are none: a slip in a name, or something of the student's own.
Sentences stray_exercises(const Course& course, const Card& card);

/// Parts of an exercise that are missing, all of them in one message.
Sentences faults_of_parts(const Course& course, const Exercise& exercise);

/// Hints that are too few or the same, a stub that is not the one its card makes, a contract that declares another
/// function than is judged.
Sentences faults_of_texts(const Course& course, const Exercise& exercise, const ExerciseReference& reference);

/// Anchors that a misconception or a property points to and the notes do not have; examples quoted by the notes whose
/// marks are missing; facts of the card that no paragraph teaches.
Sentences faults_of_notes(const Course& course, const Card& card, const LectureReference& reference);

}  // namespace workbook
