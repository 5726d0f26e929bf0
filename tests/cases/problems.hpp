/// @file
/// What the worked values of all lectures are written with.
#pragma once

#include "lectures/support/agrees.hpp"

#include <rigid/vocabulary.hpp>

#include <cmath>
#include <numbers>

using namespace rigid;
using workbook::agrees;

inline constexpr double digits = 5e-12;  // of values that were computed elsewhere
inline constexpr double pi = std::numbers::pi, degree = pi / 180;
