/// @file
/// What stands before the first line of every student's file, precompiled: Eigen, the usual standard headers, and
/// settings that turn silent mistakes into something one can read.
///
/// The generated prelude of a course adds its contracts, so that a result type that differs from the contract's is a
/// compile error and not an undefined call. For diagnostic runs it defines WORKBOOK_DIAGNOSE first.
#pragma once

#include <stdexcept>

namespace workbook {

/// One of Eigen's own checks failed: an index or a size does not fit. The text is the condition as Eigen writes it; the
/// checker has the words for it.
struct EigenError : std::logic_error {
  using std::logic_error::logic_error;
};

/// Throws EigenError with the condition that should have held.
void throw_eigen_error(const char* condition);

}  // namespace workbook

// The end of `v << 1, 2` is checked in a destructor, which may throw only if Eigen is told so.
#define VERIFY_RAISES_ASSERT

#define eigen_assert(...) ((__VA_ARGS__) ? static_cast<void>(0) : ::workbook::throw_eigen_error(#__VA_ARGS__))

// A matrix that was never filled gives NaN every time, not a number by chance. In a diagnostic run all memory is
// filled.
#if !defined(WORKBOOK_DIAGNOSE)
#define EIGEN_INITIALIZE_MATRICES_BY_NAN
#endif

// What students' files may use without including it.
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <istream>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// As <iostream> declares them, but without its static object, which would link all of locale and streams, half a
// worker, to functions that print nothing. streams.cpp has that object; it is linked where a file names one of these.
namespace std {
extern istream cin;
extern ostream cout, cerr, clog;
}  // namespace std
