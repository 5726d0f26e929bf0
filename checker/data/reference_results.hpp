/// @file
/// Reference results: all that the checker knows about an exercise. One JSON file per lecture.
#pragma once

#include "checker/data/unit.hpp"
#include "checker/data/value.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>

namespace workbook {

/// Where a case comes from. A special case is a hard or degenerate input at which wrong answers may be right. Generated
/// ones come last; they carry inputs and expected values only.
enum class Group { worked, special, random, generated };

enum class Comparison {
  plain,                       ///< entry by entry
  up_to_sign,                  ///< the whole value or its negative (quaternions)
  eigenvectors,                ///< columns V of the first argument I: I V = V D, Vᵀ V = 1, det V = +1
  attitude_by_angles,          ///< z–y–z Euler angles, θ in [0, π], through the rotation matrix
  attitude_by_yaw_pitch_roll,  ///< z–y–x angles, the pitch within ±π/2, through the rotation matrix
  rotation_by_vector,          ///< axis times angle, through the rotation matrix; the angle at most half a turn
};

struct Argument {
  std::string name;
  Kind kind = Kind::number;
  Unit unit;
};

/// One input at which an exercise is judged.
struct Case {
  std::string name;
  Group group = Group::random;
  bool deciding = true;  ///< false where wrong answers are allowed to be right (the blind inputs)
  std::vector<Value> inputs;
  Value expected;
  std::vector<double> scale;  ///< natural size of the result: one number for all, or one per number of the result
  double tolerance = 1e-9;    ///< relative to the scale
  double condition = 0;       ///< how far the result moves, in tolerances, when every input is rounded; 0: not asked

  // A generated case that differs from another one in one number or one argument only:
  int base = -1;      ///< the other case
  int argument = -1;  ///< which argument
  int entry = -1;     ///< which of its numbers; -1: all of it
};

/// A named, plausible wrong answer.
struct Misconception {
  std::string name;
  std::string message;               ///< one sentence in the language of the lecture; equal answers share one message
  std::string notes;                 ///< anchor of the paragraph to read
  std::vector<Value> outputs;        ///< per case that is not generated
  std::vector<Value> sweep_outputs;  ///< per point of the sweep
};

/// The right result for changed inputs: "ψ = 0", "the transposed A".
struct InputTransform {
  std::string name;            ///< "psi_zero"; "of_NAME" for what another function of the lecture gives
  std::string message;         ///< to follow "yours is the right result for"
  std::vector<Value> outputs;  ///< per case that is not generated
};

/// One summand of the formula.
struct Term {
  std::string name;
  double coefficient = 1.0;    ///< the right one
  std::vector<Value> outputs;  ///< per case that is not generated
};

/// What every right result has.
enum class PropertyKind {
  symmetric,                 ///< matrix = its transpose
  antisymmetric,             ///< matrix = −its transpose
  positive_semidefinite,     ///< no negative eigenvalue of the symmetric part
  rotation_matrix,           ///< orthonormal columns and determinant +1
  unit_norm,                 ///< a vector of length 1
  ascending,                 ///< entries do not decrease
  nonnegative,               ///< no entry below zero
  orthogonal_to_argument,    ///< result · argument = 0
  constant_weighted_square,  ///< Σ weightᵢ yᵢ² is the same in every column, and the same as expected
};

std::string to_string(PropertyKind kind);

struct Property {
  PropertyKind kind = PropertyKind::symmetric;
  std::string message;  ///< what it means in the lecture: "an inertia tensor is symmetric: I_xy = I_yx"
  std::string notes;
  int argument = -1;                         ///< for orthogonal_to_argument: which one
  std::vector<std::vector<double>> weights;  ///< for constant_weighted_square: per case, one weight per row
};

/// A right answer by another route; self-check demands that it passes without a diagnosis.
struct Route {
  std::string name;
  std::vector<Value> outputs;  ///< per case that is not generated
};

/// One component of the result in the plot.
struct PlotComponent {
  std::string name;  ///< "I_xx"
  int row = 0;
  int col = 0;
};

/// How the exercise is plotted: the result over one varying quantity. Where points of the even spacing are left out,
/// the curve has a gap.
struct Sweep {
  std::string title;
  std::string x_label;  ///< with unit
  std::string y_label;  ///< with unit
  std::vector<double> x;
  std::vector<std::vector<Value>> inputs;
  std::vector<Value> expected;
  std::vector<PlotComponent> components;
  double y_unit = 1;  ///< what is drawn is the result divided by it
};

/// A case whose result is known before anything is computed: predict asks for it first.
struct Limit {
  std::size_t case_index = 0;
  std::string reason;  ///< why the result is what it is, in one sentence
};

/// A part of the inputs at which formulas may be others, in the words of the lecture.
struct Region {
  std::string words;        ///< to follow "where": "omega0 goes round the axis of the smallest moment"
  std::vector<bool> holds;  ///< per case, then per point of the sweep
};

/// Real data: what a function that passes makes of it is told beside its verdict. Its result is not judged.
struct Measured {
  std::string name;  ///< "throw 3 of the racket"
  std::vector<Value> inputs;
  std::vector<double> errors;  ///< standard errors of the numbers of the result; empty where none are known
};

/// What a proof found with typical bugs made in the reference solution of an exercise: a threshold, a missing sign,
/// float for double. It takes minutes, so its result is recorded beside the judging (judging/adequacy.json) and used
/// from there.
struct Adequacy {
  std::size_t made = 0;
  std::size_t killed = 0;               ///< fail at some case
  std::size_t equal = 0;                ///< agree with the reference all over the domain
  std::vector<std::string> survivors;   ///< differ somewhere in the domain where no case can be made of it
  std::vector<std::string> neighbours;  ///< the points of the dense sample that must be cases, by name
  std::string fingerprint;              ///< of all this and of what was judged when it was recorded
};

struct ExerciseReference {
  std::string name;
  std::string signature;  ///< as the contract declares it
  std::vector<Argument> arguments;
  Kind result_kind = Kind::number;
  std::string result_name;
  std::vector<Unit> result_units;  ///< one for all, or one per number of the result
  Comparison comparison = Comparison::plain;
  std::string tolerance_reason;  ///< where the tolerance is wider than usual: why
  std::vector<Case> cases;
  std::vector<Misconception> misconceptions;
  std::vector<InputTransform> input_transforms;
  std::vector<Term> terms;
  std::vector<Property> properties;
  std::vector<Route> routes;
  Sweep sweep;
  std::vector<Limit> limits;
  std::vector<Region> regions;
  std::vector<Measured> measured;
  Adequacy adequacy;
  bool has_current_adequacy = true;  ///< false where the record was made for other cases, or there is none
  std::map<std::string, std::string> survivor_reasons;  ///< why no case can show bugs whose names contain this

  /// Why no case can show this bug; empty where its author gave no reason.
  std::string survivor_reason(const std::string& bug) const;
  /// How many cases come before the generated ones.
  std::size_t described_cases() const;
};

struct LectureReference {
  static constexpr int format = 9;  ///< of the file
  std::uint64_t seed = 1;
  std::string lecture;
  std::vector<ExerciseReference> exercises;
  /// @throws ReferenceError if the lecture has no such exercise.
  const ExerciseReference& exercise(const std::string& name) const;
};

/// The reference results cannot be used: file, place and reason in one sentence. Never the student's fault.
struct ReferenceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Lines of JSON: the format and a checksum of the next line; lecture, seed, and of each exercise the name and the
/// checksum of its line; one line per exercise.
/// @param only the exercise to read, for a check needs one of a lecture only; empty for all.
/// @throws ReferenceError if the file is missing, damaged, of another format, or inconsistent.
LectureReference read_reference_results(const std::filesystem::path& file, const std::string& only = "");

/// Which seed such a file was made with, from its first lines alone; 1 where that cannot be read.
std::uint64_t seed_of_reference_results(const std::filesystem::path& file);

/// @throws ReferenceError if the results are inconsistent or the file cannot be written.
void write_reference_results(const LectureReference& results, const std::filesystem::path& file);

/// The record of a lecture by the names of its exercises; empty where there is no such file.
/// @throws ReferenceError if the file cannot be read or has another format
std::map<std::string, Adequacy> read_adequacy(const std::filesystem::path& file);
/// @throws ReferenceError naming the file if it cannot be written
void write_adequacy(const std::map<std::string, Adequacy>& record, const std::filesystem::path& file);

}  // namespace workbook
