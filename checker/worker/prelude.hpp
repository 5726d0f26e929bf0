/// @file
/// What stands before the first line of every student's file, precompiled: Eigen, the usual standard headers, and
/// settings that turn silent mistakes into something one can read.
///
/// The generated prelude of a course adds its contracts, so that a result type that differs from the contract's is a
/// compile error and not an undefined call.
#pragma once

#include <stdexcept>

namespace workbook {

/// One of Eigen's own checks failed: an index or a size does not fit. The text is the condition as Eigen writes it; the
/// checker has the words for it.
struct EigenError : std::logic_error {
  using std::logic_error::logic_error;
};

/// Throws EigenError with the condition that should have held.
void report_eigen_assertion(const char* condition);

}  // namespace workbook

#define eigen_assert(...) ((__VA_ARGS__) ? static_cast<void>(0) : ::workbook::report_eigen_assertion(#__VA_ARGS__))

// The end of `v << 1, 2` is checked in a destructor, which may throw only if Eigen is told so.
#define VERIFY_RAISES_ASSERT

// A matrix that was never filled gives NaN every time, not a number by chance.
#define EIGEN_INITIALIZE_MATRICES_BY_NAN

#include "headers.hpp"
