/// @file
/// Texts that only a right function opens: in copies for students, the solution and the derivation of an exercise.
#pragma once

#include "checker/data/reference_results.hpp"

#include <functional>
#include <optional>

namespace workbook {

/// One call of the function, and what it returned; nothing where it returned no usable value.
using Evaluate = std::function<std::optional<Value>(const std::vector<Value>& inputs, int rows, int cols)>;

/// Does it have enough random cases for a key that cannot be guessed? A whole number is worth little: as many bits as
/// the most frequent one among them leaves to be guessed.
bool makes_key(const ExerciseReference& reference);

/// Encrypts a text. The key is what a right function returns at inputs that are kept with it, rounded so coarsely that
/// every right answer gives the same key.
/// @param reference  drawn with a seed whose results the reader does not have
/// @throws std::runtime_error if it makes no key
std::string locked_text(const ExerciseReference& reference, const std::string& text);

/// The text; nothing if the function does not return what a right one does.
/// @throws std::runtime_error if the locked text is damaged
std::optional<std::string> unlocked_text(const std::string& locked, const Evaluate& evaluate);

}  // namespace workbook
