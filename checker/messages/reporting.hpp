/// @file
/// The words around a verdict on the terminal.
#pragma once

#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::messages {

/// "wrong value" for wrong_value.
std::string in_words(Verdict verdict);

std::string cases_right(std::size_t passed, std::size_t total);

/// What is to be said of a line of the student's file.
std::string at_line(int line, const std::string& sentence);

/// A paragraph of the notes, where they are no pages.
std::string paragraph(const std::string& notes, const std::string& anchor);

// --- labels in front of what belongs to a verdict; at most six letters fit

std::string why_label();
std::string read_label();
std::string next_label();
std::string again_label();
std::string more_label();
std::string hint_label();
std::string plot_label();

// --- headings and ends of longer texts

std::string your_code_printed();
std::string the_compiler_says();
std::string more_lines(std::size_t count);

// --- the whole

/// "6 of 8 passed, 1 to mend, 1 not started."
std::string summary(std::size_t total, std::size_t passed, std::size_t wrong, std::size_t not_started,
                    std::size_t errors);

/// An unknown --case; `proposal` may be empty.
std::string no_such_case(const std::string& exercise, const std::string& name, const std::string& proposal,
                         const std::vector<std::string>& known);

std::string case_needs_one_exercise();
std::string file_needs_one_exercise(const std::string& command);
std::string nothing_started();

// --- beside a progress bar

std::string done_so_far(std::size_t done, std::size_t total);
std::string building();

}  // namespace workbook::messages
