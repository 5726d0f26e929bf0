/// @file
/// Choosing a few cases that stand for all.
#pragma once

#include "checker/data/reference_results.hpp"

#include <cstddef>
#include <vector>

namespace workbook {

/// Up to `count` items, evenly spread from the first to the last.
std::vector<std::size_t> spread(const std::vector<std::size_t>& items, std::size_t count);

/// The cases to run once more in a fresh process: up to three, in reverse order, so that what a function remembers from
/// an earlier call shows.
std::vector<std::size_t> plan_repeats(const ExerciseReference& exercise);

}  // namespace workbook
