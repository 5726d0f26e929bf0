/// @file
/// Who looks for reasons. To add one: a file of its own with a function like those below, its line here and in the
/// table of explain.cpp, and its test. (What the values alone tell is a mechanism of values/.)
#pragma once

#include "checker/explain/explain.hpp"

#include <algorithm>

namespace workbook {

/// What is looked at, and what has been found so far.
struct Search {
  const Evidence& evidence;
  Answers answers;
  std::vector<Reason> in_code;       ///< what the text and the compiler's warnings give away; told at the end
  std::vector<Reason> reasons = {};  ///< why it failed

  Verdict verdict() const { return evidence.task.judgement.verdict; }
  bool has_mistake_in_code() const { return !std::ranges::all_of(in_code, &Reason::is_remark); }
  bool has_cause() const { return std::ranges::any_of(reasons, &Reason::is_cause); }
  /// Adds reasons in the code, but no second one about a line that has been spoken of.
  void add_code(std::vector<Reason> more);
};

/// Adds what it finds. True: this is the reason, and nothing else is looked for.
using Explainer = bool(Search& search);

Explainer explain_failed_call;  ///< no value came back (diagnostic_run.cpp)

// --- mistakes in the code (code_mistakes.cpp)

Explainer explain_fixed_mistakes;     ///< with which put right, the values are others
Explainer explain_slips_of_language;  ///< where all is right with another reading
Explainer explain_spoilt_statement;   ///< a statement that does something else than it seems to

// --- what values tell

Explainer explain_values;       ///< all of values/ (asked_values.cpp)
Explainer explain_lost_digits;  ///< nearly right, but for chance (asked_values.cpp)

// --- what other runs tell

Explainer explain_by_small_change;      ///< one changed token, or a branch (repair.cpp)
Explainer explain_suspected_undefined;  ///< the same, at once, where a case or a warning points to it
Explainer explain_by_sanitizers;        ///< what is undefined, or not finite (diagnostic_run.cpp)

bool are_zero(const Answers& answers);

}  // namespace workbook
