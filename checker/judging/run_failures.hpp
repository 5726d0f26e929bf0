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

/// What it means that this condition of Eigen failed, without a full stop.
std::string sentence_on_eigen(const std::string& condition);

/// Its kind, for programs: "index_out_of_range".
std::string kind_of_eigen(const std::string& condition);

/// "open a file": what a forbidden system call is for, to follow "tried to".
std::string forbidden_operation(long system_call);

/// A student's text inside a sentence: on one line, at most 300 bytes.
std::string quoted(const std::string& text);

}  // namespace workbook
