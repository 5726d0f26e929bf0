/// @file
/// Where a student stands, and what is next.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

/// "3 of 48 exercises pass, 4 of 60 points."
std::string standing(std::size_t passed, std::size_t total, double points, double all_points);

/// "3 of 8".
std::string of(std::size_t done, std::size_t total);

std::string passed();
std::string changed_since_it_passed();
std::string not_started();

/// A verdict's name as words: "wrong value" for "wrong_value".
std::string verdict_in_words(std::string verdict);

/// "2 points".
std::string points(double points);

/// Before the name of the next exercise: "Next".
std::string next_exercise();

// What stands before a file, a page, a command.
std::string file_row();
std::string notes_row();
std::string state_row();
std::string check_row();
std::string hint_row();
std::string watch_row();

std::string everything_passes(std::size_t total);

}  // namespace workbook::messages
