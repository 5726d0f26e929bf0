/// @file
/// A question on an exercise that passes, made from its misconceptions.
#pragma once

#include "checker/data/reference_results.hpp"

#include <array>
#include <optional>

namespace workbook {

/// What a wrong function returns at one case, and three misconceptions: only one of them gives that value.
struct Question {
  std::size_t case_index = 0;
  std::array<std::size_t, 3> choices{};  ///< numbers of misconceptions
  std::size_t right = 0;                 ///< which of the choices
};

/// The same one at every call; nothing if no case tells three misconceptions apart.
std::optional<Question> question_on(const ExerciseReference& exercise);

}  // namespace workbook
