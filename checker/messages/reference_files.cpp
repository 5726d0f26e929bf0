#include "checker/messages/reference_files.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string list_in_words(ListOf what) {
  switch (what) {
    case ListOf::numbers:
      return "a list of numbers";
    case ListOf::two_numbers:
      return "a list of 2 numbers";
    case ListOf::three_numbers:
      return "a list of 3 numbers";
    case ListOf::three_rows:
      return "a list of 3 rows";
    case ListOf::matrices:
      break;
  }
  return "a list of 3×3 matrices";
}

std::string numbers_in_words(std::size_t count) { return count == 1 ? "1 number" : fmt::format("{} numbers", count); }

}  // namespace

std::string at_place_in_file(const std::string& file, const std::string& place, const std::string& reason) {
  return fmt::format("{}: {}: {}", file, place, reason);
}

std::string line_and_column(std::size_t line, std::size_t column) {
  return fmt::format("line {}, column {}", line, column);
}

std::string whole_file() { return "whole file"; }

std::string top_level() { return "top level"; }

std::string cannot_be_read() { return "it cannot be read"; }

std::string cannot_be_written() { return "it cannot be written"; }

std::string ends_too_early() { return "the file ends too early: it is truncated"; }

std::string is_not_json() { return "this is not JSON"; }

std::string holds_too_large_a_number() { return "it holds a number that is too large"; }

std::string expected_object(const std::string& found) { return fmt::format("expected an object, found {}", found); }

std::string expected_list(const std::string& found) { return fmt::format("expected a list, found {}", found); }

std::string expected_string(const std::string& found) { return fmt::format("expected a string, found {}", found); }

std::string expected_truth(const std::string& found) { return fmt::format("expected true or false, found {}", found); }

std::string expected_number(const std::string& found) { return fmt::format("expected a number, found {}", found); }

std::string expected_whole_number(const std::string& found) {
  return fmt::format("expected a whole number, found {}", found);
}

std::string expected_natural_number(const std::string& found) {
  return fmt::format("expected a natural number, found {}", found);
}

std::string expected_positive_number(double found) {
  return fmt::format("expected a positive number, found {}", found);
}

std::string key_is_missing(const std::string& key) { return fmt::format("the key “{}” is missing", key); }

std::string key_is_unknown(const std::string& key) { return fmt::format("the key “{}” is unknown", key); }

std::string must_not_be_empty() { return "must not be empty"; }

std::string must_be_finite() { return "every number here must be finite, found null"; }

std::string expected_items(std::size_t expected, OnePer what, std::size_t found) {
  const char* items = expected == 1 ? "item" : "items";
  switch (what) {
    case OnePer::argument:
      return fmt::format("expected {} {} (one per argument), found {}", expected, items, found);
    case OnePer::case_of_exercise:
      return fmt::format("expected {} {} (one per case), found {}", expected, items, found);
    case OnePer::point_of_sweep:
      return fmt::format("expected {} {} (one per point of the sweep), found {}", expected, items, found);
    case OnePer::row:
      break;
  }
  return fmt::format("expected {} {} (one per row), found {}", expected, items, found);
}

std::string expected_list_of(ListOf what, const std::string& found) {
  return fmt::format("expected {}, found {}", list_in_words(what), found);
}

std::string expected_list_of(ListOf what, std::size_t found) {
  return fmt::format("expected {}, found a list of {}", list_in_words(what), found);
}

std::string expected_row(std::size_t numbers, const std::string& found) {
  return fmt::format("expected a row of {}, found {}", numbers_in_words(numbers), found);
}

std::string expected_row(std::size_t numbers, std::size_t found) {
  return fmt::format("expected a row of {}, found a list of {}", numbers_in_words(numbers), found);
}

std::string expected_square(int found) { return fmt::format("expected 3 rows of 3 numbers, found rows of {}", found); }

std::string expected_shape(int rows, int cols, int found_rows, int found_cols) {
  return fmt::format("expected the shape {}×{}, found {}×{}", rows, cols, found_rows, found_cols);
}

std::string unknown_kind(const std::string& kind) { return fmt::format("unknown kind “{}”", kind); }

std::string unknown_choice(const std::string& choice) {
  return fmt::format("“{}” is not one of the known choices", choice);
}

std::string name_stands_twice(const std::string& name) { return fmt::format("the name “{}” stands here twice", name); }

std::string expected_scales(std::size_t numbers, std::size_t found) {
  if (numbers == 1) return fmt::format("expected 1 number, found {}", found);
  return fmt::format("expected 1 or {} numbers, found {}", numbers, found);
}

std::string units_do_not_fit(std::size_t units, std::size_t numbers) {
  const char* noun = units == 1 ? "unit" : "units";
  return fmt::format("the result has {} {} but {}", units, noun, numbers_in_words(numbers));
}

std::string attitude_needs_three_angles() { return "attitudes are compared by 3 angles"; }

std::string eigenvectors_need_shape_of_argument() { return "eigenvectors must have the shape of the first argument"; }

std::string eigenvectors_need_matrices() { return "eigenvectors need a matrix3 as result and as first argument"; }

std::string result_cannot_be(const std::string& kind, const std::string& property) {
  return fmt::format("a result of kind {} cannot be {}", kind, property);
}

std::string no_such_argument() { return "there is no such argument"; }

std::string argument_of_another_kind() { return "the argument is not of the kind of the result"; }

std::string no_such_entry() { return "the result has no such row and column"; }

std::string sweep_needs_points() { return "a sweep needs points"; }

std::string expected_unit() { return "expected at least one unit, found none"; }

std::string exercise_needs_cases() { return "an exercise needs cases"; }

std::string other_format(int found, int expected) {
  return fmt::format("this file has format {}, this checker reads format {}", found, expected);
}

std::string no_results_of(const std::string& lecture, const std::string& exercise) {
  return fmt::format("The reference results of {} hold no exercise “{}”.", lecture, exercise);
}

std::string results_lack_exercise(const std::string& file, const std::string& exercise, const std::string& lecture) {
  return fmt::format("{}: exercises: '{}' is missing, though the card of {} lists it.", file, exercise, lecture);
}

std::string only_published_seed(std::uint64_t published) {
  return fmt::format(
      "This copy of the workbook has reference results for seed {} only; other seeds need the solutions, which it does "
      "not have.",
      published);
}

std::string making_results_failed(const std::string& program, std::uint64_t seed, const std::string& output) {
  return fmt::format("{}: making reference results for seed {} failed: {}", program, seed, output);
}

std::string key_stands_twice(const std::string& place, const std::string& key) {
  return fmt::format("{}: the key “{}” stands here twice", place, key);
}

}  // namespace workbook::messages
