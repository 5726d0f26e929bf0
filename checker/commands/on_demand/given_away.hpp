/// @file
/// Problems leave the formula to the student: does anything that is read before give it away?
#pragma once

#include "checker/course/course.hpp"

namespace workbook {

/// Where the answer of a problem stands, and what to do about it.
struct GivenAway {
  fs::path file;
  std::string sentence;
};

/// Looks through what a student reads unfolded: the contract, hints one and two, the notes and the code that they
/// quote. Formulas are those of the last display of the derivation; code is what the solution returns. Formulas of the
/// same names count as equal, code whatever the names of its variables.
std::vector<GivenAway> answers_given_away(const Course& course, const Exercise& problem);

}  // namespace workbook
