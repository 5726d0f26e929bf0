/// @file
/// Texts that only a right function opens: in copies for students, the solution and the derivation of an exercise.
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"

namespace workbook {

/// Does it have enough random cases for a key that cannot be guessed? A whole number is worth little: as many bits as
/// the most frequent one among them leaves to be guessed.
bool makes_key(const ExerciseReference& reference);

/// Encrypts a text. The key is what a right function returns at inputs that are kept with it, rounded so coarsely that
/// every right answer gives the same key.
/// @param reference  drawn with a seed whose results the reader does not have
/// @throws std::runtime_error if it makes no key
std::string locked_text(const ExerciseReference& reference, const std::string& text);

/// The calls of which a right function opens it. @throws std::runtime_error if the locked text is damaged
std::vector<PlannedCall> calls_of_locked(const std::string& locked);

/// The text; nothing if the function did not return what a right one does.
/// @param replies  to these calls. @throws std::runtime_error if the locked text is damaged
std::optional<std::string> unlocked_text(const std::string& locked, const std::vector<Reply>& replies);

}  // namespace workbook
