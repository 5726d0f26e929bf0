/// @file
/// How a lecture says what is judged: its exercises, each with cases, misconceptions, terms, properties and plot.
#pragma once

#include "checker/data/kinds.hpp"
#include "checker/data/reference_results.hpp"
#include "solutions/judging/random.hpp"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace workbook::judging {

/// What an exercise of any signature offers to the lecture.
class AnyExercise {
 public:
  virtual ~AnyExercise() = default;

  /// Runs the reference solution and all wrong answers at all cases.
  /// @throws std::logic_error naming exercise and case if an expected number is not finite or has no natural scale.
  virtual ExerciseReference evaluate(std::uint64_t seed) const = 0;
};

/// Labels of a plot.
struct SweepLabels {
  std::string title;
  std::string x;
  std::string y;
};

/// The range of the plot's varying quantity.
struct SweepRange {
  double from;
  double to;
  int points = 61;
};

/// The description of one exercise with the signature Result(Parameters...).
///
/// A lambda given here must name its result type (`-> Matrix3d`): a bare Eigen expression would refer to
/// temporaries that are gone.
template <class Result, class... Parameters>
class Exercise final : public AnyExercise {
 public:
  using Inputs = std::tuple<std::remove_cvref_t<Parameters>...>;
  using Function = std::function<Result(const std::remove_cvref_t<Parameters>&...)>;
  using Scale = std::function<double(const std::remove_cvref_t<Parameters>&...)>;
  using Scales = std::function<std::vector<double>(const std::remove_cvref_t<Parameters>&...)>;

  Exercise(std::string name, Function reference) : reference_(std::move(reference)) { result_.name = std::move(name); }

  // ---- the signature in words -----------------------------------------------------------------------------------

  /// Name and unit of the next parameter, in the order of the contract.
  Exercise& argument(std::string name, Unit unit);

  /// Name of the result and its unit, or one unit per number of it (column by column).
  Exercise& result(std::string name, Unit unit) { return result(std::move(name), std::vector<Unit>{unit}); }
  Exercise& result(std::string name, std::vector<Unit> unit_of_each);

  Exercise& compare(Comparison comparison);

  /// Another tolerance than 1e-9 of the natural scale, for all cases declared so far, and why.
  Exercise& tolerance(double relative, const std::string& reason);

  /// Another tolerance for the last case declared (or the last batch of random cases), and why.
  Exercise& tolerance_of_last_case(double relative, const std::string& reason);

  /// The natural size of the result, where the largest expected number is not it (it may vanish by cancellation).
  Exercise& scale(Scale scale);

  /// The natural size of each number of the result, where they have different units or magnitudes.
  Exercise& scales(Scales scales);

  // ---- cases ----------------------------------------------------------------------------------------------------

  /// An input from the lecture.
  Exercise& worked(std::string name, std::remove_cvref_t<Parameters>... inputs);

  /// A hard or degenerate input: the right answer must be right here, wrong answers may be right too.
  Exercise& special(std::string name, std::remove_cvref_t<Parameters>... inputs);

  /// `count` generic inputs, away from every blind input.
  Exercise& random(std::string name, int count, std::function<Inputs(Random&)> draw);

  /// Takes the last case declared out of the deciding ones: it is a blind input.
  Exercise& blind();

  // ---- what is known of wrong and right answers ------------------------------------------------------------------

  /// A plausible wrong answer, the sentence that it reveals, and the anchor of the paragraph to read.
  Exercise& misconception(std::string name, std::string message, std::string notes, Function wrong);

  /// The misconception that angles are in degrees, for every parameter whose unit is the radian.
  Exercise& angles_read_as_degrees(std::string notes);

  /// One summand of the formula, without its coefficient, and the right coefficient.
  Exercise& term(std::string name, double coefficient, Function summand);

  /// What every right result has, and how the lecture says it.
  Exercise& property(PropertyKind kind, std::string message, std::string notes);

  /// The result is perpendicular to parameter number `argument` (counted from 0).
  Exercise& perpendicular_to(int argument, std::string message, std::string notes);

  /// Σ weightᵢ yᵢ² is the same in every column of the result.
  Exercise& conserves(std::string message, std::string notes, Scales weights);

  /// The right answer by another route.
  Exercise& route(std::string name, Function other);

  // ---- the plot -------------------------------------------------------------------------------------------------

  /// The result over one varying quantity, and which of its numbers to draw (at most three read well).
  Exercise& sweep(SweepLabels labels, SweepRange range, std::function<Inputs(double)> inputs_at,
                  std::vector<PlotComponent> components);

  ExerciseReference evaluate(std::uint64_t seed) const override;

 private:
  struct Batch {
    Case prototype;
    int count = 1;
    std::function<Inputs(Random&)> draw;
  };

  Function reference_;
  ExerciseReference result_;  // everything but what depends on the seed
  std::vector<Batch> batches_;
  std::vector<Function> misconceptions_;
  std::vector<Function> terms_;
  std::vector<Function> routes_;
  std::vector<Scales> weights_;  // one per property; empty where the property has none
  Scales scales_;
  std::function<Inputs(double)> sweep_inputs_;
  SweepRange sweep_range_{0, 1};
};

/// The exercises of one lecture.
class Lecture {
 public:
  /// Adds an exercise; the signature is taken from the reference solution.
  template <class Result, class... Parameters>
  Exercise<Result, Parameters...>& exercise(std::string name, Result (*reference)(Parameters...)) {
    auto added = std::make_unique<Exercise<Result, Parameters...>>(std::move(name), reference);
    auto& handle = *added;
    exercises_.push_back(std::move(added));
    return handle;
  }

  LectureReference evaluate(std::string name, std::uint64_t seed) const;

 private:
  std::vector<std::unique_ptr<AnyExercise>> exercises_;
};

/// Each lecture's judging.cpp defines this once.
void describe(Lecture& lecture);

}  // namespace workbook::judging

#include "solutions/judging/lecture_evaluation.hpp"
