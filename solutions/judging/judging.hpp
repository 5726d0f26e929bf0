/// @file
/// All that a description of an exercise is written with.
#pragma once

#include "solutions/judging/algebra.hpp"
#include "solutions/judging/changes.hpp"
#include "solutions/judging/exercise.hpp"
#include "solutions/judging/mechanics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace workbook::judging {

using std::abs, std::acos, std::asin, std::atan, std::atan2, std::copysign, std::cos, std::hypot, std::polar, std::pow,
    std::sin, std::sqrt, std::tan, std::clamp, std::max, std::min, std::swap, std::tuple;

}  // namespace workbook::judging

// Only descriptions of exercises include this header, and all of each is about judging.
using namespace workbook::judging;
