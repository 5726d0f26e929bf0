/// @file
/// Contract of lecture @NUMBER@: TODO.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

}  // namespace rigid
