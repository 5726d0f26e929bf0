/// @file
/// What is wrong with a file of reference results, or why there is none. Never the student's fault.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace workbook::messages {

// --- the whole file: a place in it, and what is wrong there

/// "03_inertia_tensor.json: line 2, column 13: this is not JSON"
std::string at_place_in_file(const std::string& file, const std::string& place, const std::string& reason);

std::string line_and_column(std::size_t line, std::size_t column);
std::string whole_file();
std::string top_level();

std::string cannot_be_read();
std::string cannot_be_written();
std::string ends_too_early();
std::string is_not_json();
std::string holds_too_large_a_number();

// --- reasons that stand behind a place: of what JSON can hold

/// What was found is said in JSON's own words ("array") or as it stands there ("-1").
std::string expected_object(const std::string& found);
std::string expected_list(const std::string& found);
std::string expected_string(const std::string& found);
std::string expected_truth(const std::string& found);
std::string expected_number(const std::string& found);
std::string expected_whole_number(const std::string& found);
std::string expected_natural_number(const std::string& found);
std::string expected_positive_number(double found);

std::string key_is_missing(const std::string& key);
std::string key_is_unknown(const std::string& key);
std::string must_not_be_empty();
std::string must_be_finite();

/// What the number of items of a list goes by.
enum class OnePer { argument, case_of_exercise, point_of_sweep, row };

std::string expected_items(std::size_t expected, OnePer what, std::size_t found);

// --- reasons: of values

/// What a list should have been.
enum class ListOf { numbers, two_numbers, three_numbers, three_rows, matrices };

std::string expected_list_of(ListOf what, const std::string& found);
std::string expected_list_of(ListOf what, std::size_t found);

/// A row of a matrix is no list, or one of another length than the first.
std::string expected_row(std::size_t numbers, const std::string& found);
std::string expected_row(std::size_t numbers, std::size_t found);

std::string expected_square(int found);
std::string expected_shape(int rows, int cols, int found_rows, int found_cols);
std::string unknown_kind(const std::string& kind);

// --- reasons: of an exercise

std::string unknown_choice(const std::string& choice);
std::string name_stands_twice(const std::string& name);
std::string expected_scales(std::size_t numbers, std::size_t found);
std::string units_do_not_fit(std::size_t units, std::size_t numbers);
std::string attitude_needs_three_angles();
std::string eigenvectors_need_shape_of_argument();
std::string eigenvectors_need_matrices();
std::string result_cannot_be(const std::string& kind, const std::string& property);
std::string no_such_argument();
std::string argument_of_another_kind();
std::string no_such_entry();
std::string sweep_needs_points();
std::string expected_unit();
std::string exercise_needs_cases();
std::string other_format(int found, int expected);

// --- results that are not there

std::string no_results_of(const std::string& lecture, const std::string& exercise);

/// The file lacks an exercise that the card lists.
std::string results_lack_exercise(const std::string& file, const std::string& exercise, const std::string& lecture);

std::string only_published_seed(std::uint64_t published);

/// `output` is what the program said that makes them.
std::string making_results_failed(const std::string& program, std::uint64_t seed, const std::string& output);

/// `place` is the way to the object with the key.
std::string key_stands_twice(const std::string& place, const std::string& key);

}  // namespace workbook::messages
