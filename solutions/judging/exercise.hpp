/// @file
/// How one exercise is judged: its signature in words, cases, wrong answers, terms, properties, routes and plot.
#pragma once

#include "checker/data/kinds.hpp"
#include "solutions/judging/corners.hpp"
#include "solutions/judging/mechanics.hpp"
#include "solutions/judging/random.hpp"

#include <map>
#include <memory>
#include <string_view>
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
  constexpr Sentence(const char* says, const char* anchor = "") : text(says), notes(anchor) {}
  const char* text;
  const char* notes;
};

/// A parameter or a result.
struct Named {
  const char* name;
  Sort sort;
};

struct SweepLabels {
  const char* title;
  const char* x;
  const char* y;
  double y_unit = 1;  ///< of the labels, in that of the result
};

/// A number of the result; without a row, the one whose place in the list of components it has.
struct Drawn {
  constexpr Drawn(const char* label, int in_row = -1, int in_col = 0) : name(label), row(in_row), col(in_col) {}
  const char* name;
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
    return Doubles(values.data(), values.data() + values.size());
  }
}

/// What a lambda returns must be a value: an Eigen expression would refer to temporaries that are gone.
template <class Returned, class Wanted>
constexpr void require_value() {
  static_assert(std::is_same_v<Returned, Wanted> || (std::is_arithmetic_v<Returned> && std::is_arithmetic_v<Wanted>),
                "name the lambda's result type (-> Vector3d): an Eigen expression refers to temporaries");
}

/// A function without the type of a lambda. What captures nothing becomes a plain pointer, of which all further code is
/// compiled once.
template <class Result, class... Parameters, class F>
auto function(const F& f) {
  using Pointer = Result (*)(Parameters...);
  if constexpr (requires { static_cast<Pointer>(f); }) {
    return static_cast<Pointer>(f);
  } else {
    return std::function<Result(Parameters...)>(f);
  }
}

/// A change of a value, of a lambda that changes the one that it is given, or returns another.
template <class T, class F>
std::function<void(T&)> change_of(const F& change) {
  using Returned = decltype(change(std::declval<T&>()));
  if constexpr (std::is_void_v<Returned>) {
    return function<void, T&>(change);
  } else {
    require_value<Returned, T>();
    return [change = function<Returned, T&>(change)](T& value) { value = change(value); };
  }
}

}  // namespace detail

/// All about an exercise that does not need its types.
class AnyExercise {
 public:
  explicit AnyExercise(std::string_view name) { result_.name = name; }
  virtual ~AnyExercise() = default;

  /// The units of the numbers of a result that has several.
  void result_units(std::vector<Unit> unit_of_each) { result_.result_units = std::move(unit_of_each); }

  void compare(Comparison comparison) { result_.comparison = comparison; }

  /// Another tolerance than 1e-9 of the natural scale, for all cases declared so far, and why.
  void tolerance(double relative, std::string_view reason);

  /// A bug that no case can show, by the name that self-check gives it, and why that is right.
  void survivor(std::string_view bug, std::string_view reason);

  /// Another tolerance for the last case declared, and why.
  void tolerance_of_last_case(double relative, std::string_view reason = "");

  /// A sum of the terms, all of them declared before, with other coefficients.
  void wrong_terms(Sentence says, std::string_view name, const Doubles& coefficients);

  /// What every right result has, and how the lecture says it.
  void property(PropertyKind kind, Sentence says, int argument = -1);

  /// The result is perpendicular to parameter number `argument` (counted from 0).
  void perpendicular_to(int argument, Sentence says) { property(Is::orthogonal_to_argument, says, argument); }

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

  void set_signature(const std::vector<Named>& arguments, const std::vector<const char*>& kinds, const Named& result,
                     const char* result_kind);
  void add_batch(std::string_view name, Group group, int count, std::function<Values(Random&)> draw);
  void add_fixed(std::string_view name, Group group, Values inputs);
  void add_region(const char* words, OnValues<bool> holds);
  void add_limit(std::string_view of_case, Value expected, std::string_view reason);
  void add_wrong(Sentence says, std::string_view name, Function wrong);
  void add_term(std::string_view name, double coefficient, Function summand);
  void add_route(std::string_view name, Function other);
  void add_measured(std::string_view name, Doubles errors, Values inputs);
  void set_scale(double size);
  void set_sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
                 std::function<Values(double)> inputs_at);
  /// The same function, which evaluates each input once: some integrate for a long time, and a proof asks again and
  /// again.
  static Function remembering(Function function);
  bool is_angle(std::size_t argument) const { return result_.arguments[argument].unit == units::radian; }

  Function reference_;
  Values first_case_;
  OnValues<bool> domain_, moderate_;
  OnValues<Doubles> scale_;
  std::vector<OnValues<Doubles>> weights_;  // one per property; empty where the property has none

 private:
  struct Batch {
    Case prototype;
    int count;
    std::function<Values(Random&)> draw;
  };

  struct Foreseen {
    std::string of_case;
    Value expected;
    std::string reason;
  };

  ExerciseReference described(std::uint64_t seed) const;
  Case case_at(Case judged) const;
  bool is_legal(const Values& inputs) const;
  void add_case(const Case& one, ExerciseReference& out) const;
  void add_cases(const Batch& batch, std::uint64_t seed, ExerciseReference& out) const;
  Subject subject_of(const ExerciseReference& out) const;
  void add_sweep(ExerciseReference& out) const;
  void check_limit(const Foreseen& limit, ExerciseReference& out) const;

  ExerciseReference result_;  // everything but what depends on the seed
  std::vector<Sort> sorts_;   // of the arguments
  std::vector<Batch> batches_;
  std::vector<Foreseen> limits_;
  std::vector<OnValues<bool>> regions_;  // one per region of the result
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
  using Solution = std::function<Result(const Inputs&...)>;

  Exercise(std::string_view name, Solution solution, const std::vector<Named>& arguments, const Named& result)
      : AnyExercise(name) {
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
    domain_ = on_values<bool>(function<bool>(legal));
  }

  /// Where formulas may be others: what a reason says of wrong cases that are just those.
  template <class Predicate>
  void region(const char* words, const Predicate& holds) {
    add_region(words, on_values<bool>(function<bool>(holds)));
  }

  /// Which of the legal inputs cases are generated from, where extreme ones are beyond right answers.
  template <class Predicate>
  void generated(const Predicate& moderate) {
    moderate_ = on_values<bool>(function<bool>(moderate));
  }

  /// An input from the lecture.
  void worked(std::string_view name, const Inputs&... inputs) { add_fixed(name, Group::worked, values(inputs...)); }

  /// A hard or degenerate input: the right answer must be right here, wrong answers may be right too.
  void special(std::string_view name, const Inputs&... inputs) { add_fixed(name, Group::special, values(inputs...)); }

  /// What comes out at the special or worked case of this name, known without computing, and why: a sentence that
  /// predict shows with a right prediction. It must not be taken from the solution, which it checks.
  void limit(std::string_view of_case, const Result& expected, std::string_view reason) {
    add_limit(of_case, detail::to_value(expected), reason);
  }

  /// Real data, at which a function that passes is shown: "your function on throw 3: …".
  /// @param errors  of the numbers of the result; none where they are not known
  void measured(std::string_view name, Doubles errors, const Inputs&... inputs) {
    add_measured(name, std::move(errors), values(inputs...));
  }

  /// `count` generic inputs, away from those at which wrong answers are right. Each draw from Random makes a parameter
  /// (&Random::rotation, any::vector(2)), or a tuple of several; they are made in this order.
  template <class... Draws>
  void random(std::string_view name, int count, const Draws&... draws) {
    add_batch(name, Group::random, count, [draws...](Random& random) {
      if constexpr (sizeof...(Draws) == sizeof...(Inputs)) {
        return Values{detail::to_value<Inputs>(std::invoke(draws, random))...};
      } else {
        // std::tuple(…) leaves a tuple as it is, and makes a tuple of one of anything else.
        const std::tuple<decltype(std::tuple(std::invoke(draws, random)))...> drawn{
            std::tuple(std::invoke(draws, random))...};
        return values_of(std::apply([](const auto&... each) { return std::tuple_cat(each...); }, drawn));
      }
    });
  }

  /// The natural size of the result, where the largest expected number is not it (it may vanish by cancellation); or
  /// that of each number of it, where they have different units or magnitudes.
  template <class Size>
  void scale(const Size& size) {
    if constexpr (std::is_arithmetic_v<Size>) {
      set_scale(size);
    } else {
      scale_ = numbers(size);
    }
  }

  /// The plot: the result over one varying quantity, with a gap at points outside the domain, and which of its numbers
  /// to draw (at most three read well).
  template <class InputsAt>
  void sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
             const InputsAt& inputs_at) {
    set_sweep(labels, components, range, [inputs_at](double x) { return values_of(inputs_at(x)); });
  }

  /// The same where only input number `index` varies; the others stay as in the first case.
  template <std::size_t index, class InputAt = std::identity>
  void sweep(const SweepLabels& labels, const std::vector<Drawn>& components, SweepRange range,
             const InputAt& input_at = {}) {
    set_sweep(labels, components, range, [first = first_case_, input_at](double x) {
      Values inputs = first;
      inputs.at(index) = detail::to_value<Input<index>>(input_at(x));
      return inputs;
    });
  }

  // ---- what is known of wrong and right answers ------------------------------------------------------------------

  /// A plausible wrong answer, and the sentence that it reveals.
  template <class Wrong>
  void wrong(Sentence says, std::string_view name, const Wrong& wrong) {
    add_wrong(says, name, on_values<Value>(result(wrong)));
  }

  /// The right answer to a question with other inputs; `change` takes all of them and changes what it likes.
  template <class Change>
  void wrong_inputs(Sentence says, std::string_view name, const Change& change) {
    changed_inputs(says, name, detail::function<void, Inputs&...>(change));
  }

  /// The right answer to a question with another input number `index`.
  template <std::size_t index, class Change>
  void wrong_input(Sentence says, std::string_view name, const Change& change) {
    changed_input<index>(says, name, detail::change_of<Input<index>>(change));
  }

  /// The right answer, spoilt afterwards; `change` takes the result, and the inputs too if it wants them.
  template <class Change>
  void wrong_output(Sentence says, std::string_view name, const Change& change) {
    if constexpr (requires { change(std::declval<Result&>()); }) {
      changed_output(says, name, detail::change_of<Result>(change));
    } else if constexpr (std::is_void_v<decltype(change(std::declval<Result&>(), std::declval<const Inputs&>()...))>) {
      changed_output(says, name, detail::function<void, Result&, const Inputs&...>(change));
    } else {
      wrong(says, name, [right = right_, change](const Inputs&... inputs) {
        Result result = right(inputs...);
        return change(result, inputs...);
      });
    }
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
  void term(std::string_view name, double coefficient, const Summand& summand) {
    add_term(name, coefficient, on_values<Value>(result(summand)));
  }

  /// Σ weightᵢ yᵢ² is the same in every column of the result.
  template <class Weights>
  void conserves(Sentence says, const Weights& weights) {
    property(Is::constant_weighted_square, says);
    weights_.back() = numbers(weights);
  }

  /// The right answer by another route.
  template <class Route>
  void route(std::string_view name, const Route& other) {
    add_route(name, on_values<Value>(result(other)));
  }

 private:
  template <std::size_t index>
  using Input = std::tuple_element_t<index, std::tuple<Inputs...>>;

  static Values values(const Inputs&... inputs) { return {detail::to_value(inputs)...}; }
  static Values values_of(const std::tuple<Inputs...>& inputs) { return std::apply(values, inputs); }

  template <class To, class F>
  static auto function(const F& f) {
    return detail::function<To, const Inputs&...>(f);
  }

  /// A function with the contract's types.
  template <class F>
  static auto result(const F& f) {
    detail::require_value<decltype(f(std::declval<const Inputs&>()...)), Result>();
    return function<Result>(f);
  }

  template <class F>
  static OnValues<Doubles> numbers(const F& f) {
    return on_values<Doubles>(function<decltype(f(std::declval<const Inputs&>()...))>(f));
  }

  template <class To, class F>
  static OnValues<To> on_values(F f) {
    return [f = std::move(f)](const Values& inputs) { return at<To>(f, inputs, std::index_sequence_for<Inputs...>{}); };
  }

  template <class To, class F, std::size_t... index>
  static To at(const F& f, const Values& inputs, std::index_sequence<index...>) {
    if constexpr (std::is_same_v<To, Value>) {
      return detail::to_value<Result>(f(detail::from_value<Inputs>(inputs[index])...));
    } else if constexpr (std::is_same_v<To, Doubles>) {
      return detail::doubles(f(detail::from_value<Inputs>(inputs[index])...));
    } else {
      return f(detail::from_value<Inputs>(inputs[index])...);
    }
  }

  void changed_inputs(Sentence says, std::string_view name, std::function<void(Inputs&...)> change) {
    wrong(says, name, [right = right_, change = std::move(change)](Inputs... inputs) -> Result {
      change(inputs...);
      return right(inputs...);
    });
  }

  template <std::size_t index>
  void changed_input(Sentence says, std::string_view name, std::function<void(Input<index>&)> change) {
    changed_inputs(says, name,
                   [change = std::move(change)](Inputs&... inputs) { change(std::get<index>(std::tie(inputs...))); });
  }

  void changed_output(Sentence says, std::string_view name, std::function<void(Result&)> change) {
    wrong(says, name, [right = right_, change = std::move(change)](const Inputs&... inputs) {
      Result result = right(inputs...);
      change(result);
      return result;
    });
  }

  void changed_output(Sentence says, std::string_view name, std::function<void(Result&, const Inputs&...)> change) {
    wrong(says, name, [right = right_, change = std::move(change)](const Inputs&... inputs) {
      Result result = right(inputs...);
      change(result, inputs...);
      return result;
    });
  }

  Solution right_;
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
    auto* added = new Exercise<Result, std::remove_cvref_t<Parameters>...>(name_, solution, arguments, result);
    exercises_.push_back(std::unique_ptr<AnyExercise>(added));
    return *added;
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
