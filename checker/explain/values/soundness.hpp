/// @file
/// What is wrong with the reference results of an exercise, for its author.
#pragma once

#include "checker/data/reference_results.hpp"

namespace workbook {

/// One sentence for every contradiction and every missing part: misconceptions that cannot be told apart, terms that do
/// not add up to the expected result, routes that do not pass, too few cases. Empty for a sound exercise.
std::vector<std::string> unsound_parts(const ExerciseReference& exercise);

/// Then the solution is what is wrong, and all else that is found is a consequence.
bool do_routes_agree_on_another(const ExerciseReference& exercise);

/// A sentence for each of these bugs, which no case shows, where the exercise gives no reason for it.
std::vector<std::string> unshown_bugs(const ExerciseReference& exercise, const std::vector<std::string>& survivors);

}  // namespace workbook
