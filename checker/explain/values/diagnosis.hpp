/// @file
/// Why an answer is wrong, as far as its values tell. Each mechanism is a pure function, and silent when it is not
/// sure.
#pragma once

#include "checker/data/reason.hpp"
#include "checker/judging/comparison.hpp"

#include <set>

namespace workbook {

/// The most telling of the diagnoses. A misconception that gives the student's answers explains them wholly, and so
/// does a wrong coefficient or a transform of the whole: then it stands alone. Otherwise: what properties tell. Empty
/// where nothing certain can be said.
std::vector<Reason> diagnose(const ExerciseReference& exercise, const Answers& answers);

/// Looks for one kind of reason.
using Mechanism = std::optional<Reason>(const ExerciseReference& exercise, const Answers& answers);

// --- recognising a whole answer at all deciding cases (whole_answer.cpp)

Mechanism diagnose_misconception;    ///< none if two with different messages fit
Mechanism diagnose_transform;        ///< a common factor, a transposed matrix, or components in another order
Mechanism diagnose_input_transform;  ///< the right result for changed inputs
Mechanism diagnose_places;           ///< right numbers that stand elsewhere
Mechanism diagnose_whole_turns;      ///< angles that differ by multiples of 2π or π
Mechanism diagnose_signs;            ///< of some numbers, at some cases, of the right result or of a misconception
Mechanism diagnose_wrong_part;       ///< a misconception, or changed inputs, in the wrong components alone, or two
Mechanism diagnose_some_part;        ///< in some of the wrong components
Mechanism diagnose_both_mistakes;    ///< two of these, by what each adds or by its factor

// --- by what a wrong component differs (regression.cpp)

/// The right result, or some of its components, times one number, or powers of the inputs. (factors.cpp)
Mechanism diagnose_number;
Mechanism diagnose_factor;

/// The error of every wrong component as exactly one product of the inputs with a simple coefficient.
Mechanism diagnose_one_term;

/// As exactly one or two of them; or the error of its square, or of one over it or its square, as one.
Mechanism diagnose_difference;

/// What explains one wrong number of several by itself. (entries.cpp)
Mechanism diagnose_one_entry;

/// "1", "−2/3", "√2", "4·π"; empty for what no formula is likely to have. (factors.cpp)
std::string simple_number(double number);

// --- where it is wrong, and on what it depends (patterns.cpp)

Mechanism diagnose_place;         ///< "Only component 3 is wrong": always true, and silent where all are
Mechanism diagnose_eigenvectors;  ///< principal axes in another order, of another length or handedness
Mechanism diagnose_accuracy;      ///< nearly right at every case; the digits where the error follows a law
Mechanism diagnose_mostly_near;   ///< nearly right at most cases, and on which side
Mechanism diagnose_along;         ///< a vector that is wrong only along one of the inputs
Mechanism diagnose_no_effect;     ///< arguments that alone never change the answer, but the right result
Mechanism diagnose_range;  ///< the right attitudes by numbers beyond their range: θ, the pitch, more than half a turn

// --- what the failing cases have in common (splits.cpp)

/// The cases with an answer, and whether it is right there.
struct Outcomes {
  std::vector<std::size_t> right;
  std::vector<std::size_t> wrong;
};
Outcomes outcomes_of(const ExerciseReference& exercise, const Answers& answers);

/// The feature of the inputs (a sign, a zero, an equality, an order, a count) that tells wrong cases from right ones.
Mechanism diagnose_split;
Mechanism diagnose_threshold;    ///< the size beyond which all is wrong, and below which all is right
Mechanism diagnose_one_side;     ///< the feature with which all is right, and without which almost all is wrong
Mechanism diagnose_kinds;        ///< the kinds of cases that are all wrong, by their names
Mechanism diagnose_conditional;  ///< the one misconception, or change of the right result, that fits all failing cases

// --- wrong coefficients (terms.cpp)

/// Where the student's answers are exactly a sum of the terms. Silent where the whole answer is a multiple of the right
/// one, which is better said of the whole.
Mechanism diagnose_terms;

/// The terms as columns and the given values as a vector, one row per number of every deciding case, each divided by
/// its natural size.
struct TermEquations {
  Eigen::MatrixXd terms;
  Eigen::VectorXd values;
  double tolerance = 0.0;  ///< the widest of the cases

  /// True if there are clearly more equations than terms, and no term is a combination of the others.
  bool determine_coefficients() const;
};
/// @pre every deciding case has a value.
TermEquations term_equations(const ExerciseReference& exercise, const Answers& values);

// --- properties (properties.cpp)

/// How far a value is from having a property.
struct Violation {
  double size = 0.0;   ///< relative to the natural size of the result; 0 if the value has the property
  std::string detail;  ///< where it shows: "entry (1,2) is 3, entry (2,1) is -3"
};
Violation violation(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                    const Value& value);

/// True if the value lacks the property by clearly more than the tolerance of its case.
bool clearly_lacks(const ExerciseReference& exercise, const Property& property, std::size_t case_index,
                   const Value& value);

/// One diagnosis for each property that all expected values have and a student's value at some deciding case clearly
/// lacks.
std::vector<Reason> diagnose_properties(const ExerciseReference& exercise, const Answers& answers);

// --- the inputs as named numbers: what formulas are made of (quantities.cpp)

/// One number of the inputs, at every case.
struct Quantity {
  std::string name;  ///< "omega[1]", "I(0,2)", "theta": as one types it
  Unit unit;
  std::size_t argument = 0;
  std::size_t entry = 0;
  std::vector<double> values;  ///< per case

  bool is_angle() const { return unit == units::radian; }
};

/// All numbers of arguments of fixed size. Of matrices that are symmetric at every case the upper triangle stands for
/// both.
std::vector<Quantity> quantities_of(const ExerciseReference& exercise);

/// The numbers of the result that are wrong at some case; empty where entries are not compared one by one or the shape
/// differs from case to case. (patterns.cpp)
std::set<std::size_t> wrong_entries(const ExerciseReference& exercise, const Answers& answers);

/// How the entry of a value of that kind is typed after its name: "[1]", "(0,2)", "".
std::string entry_suffix(Kind kind, std::size_t entry);

}  // namespace workbook
