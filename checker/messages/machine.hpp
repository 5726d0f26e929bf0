/// @file
/// What doctor says of the machine: what each line is about, and how it stands.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

/// The marks of a plain terminal, each with its blank.
std::string good_mark();
std::string bad_mark();

std::string about_compiler();
std::string about_reference();
std::string about_sandbox();
std::string about_gnuplot();
std::string about_folder();
std::string about_notes();
std::string about_terminal();

std::string results_are_there(std::size_t lectures, std::size_t exercises);

/// How strong the walls around students' functions are.
std::string sandbox_is_whole();
std::string kernel_has_no_filter();
std::string built_without_filter();

std::string gnuplot_is_missing();
std::string folder_is_writable(const std::string& folder);
std::string folder_is_not_writable(const std::string& folder);
std::string notes_are_not_built();
std::string terminal_is(std::size_t columns, bool has_color);

/// A reason, to stand in parentheses.
std::string disk_may_be_full();

}  // namespace workbook::messages
