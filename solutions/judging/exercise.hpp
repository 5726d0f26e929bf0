/// @file
/// How one exercise is judged: its signature in words, cases, wrong answers, terms, properties, routes and plot.
#pragma once

#include "checker/data/kinds.hpp"
#include "solutions/judging/corners.hpp"
#include "solutions/judging/mechanics.hpp"
#include "solutions/judging/random.hpp"

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace workbook::judging {

using enum Comparison;
using Is = PropertyKind;  // e.property(Is::symmetric, "…")
using Doubles = std::vector<double>;

/// A function of the inputs that no longer shows their types.
template <class Result>
using OnValues = std::function<Result(const Values&)>;

/// What a student reads, and the anchor of the paragraph to read next where it is not the one on the exercise's card.
struct Sentence {
  Sentence(const char* says, const char* anchor = "") : text(says), notes(anchor) {}
  std::string text;
  std::string notes;
};

/// A parameter or a result.
struct Named {
  std::string name;
  Sort sort;
};

struct SweepLabels {
  std::string title;
  std::string x;
  std::string y;
  double y_unit = 1;  ///< of the labels, in that of the result
};

/// A number of the result; without a row, the one whose place in the list of components it has.
struct Drawn {
  Drawn(const char* label, int in_row = -1, int in_col = 0) : name(label), row(in_row), col(in_col) {}
  std::string name;
  int row;
  int col;
};

struct SweepRange {
  double from;
  double to;
  int points = 61;
};

namespace detail {

template <class T>
Value to_value(const T& typed);
template <class T>
T from_value(const Value& value);

/// A number, or the entries of a vector.
template <class T>
Doubles doubles(const T& values) {
  if constexpr (std::is_arithmetic_v<T>) {
    return {static_cast<double>(values)};
  } else {
    return Doubles(values.begin(), values.end());
  }
}

/// What a lambda returns must be a value: an Eigen expression would refer to temporaries that are gone.
template <class Returned, class Wanted>
constexpr void require_value() {
  static_assert(std::is_same_v<Returned, Wanted> || (std::is_arithmetic_v<Returned> && std::is_arithmetic_v<Wanted>),
                "name the lambda's result type (-> Vector3d): an Eigen expression refers to temporaries");
}

/// Lets `change` return another value, or change the one that it is given.
template <class Change, class T, class... Others>
void apply_change(const Change& change, T& value, const Others&... others) {
  using Returned = std::invoke_result_t<const Change&, T&, const Others&...>;
  if constexpr (std::is_void_v<Returned>) {
    change(value, others...);
  } else {
    require_value<Returned, T>();
    value = change(value, others...);
  }
}

}  // namespace detail

/// All about an exercise that does not need its types.
class AnyExercise {
 public:
  explicit AnyExercise(std::string name) { result_.name = std::move(name); }
  virtual ~AnyExercise() = default;

  /// The units of the numbers of a result that has several.
  void result_units(std::vector<Unit> unit_of_each) { result_.result_units = std::move(unit_of_each); }

  void compare(Comparison comparison) { result_.comparison = comparison; }

  /// Another tolerance than 1e-9 of the natural scale, for all cases declared so far, and why.
  void tolerance(double relative, const std::string& reason);

  /// A bug that no case can show, by the name that self-check gives it, and why that is right.
  void survivor(const std::string& bug, const std::string& reason) { result_.survivor_reasons[bug] = reason; }

  /// Another tolerance for the last case declared, and why.
  void tolerance_of_last_case(double relative, const std::string& reason = "");

  /// A sum of the terms, all of them declared before, with other coefficients.
  void wrong_terms(Sentence says, std::string name, const Doubles& coefficients);

  /// What every right result has, and how the lecture says it.
  void property(PropertyKind kind, Sentence says, int argument = -1);

  /// The result is perpendicular to parameter number `argument` (counted from 0).
  void perpendicular_to(int argument, Sentence says) {
    property(Is::orthogonal_to_argument, std::move(says), argument);
  }

  /// The result is symmetric and has no negative eigenvalue.
  void is_inertia_tensor(const char* symmetry_notes = "", const char* energy_notes = "");

  /// Runs the reference solution and all wrong answers at all cases: the described ones, the generated ones, and those
  /// that this record of typical bugs asks for.
  /// @throws std::logic_error naming exercise and case if an input is not legal, or an expected number is not finite or
  /// has no natural scale.
  /// @param others  the functions of the lecture, whose results may be taken for this one's
  ExerciseReference evaluate(std::uint64_t seed, const Adequacy& recorded, const std::vector<Subject>& others) const;
  /// Without cases.
  Subject subject() const { return subject_of(result_); }
  /// The same at the random cases alone, which takes a moment.
  ExerciseReference random_cases(std::uint64_t seed) const;
  /// Which typical bugs the cases find, and which points must join those of this record so that they are found under
  /// each of these seeds. Takes up to minutes.
  Adequacy prove(std::uint64_t seeds, Adequacy record) const;
  const std::string& name() const { return result_.name; }

 protected:
  using Function = OnValues<Value>;

  void set_signature(const std::vector<Named>& arguments, const std::vector<std::string>& kinds, const Named& result,
                     const std::string& result_kind);
  void add_batch(std::string name, Group group, int count, std::function<Values(Random&)> draw);
  void add_wrong(Sentence says, std::string name, Function wrong);
  void add_term(std::string name, double coefficient, Function summand);
  void add_route(std::string name, Function other);
  void add_measured(Measured real);
  void set_sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
                 std::function<Values(double)> inputs_at);
  /// The same function, which evaluates each input once: some integrate for a long time, and a proof asks again and
  /// again.
  static Function remembering(Function function);
  bool is_angle(std::size_t argument) const { return result_.arguments[argument].unit == units::radian; }

  struct Foreseen {
    std::string of_case;
    Value expected;
    std::string reason;
  };

  std::vector<Foreseen> limits_;
  Function reference_;
  OnValues<bool> domain_, moderate_;
  OnValues<Doubles> scale_;
  std::vector<OnValues<Doubles>> weights_;  // one per property; empty where the property has none

 private:
  struct Batch {
    Case prototype;
    int count;
    std::function<Values(Random&)> draw;
  };

  ExerciseReference described(std::uint64_t seed) const;
  Case case_at(Case judged) const;
  bool is_legal(const Values& inputs) const;
  void add_case(const Case& one, ExerciseReference& out) const;
  void add_cases(const Batch& batch, std::uint64_t seed, ExerciseReference& out) const;
  Subject subject_of(const ExerciseReference& out) const;
  void add_sweep(ExerciseReference& out) const;
  void add_limit(const Foreseen& limit, ExerciseReference& out) const;

  ExerciseReference result_;  // everything but what depends on the seed
  std::vector<Sort> sorts_;   // of the arguments
  std::vector<Batch> batches_;
  std::vector<Function> misconceptions_, terms_, routes_;
  std::function<Values(double)> sweep_inputs_;
  SweepRange sweep_range_{0, 1};
};

/// The description of one exercise whose function is Result(const Inputs&...).
///
/// The lambdas given here take their parameters as `auto&` (numbers as `auto`).
template <class Result, class... Inputs>
class Exercise : public AnyExercise {
 public:
  using Tuple = std::tuple<Inputs...>;
  using Solution = std::function<Result(const Inputs&...)>;

  Exercise(std::string name, Solution solution, const std::vector<Named>& arguments, const Named& result)
      : AnyExercise(std::move(name)) {
    set_signature(arguments, {KindOf<Inputs>::name...}, result, KindOf<Result>::name);
    judge_by(std::move(solution));
  }

  // ---- inputs ---------------------------------------------------------------------------------------------------

  /// Takes the expected results from another function than the solution.
  void judge_by(Solution reference) {
    right_ = std::move(reference);
    reference_ = remembering(on_values<Value>(right_));
  }

  /// Which inputs are legal, where the sorts of the single parameters do not say it. Anyway each number is
  /// finite, and zero or of ordinary size.
  template <class Predicate>
  void domain(const Predicate& legal) {
    domain_ = on_values<bool>(legal);
  }

  /// Which of the legal inputs cases are generated from, where extreme ones are beyond right answers.
  template <class Predicate>
  void generated(const Predicate& moderate) {
    moderate_ = on_values<bool>(moderate);
  }

  /// An input from the lecture.
  void worked(std::string name, const Inputs&... inputs) { fixed_case(std::move(name), Group::worked, inputs...); }

  /// A hard or degenerate input: the right answer must be right here, wrong answers may be right too.
  void special(std::string name, const Inputs&... inputs) { fixed_case(std::move(name), Group::special, inputs...); }

  /// What comes out at the special or worked case of this name, known without computing, and why: a sentence that
  /// predict shows with a right prediction. It must not be taken from the solution, which it checks.
  void limit(std::string of_case, const Result& expected, std::string reason) {
    limits_.push_back({std::move(of_case), detail::to_value(expected), std::move(reason)});
  }

  /// Real data, at which a function that passes is shown: "your function on throw 3: …".
  /// @param errors  of the numbers of the result; none where they are not known
  void measured(std::string name, Doubles errors, const Inputs&... inputs) {
    add_measured({std::move(name), values(Tuple(inputs...)), std::move(errors)});
  }

  /// `count` generic inputs, away from those at which wrong answers are right. Each draw from Random makes a parameter
  /// (&Random::rotation, any::vector(2)), or a tuple of several; they are made in this order.
  template <class... Draws>
  void random(std::string name, int count, const Draws&... draws) {
    add_batch(std::move(name), Group::random, count, [draws...](Random& random) {
      // std::tuple(…) leaves a tuple as it is, and makes a tuple of one of anything else.
      const std::tuple<decltype(std::tuple(std::invoke(draws, random)))...> drawn{
          std::tuple(std::invoke(draws, random))...};
      return values(Tuple(std::apply([](const auto&... each) { return std::tuple_cat(each...); }, drawn)));
    });
  }

  /// The natural size of the result, where the largest expected number is not it (it may vanish by cancellation); or
  /// that of each number of it, where they have different units or magnitudes.
  template <class Size>
  void scale(const Size& size) {
    if constexpr (std::is_arithmetic_v<Size>) {
      scale_ = [size](const Values&) { return detail::doubles(size); };
    } else {
      scale_ = on_values<Doubles>([size](const Inputs&... inputs) { return detail::doubles(size(inputs...)); });
    }
  }

  /// The plot: the result over one varying quantity, with a gap at points outside the domain, and which of its numbers
  /// to draw (at most three read well).
  template <class InputsAt>
  void sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
             const InputsAt& inputs_at) {
    set_sweep(labels, components, range, [inputs_at](double x) { return values(Tuple(inputs_at(x))); });
  }

  /// The same where only input number `index` varies; the others stay as in the first case.
  template <std::size_t index, class InputAt = std::identity>
  void sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
             const InputAt& input_at = {}) {
    sweep(labels, components, range, [first = first_case_.value(), input_at](double x) {
      Tuple inputs = first;
      std::get<index>(inputs) = input_at(x);
      return inputs;
    });
  }

  // ---- what is known of wrong and right answers ------------------------------------------------------------------

  /// A plausible wrong answer, and the sentence that it reveals.
  template <class Wrong>
  void wrong(Sentence says, std::string name, const Wrong& wrong) {
    add_wrong(std::move(says), std::move(name), on_values<Value>(function(wrong)));
  }

  /// The right answer to a question with other inputs; `change` takes all of them and changes what it likes.
  template <class Change>
  void wrong_inputs(Sentence says, std::string name, Change change) {
    wrong(std::move(says), std::move(name), [right = right_, change](const Inputs&... inputs) -> Result {
      Tuple changed(inputs...);
      std::apply(change, changed);
      return std::apply(right, changed);
    });
  }

  /// The right answer to a question with another input number `index`.
  template <std::size_t index, class Change>
  void wrong_input(Sentence says, std::string name, Change change) {
    wrong_inputs(std::move(says), std::move(name),
                 [change](Inputs&... inputs) { detail::apply_change(change, std::get<index>(std::tie(inputs...))); });
  }

  /// The right answer, spoilt afterwards; `change` takes the result, and the inputs too if it wants them.
  template <class Change>
  void wrong_output(Sentence says, std::string name, Change change) {
    wrong(std::move(says), std::move(name), [right = right_, change](const Inputs&... inputs) -> Result {
      Result result = right(inputs...);
      if constexpr (std::is_invocable_v<const Change&, Result&>) {
        detail::apply_change(change, result);
      } else {
        detail::apply_change(change, result, inputs...);
      }
      return result;
    });
  }

  /// The right answer to a question whose angles are in degrees.
  void angles_read_as_degrees(const char* notes = "") {
    const Sentence says{"This comes out when the angles, which come in radians, are converted from degrees.", notes};
    wrong_inputs(says, "degrees", [this](Inputs&... inputs) {
      std::size_t index = 0;
      ((is_angle(index++) ? void(inputs *= degree) : void()), ...);
    });
  }

  /// One summand of the formula, without its coefficient, and the right coefficient.
  template <class Summand>
  void term(std::string name, double coefficient, const Summand& summand) {
    add_term(std::move(name), coefficient, on_values<Value>(function(summand)));
  }

  /// Σ weightᵢ yᵢ² is the same in every column of the result.
  template <class Weights>
  void conserves(Sentence says, const Weights& weights) {
    property(Is::constant_weighted_square, std::move(says));
    weights_.back() =
        on_values<Doubles>([weights](const Inputs&... inputs) { return detail::doubles(weights(inputs...)); });
  }

  /// The right answer by another route.
  template <class Route>
  void route(std::string name, const Route& other) {
    add_route(std::move(name), on_values<Value>(function(other)));
  }

 private:
  using Pointer = Result (*)(const Inputs&...);

  static Values values(const Tuple& inputs) {
    return std::apply([](const auto&... each) { return Values{detail::to_value(each)...}; }, inputs);
  }

  /// A function with the contract's types. What captures nothing becomes a plain pointer, which costs no instantiation.
  template <class F>
  static Solution function(const F& f) {
    detail::require_value<std::invoke_result_t<const F&, const Inputs&...>, Result>();
    if constexpr (std::is_convertible_v<F, Pointer>) {
      return static_cast<Pointer>(f);
    } else {
      return f;
    }
  }

  template <class To, class F>
  static OnValues<To> on_values(const F& f) {
    return [f](const Values& inputs) {
      auto input = inputs.begin();
      const Tuple typed{detail::from_value<Inputs>(*input++)...};
      if constexpr (std::is_same_v<To, Value>) {
        return detail::to_value<Result>(std::apply(f, typed));
      } else {
        return std::apply(f, typed);
      }
    };
  }

  void fixed_case(std::string name, Group group, const Inputs&... inputs) {
    if (!first_case_) first_case_ = Tuple(inputs...);
    add_batch(std::move(name), group, 1, [fixed = values(Tuple(inputs...))](Random&) { return fixed; });
  }

  Solution right_;
  std::optional<Tuple> first_case_;
};

/// The exercises of one lecture.
class Lecture {
 public:
  /// Lets `judge` describe the exercise of this name.
  void add(const char* name, void (*judge)(Lecture&)) {
    name_ = name;
    judge(*this);
  }

  /// Adds that exercise with its solution, the names and sorts of its parameters in the order of the contract, and of
  /// its result.
  template <class Result, class... Parameters>
  auto& exercise(Result (*solution)(Parameters...), const std::vector<Named>& arguments, const Named& result) {
    using Added = Exercise<Result, std::remove_cvref_t<Parameters>...>;
    auto added = std::make_unique<Added>(name_, solution, arguments, result);
    Added& handle = *added;
    exercises_.push_back(std::move(added));
    return handle;
  }

  LectureReference evaluate(std::string name, std::uint64_t seed,
                            const std::map<std::string, Adequacy>& recorded) const;
  LectureReference random_cases(std::string name, std::uint64_t seed) const;
  /// @throws std::logic_error if there is no such exercise
  Adequacy prove(const std::string& exercise, std::uint64_t seeds,
                 const std::map<std::string, Adequacy>& recorded) const;

 private:
  std::string name_;
  std::vector<std::unique_ptr<AnyExercise>> exercises_;
};

/// Describes all exercises of a lecture. CMake makes it: it adds `void judge_NAME(Lecture&)` of every judging/NAME.cpp.
void describe(Lecture& lecture);

}  // namespace workbook::judging
