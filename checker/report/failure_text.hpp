/// @file
/// One case in full, as plain text.
#pragma once

#include "checker/judging/comparison.hpp"

namespace workbook {

/// What text is laid out on.
struct Page {
  std::size_t width = 78;     ///< all text keeps to it where its numbers let it
  bool is_linear = false;     ///< nothing beside each other: for screen readers
  std::size_t most_rows = 8;  ///< of a long list so many are shown; the checker's JSON has them all
};

/// Inputs, expected, yours and their difference, lined up number by number, with units, and the size of the error in
/// words. On a page too narrow for columns, or a linear one, number by number below each other.
/// @param actual  empty if no value of the expected shape came back
std::vector<std::string> describe_case(const ExerciseReference& exercise, std::size_t case_index,
                                       const std::optional<Value>& actual, const Page& page = {});

/// In columns of a terminal.
std::size_t widest(const std::vector<std::string>& lines);

/// How large the error is: of the shown entry of the first failing case, or, where it is small, at all of them.
/// Empty where nothing sensible can be said.
std::string error_size(const ExerciseReference& exercise, const std::vector<std::size_t>& failing,
                       const Answers& answers);

}  // namespace workbook
