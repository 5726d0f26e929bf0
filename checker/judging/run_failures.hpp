/// @file
/// What a student reads of a call that gave no value.
#pragma once

#include "checker/data/observation.hpp"

namespace workbook {

/// The sentence, and what to do.
struct Advice {
  std::string message;
  std::string next_step;
};

/// @param when  where in the run it happened: "at the case …". @param signature  of the function, as its header has it
/// @pre the call did not return
Advice advice_on_ending(const std::string& when, const Reply& reply, const std::string& signature);

/// What an assertion of Eigen means, without a full stop; with indices and sizes where they are known.
std::string sentence(const EigenAssertion& assertion);

/// Its kind, for programs: "index_out_of_range".
std::string kind_of(const EigenAssertion& assertion);

/// "open a file": what a forbidden system call is for, to follow "tried to".
std::string forbidden_operation(long system_call);

/// A student's text inside a sentence: on one line, at most 300 bytes.
std::string quoted(const std::string& text);

}  // namespace workbook
