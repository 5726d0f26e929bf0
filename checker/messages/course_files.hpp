/// @file
/// What is wrong with the files that make the course, and with names of things in it.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

// --- the course

std::string course_file_is_missing(const std::string& file);

/// `reason` is what the reader of JSON says.
std::string course_file_is_not_usable(const std::string& file, const std::string& reason);

/// A name on the command line means nothing; `proposal` is what was perhaps meant, and may be empty.
std::string no_such_exercise(const std::string& name, const std::string& proposal);
std::string no_such_exercise_or_lecture(const std::string& name, const std::string& proposal);

// --- cards: `place` is the way to the part of the card, "exercises[0].points"

std::string card_is_missing(const std::string& file);
std::string card_is_not_json(const std::string& file, std::size_t byte);

/// `place` is empty for the card itself.
std::string card_needs_an_object(const std::string& file, const std::string& place);
std::string card_lacks(const std::string& file, const std::string& place);
std::string card_has_another_type(const std::string& file, const std::string& place);
std::string card_needs_a_list(const std::string& file, const std::string& place);
std::string card_needs_a_positive_number(const std::string& file, const std::string& place);
std::string card_has_an_empty(const std::string& file, const std::string& place);
std::string card_names_twice(const std::string& file, const std::string& place, const std::string& name);

// --- exercises and hints

/// The comment in a stub above the line that says "not started", without its slashes.
std::string stub_comment();

std::string hints_are_missing(const std::string& file);
std::string no_hint_in(const std::string& file);

}  // namespace workbook::messages
