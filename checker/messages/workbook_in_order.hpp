/// @file
/// What self-check finds amiss in the workbook itself, and the cure. For its authors.
#pragma once

#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

namespace workbook::messages {

// --- files; every file is named from the workbook's root

std::string file_on_card_is_missing(const std::string& file);
std::string file_on_no_card(const std::string& file);
std::string exercise_on_two_cards(const std::string& card, const std::string& exercise, const std::string& other);
std::string contract_is_missing(const std::string& contract, const std::string& lecture);
std::string builds_on_unknown(const std::string& card, const std::string& earlier);
std::string another_number_of_hints(const std::string& file, std::size_t hints, std::size_t wanted);
std::string two_hints_are_the_same(const std::string& file);
std::string not_the_stub(const std::string& file, const std::string& exercise);
std::string contract_declares_otherwise(const std::string& contract, const std::string& signature);

// --- notes

/// `who` points there: one of the three below.
std::string no_such_anchor(const std::string& notes, const std::string& anchor, const std::string& who);
std::string the_card_points();
std::string misconception_points(const std::string& exercise, const std::string& misconception);
std::string property_points(const std::string& exercise);

/// `marks` of the two marks of the example stand in the quoted file.
std::string quoted_without_marks(const std::string& notes, const std::string& example, const std::string& file,
                                 std::size_t marks);
std::string fact_is_not_taught(const std::string& notes, int fact);

// --- judging

/// `sentence` is one of those below.
std::string judging_is_inconsistent(const std::string& lecture, const std::string& exercise,
                                    const std::string& sentence);

std::string few_misconceptions(std::size_t found, std::size_t fewest);
std::string few_routes(std::size_t found, std::size_t fewest);
std::string few_deciding_cases(std::size_t found, std::size_t fewest);
std::string no_worked_case();
std::string no_sweep();

/// `verdict` is the sentence of the verdict that should not have been, here and below.
std::string expected_values_fail(const std::string& verdict);
std::string expected_value_lacks(const std::string& case_name, const std::string& property, const std::string& detail);
std::string misconception_is_right(const std::string& name);
std::string misconceptions_cannot_be_told_apart(const std::string& one, const std::string& other);

/// `instead` is what is said to a student who has it.
std::string misconception_is_not_named(const std::string& name, const std::string& instead);
std::string terms_do_not_add_up(const std::string& case_name);
std::string terms_are_not_independent();
std::string route_fails(const std::string& name, const std::string& verdict);

// --- verdicts

std::string stub_is_judged_otherwise(const std::string& file, const Judgement& judgement, const std::string& exercise);
std::string solution_is_judged_otherwise(const std::string& file, const Judgement& judgement);
std::string passes_and_is_accused(const std::string& file, const std::string& diagnosis);

// --- the whole

/// What is being checked, beside the bar.
std::string lecture_and_seed(const std::string& lecture, std::uint64_t seed);
std::string to_mend(std::size_t faults);

/// What self-check looked at.
struct Extent {
  std::size_t lectures = 0;
  std::size_t exercises = 0;
  std::size_t routes = 0;
  std::size_t misconceptions = 0;
  std::size_t seeds = 0;
};

std::string in_order(const Extent& extent);

}  // namespace workbook::messages
