/// @file
/// Why a function failed, in one sentence. It is a help and never a grade.
#pragma once

#include <string>

namespace workbook {

enum class ReasonKind {
  code,             ///< a mistake in the text of the file, or what a run of it met
  repair,           ///< the change in the file with which all cases are right, or the branch that the failing ones take
  misconception,    ///< a named wrong answer
  term,             ///< a wrong coefficient
  transform,        ///< the right result, changed as a whole
  input_transform,  ///< the right result for changed inputs
  difference,       ///< by what a component differs
  split,            ///< what the failing cases have in common
  independence,     ///< elements of a list that never change the result
  entry,            ///< entries that hold something else
  place,            ///< which components are wrong, and where
  accuracy,         ///< right to some digits only
  learnt,           ///< the results of known cases, and no function
  property
};
std::string to_string(ReasonKind kind);

/// How much a reason explains.
enum class Weight {
  cause,     ///< it explains the failure
  possible,  ///< certainly so, and may be what is wrong
  symptom,   ///< certainly so, but a consequence of a reason that it does not name
  remark     ///< only odd
};

/// The small change in a file by which a mistake in it is put right.
enum class Fix {
  none,
  real_quotient,
  when_all_right,  ///< another one, that goes with it
  decimal_point,
  exact_pi,
  as_double,
  wider_type,
  not_static,
  no_noalias,
  as_value,
  by_reference,
  compound
};

/// Either true or absent.
struct Reason {
  ReasonKind kind = ReasonKind::code;
  std::string name = {};      ///< of the kind of mistake, "integer_division"; the same in `check --json`
  std::string sentence = {};  ///< what is to be said of it
  Weight weight = Weight::cause;
  std::string notes = {};  ///< anchor of the paragraph to read; may be empty

  // Where it is in the student's file, if it is in the code.
  int line = 0;              ///< 0: no single line
  int column = 0;            ///< in that line, from 1; 0: none
  std::string excerpt = {};  ///< that line as the student wrote it, and below it a caret; may be empty
  Fix fix = Fix::none;
  bool needs_failure = true;  ///< of a function that passes, or is not started, it is not told

  bool is_in_code() const { return kind == ReasonKind::code || kind == ReasonKind::repair; }
  bool is_cause() const { return weight == Weight::cause; }
  bool is_remark() const { return weight == Weight::remark; }
};

}  // namespace workbook
