// Worked examples of lecture @NUMBER@: each case computes its own numbers, and the notes quote it.
#include <doctest/doctest.h>

#include <rigid/@TOPIC@.hpp>
