/// @file
/// What is said of the worked examples on a student's own functions.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

/// A heading; the files stand below it.
std::string examples_need_files_that_compile();
std::string examples_could_not_be_built(const std::string& lecture);

// --- the examples ended before their end

std::string examples_took_too_long(const std::string& lecture);
std::string examples_crashed(int signal, const std::string& lecture);
std::string examples_printed_too_much();

/// The program ended by itself, and what it left is no report.
std::string examples_left_no_report(int exit_status);

// --- one line for each example

std::string example_is_not_started(const std::string& title);
std::string example_comes_out_otherwise(const std::string& title);

std::string examples_come_out(std::size_t passed, std::size_t total, const std::string& lecture);

}  // namespace workbook::messages
