/// @file
/// Everything that the watch says, in one place.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::messages {

// --- the frame of the screen

/// "12 of 48"
std::string passed_of(std::size_t passed, std::size_t total);

/// The keys that can be pressed, each with its word.
std::vector<std::string> keys();

/// What to press where there is no keyboard to read.
std::string no_keyboard();

/// "Lines 1–20 of 43; space or ↓ shows more."
std::string part_shown(std::size_t first, std::size_t last, std::size_t total);

/// @param key  as it was typed; "" for a key without a letter
std::string unknown_key(const std::string& key);

// --- what goes on

std::string waiting(const std::string& exercise);

/// @param seconds  since the check began; 0 is not said
std::string checking(const std::string& exercise, long seconds);

/// For a plot or the compiler's words, which take a moment.
std::string working_for(const std::string& exercise, long seconds);

/// "Next", or "Passed"
std::string label_of_exercise(bool passed);

// --- what happened

/// All exercises of `scope` pass; `scope` is a lecture, or "" for the course.
std::string all_pass(const std::string& scope, std::size_t total);
std::string passes_already(const std::string& exercise);
std::string first_of_the_course();
std::string last_one_left(const std::string& exercise);

/// The check ended without an exit status of its own.
std::string check_died(const std::string& exercise, int signal);
std::string command_died(int signal);
std::string check_cannot_start(const std::string& exercise, const std::string& reason);
std::string command_cannot_start(const std::string& reason);

/// Before ": " and the system's reason.
std::string cannot_listen_to_signals();

std::string no_events(const std::string& reason);
std::string polling_wanted();
std::string folder_gone(const std::string& folder);
std::string folder_back(const std::string& folder);
std::string more_verdicts(std::size_t count);

/// The last word. @param next  the next exercise, "" if all pass
std::string goodbye(std::size_t passed, std::size_t total, const std::string& next);

std::string nothing_to_watch();

}  // namespace workbook::messages
