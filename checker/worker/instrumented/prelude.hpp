/// @file
/// What stands before the first line of a student's file when the checker looks at a failure once more. The same
/// headers as in the prelude of judging, with checks that tell more about what failed, and without its fixed values
/// for what was never set: here the witness fills the memory, differently each time.
#pragma once

#include "eigen_facts.hpp"

#include <version>

#if defined(__GLIBCXX__) && defined(__glibcxx_assert)
#undef __glibcxx_assert
#define __glibcxx_assert(...)                                                                                          \
  do {                                                                                                                 \
    if (!bool(__VA_ARGS__))                                                                                            \
      ::workbook::report_library_assertion(__PRETTY_FUNCTION__, #__VA_ARGS__, ::workbook::CatchSides()->*__VA_ARGS__); \
  } while (false)
#endif

// The end of `v << 1, 2` is checked in a destructor, which may throw only if Eigen is told so.
#define VERIFY_RAISES_ASSERT

#include "../../worker/headers.hpp"
