// Worked examples of lecture 09: each case computes its own numbers, and the notes quote it.
#include <doctest/doctest.h>

#include <rigid/heavy_top.hpp>
