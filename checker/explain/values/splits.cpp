// What the cases have in common at which an answer is wrong.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace workbook {

namespace {

using Matrix = Eigen::MatrixXd;

constexpr double same = 1e-12;  // relative, of numbers that are meant to be equal

bool is_same_input(double one, double other) {
  return std::abs(one - other) <= same * std::max(std::abs(one), std::abs(other));
}

/// Something that is so at some cases.
struct Feature {
  std::string words;        ///< to follow "wrong exactly where": "theta < 0"
  std::vector<bool> holds;  ///< per case
  bool tells_right = true;  ///< may also follow "right where"
};

/// All features that may decide.
class Features {
 public:
  explicit Features(const ExerciseReference& exercise) : exercise_(exercise), quantities_(quantities_of(exercise)) {
    // Single entries of a matrix decide next to nothing, and agree by accident.
    std::erase_if(quantities_,
                  [&](const Quantity& each) { return exercise.arguments[each.argument].kind == Kind::matrix3; });
  }

  std::vector<Feature> all() {
    for (std::size_t a = 0; a < exercise_.arguments.size(); ++a) {
      of_argument(a);
      if (exercise_.arguments[a].kind == Kind::matrix3) of_matrix(a);
    }
    for (const Quantity& each : quantities_) of_quantity(each);
    of_pairs();
    of_groups();
    of_two_vectors();
    for (const Region& each : exercise_.regions) found_.push_back({each.words, each.holds});
    return std::move(found_);
  }

 private:
  void add(std::string words, const std::function<bool(std::size_t)>& test) {
    Feature feature{std::move(words), {}};
    for (std::size_t i = 0; i < exercise_.cases.size(); ++i) feature.holds.push_back(test(i));
    found_.push_back(std::move(feature));
  }

  Eigen::Map<const Matrix> input(std::size_t i, std::size_t a) const { return as_matrix(exercise_.cases[i].inputs[a]); }

  void of_quantity(const Quantity& q) {
    const auto test = [&](const std::string& words, const std::function<bool(double)>& holds) {
      add(words, [&](std::size_t i) { return holds(q.values[i]); });
    };
    if (exercise_.arguments[q.argument].kind == Kind::integer) {
      for (const int number : {0, 1, 2})
        test(fmt::format("{} = {}", q.name, number), [number](double value) { return value == number; });
      return;
    }
    test(q.name + " = 0", [](double value) { return value == 0; });
    test(q.name + " < 0", [](double value) { return value < 0; });
    test(q.name + " > 0", [](double value) { return value > 0; });
    if (!q.is_angle()) return;
    constexpr auto pi = std::numbers::pi;
    test("|" + q.name + "| > π/2", [](double value) { return std::abs(value) > pi / 2; });
    test("|" + q.name + "| > π", [](double value) { return std::abs(value) > pi; });
    test("sin(" + q.name + ") < 0", [](double value) { return std::sin(value) < 0; });
    test("cos(" + q.name + ") < 0", [](double value) { return std::cos(value) < 0; });
    test("sin(" + q.name + ") = 0", [](double value) { return std::abs(std::sin(value)) < same; });
  }

  void of_pairs() {
    for (auto one = quantities_.begin(); one != quantities_.end(); ++one) {
      for (auto other = one + 1; other != quantities_.end(); ++other) {
        if (!(one->unit == other->unit) || one->unit == units::none || one->is_angle()) continue;
        const auto x = [&](std::size_t i) { return one->values[i]; };
        const auto y = [&](std::size_t i) { return other->values[i]; };
        add(one->name + " = " + other->name, [&](std::size_t i) { return is_same_input(x(i), y(i)); });
        add(one->name + " < " + other->name, [&](std::size_t i) { return x(i) < y(i) && !is_same_input(x(i), y(i)); });
        add(one->name + " > " + other->name, [&](std::size_t i) { return x(i) > y(i) && !is_same_input(x(i), y(i)); });
      }
    }
  }

  /// "one of a, b, c is 0", "two of I[0], I[1], I[2] are equal".
  void of_group(const std::vector<const Quantity*>& group) {
    if (group.size() < 2 || group.size() > 4) return;
    std::vector<std::string> names;
    for (const Quantity* each : group) names.push_back(each->name);
    const std::string all = fmt::format("{}", fmt::join(names, ", "));
    const auto zeros = [&](std::size_t i) {
      return std::ranges::count_if(group, [i](const Quantity* each) { return each->values[i] == 0; });
    };
    add("one of " + all + " is 0", [&](std::size_t i) { return zeros(i) > 0; });
    add("all but one of " + all + " are 0",
        [&](std::size_t i) { return zeros(i) + 1 == static_cast<std::ptrdiff_t>(group.size()); });
    if (group.front()->unit == units::none || group.front()->is_angle() || group.size() < 3) return;
    const auto equal_pairs = [&](std::size_t i) {
      std::size_t count = 0;
      for (std::size_t a = 0; a < group.size(); ++a)
        for (std::size_t b = a + 1; b < group.size(); ++b)
          count += group[a]->values[i] != 0 && is_same_input(group[a]->values[i], group[b]->values[i]) ? 1 : 0;
      return count;
    };
    add("two of " + all + " are equal", [&](std::size_t i) { return equal_pairs(i) > 0; });
    add(all + " are equal", [&](std::size_t i) { return equal_pairs(i) == group.size() * (group.size() - 1) / 2; });
    add(all + " do not ascend", [&](std::size_t i) {
      return !std::ranges::is_sorted(group, {}, [i](const Quantity* each) { return each->values[i]; });
    });
  }

  /// The components of a vector, and the single numbers of one unit.
  void of_groups() {
    std::vector<const Quantity*> numbers;
    for (std::size_t a = 0; a < exercise_.arguments.size(); ++a) {
      std::vector<const Quantity*> components;
      for (const Quantity& each : quantities_) {
        if (each.argument != a) continue;
        const Kind kind = exercise_.arguments[a].kind;
        if (kind == Kind::vector3 || kind == Kind::vector2) components.push_back(&each);
        if (kind == Kind::number) numbers.push_back(&each);
      }
      of_group(components);
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      std::vector<const Quantity*> alike;
      for (const Quantity* each : numbers)
        if (each->unit == numbers[k]->unit) alike.push_back(each);
      if (alike.front() == numbers[k]) of_group(alike);
    }
  }

  void of_argument(std::size_t a) {
    const Argument& argument = exercise_.arguments[a];
    if (exercise_.cases.front().inputs[a].numbers.size() > 1)
      add(argument.name + " = 0", [&](std::size_t i) { return input(i, a).size() > 0 && input(i, a).isZero(0); });
    if (argument.kind != Kind::vector && argument.kind != Kind::points && argument.kind != Kind::matrices) return;
    // Lists of one length say the same.
    if (!std::exchange(has_no_list_, false)) return;
    const auto count = [&](std::size_t i) {
      const Value& value = exercise_.cases[i].inputs[a];
      return argument.kind == Kind::vector ? value.rows : argument.kind == Kind::points ? value.cols : value.cols / 3;
    };
    add(argument.name + " has no entry", [&](std::size_t i) { return count(i) == 0; });
    add(argument.name + " has one entry only", [&](std::size_t i) { return count(i) == 1; });
    if (argument.kind != Kind::vector) return;
    const auto numbers = [&](std::size_t i) { return exercise_.cases[i].inputs[a].numbers; };
    const auto is_negative = [](double number) { return number < 0; };
    add("an entry of " + argument.name + " is negative",
        [&](std::size_t i) { return std::ranges::any_of(numbers(i), is_negative); });
    add(argument.name + " does not ascend", [&](std::size_t i) { return !std::ranges::is_sorted(numbers(i)); });
  }

  void of_matrix(std::size_t a) {
    const std::string& name = exercise_.arguments[a].name;
    const auto is_diagonal = [&](std::size_t i) { return Matrix(input(i, a)).isDiagonal(same); };
    const auto ascends = [&](std::size_t i) {
      const auto m = input(i, a);
      return m(0, 0) <= m(1, 1) && m(1, 1) <= m(2, 2);
    };
    add(name + " is diagonal", is_diagonal);
    add(name + " is not diagonal", [&](std::size_t i) { return !is_diagonal(i); });
    add(name + " is diagonal, but its entries do not ascend",
        [&](std::size_t i) { return is_diagonal(i) && !ascends(i); });
    add(name + " is a multiple of the unit matrix", [&](std::size_t i) {
      return is_diagonal(i) && is_same_input(input(i, a)(0, 0), input(i, a)(1, 1)) &&
             is_same_input(input(i, a)(0, 0), input(i, a)(2, 2));
    });
    if (exercise_.arguments[a].unit == units::moment_of_inertia) of_moments(a);
    if (!(exercise_.arguments[a].unit == units::none)) return;
    constexpr double nearly = 1e-12;  // a rotation matrix is known to rounding only
    for (Eigen::Index k = 0; k < 3; ++k) {
      const std::string entry = fmt::format("{}({},{})", name, k, k);
      const auto is_axis = [&, k](std::size_t i, double sign) {
        return (Eigen::Vector3d(input(i, a).col(k)) - sign * Eigen::Vector3d::Unit(k)).norm() < nearly;
      };
      add("|" + entry + "| = 1", [&](std::size_t i) { return is_axis(i, 1) || is_axis(i, -1); });
      add(entry + " = 1", [&](std::size_t i) { return is_axis(i, 1); });
      add(entry + " = −1", [&](std::size_t i) { return is_axis(i, -1); });
    }
  }

  /// Of tensors on any axes, so to rounding only.
  void of_moments(std::size_t a) {
    constexpr double nearly = 1e-9;
    const auto moments = [&](std::size_t i) -> Eigen::Vector3d {
      return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(input(i, a)).eigenvalues();
    };
    const std::string of = " of " + exercise_.arguments[a].name;
    add("a principal moment" + of + " is 0", [&](std::size_t i) {
      const Eigen::Vector3d m = moments(i);
      return m.cwiseAbs().minCoeff() <= nearly * m.cwiseAbs().maxCoeff();
    });
    found_.back().tells_right = false;
    add("two principal moments" + of + " are equal", [&](std::size_t i) {
      const Eigen::Vector3d m = moments(i);
      return std::min(m[1] - m[0], m[2] - m[1]) <= nearly * m.cwiseAbs().maxCoeff();
    });
    found_.back().tells_right = false;
  }

  void of_two_vectors() {
    for (std::size_t a = 0; a < exercise_.arguments.size(); ++a) {
      for (std::size_t b = a + 1; b < exercise_.arguments.size(); ++b) {
        const Argument &one = exercise_.arguments[a], &other = exercise_.arguments[b];
        if (one.kind != Kind::vector3 || other.kind != Kind::vector3) continue;
        if (one.unit == units::radian || other.unit == units::radian || one.unit == units::moment_of_inertia) continue;
        const auto size = [&](std::size_t i) { return input(i, a).norm() * input(i, b).norm(); };
        add(one.name + " and " + other.name + " are parallel", [&](std::size_t i) {
          const Eigen::Vector3d u = input(i, a), v = input(i, b);
          return size(i) > 0 && u.cross(v).norm() <= same * size(i);
        });
        const auto cosine = [&](std::size_t i) {
          return size(i) > 0 ? Eigen::Vector3d(input(i, a)).dot(Eigen::Vector3d(input(i, b))) / size(i) : 1;
        };
        add(one.name + " and " + other.name + " are perpendicular",
            [&](std::size_t i) { return std::abs(cosine(i)) <= same; });
        add("the angle from " + one.name + " to " + other.name + " is obtuse",
            [&](std::size_t i) { return cosine(i) < -same; });
      }
    }
  }

  const ExerciseReference& exercise_;
  std::vector<Quantity> quantities_;
  std::vector<Feature> found_;
  bool has_no_list_ = true;  // so far
};

/// What the answer is at the wrong cases: " At those cases your result is 0."
std::string words_of_wrong(const ExerciseReference& exercise, const Answers& answers,
                           const std::vector<std::size_t>& wrong) {
  if (exercise.comparison != Comparison::plain) return "";
  const auto all = [&](const std::function<bool(double, double)>& test) {
    return std::ranges::all_of(wrong, [&](std::size_t i) {
      return std::ranges::equal(answers[i]->numbers, exercise.cases[i].expected.numbers, test);
    });
  };
  if (all([](double yours, double) { return !std::isfinite(yours); }))
    return " At those cases your result is not finite.";
  if (all([](double yours, double) { return yours == 0; })) return " At those cases your result is 0.";
  const auto is_times = [&](double factor) {
    return std::ranges::all_of(wrong, [&](std::size_t i) {
      const Matrix scaled = factor * as_matrix(exercise.cases[i].expected);
      return is_same_answer(exercise, i, *answers[i], to_value(scaled));
    });
  };
  if (is_times(-1)) return " At those cases your result is the negative of the right one.";
  if (is_times(2)) return " At those cases your result is twice the right one.";
  if (is_times(0.5)) return " At those cases your result is half of the right one.";
  return "";
}

}  // namespace

Outcomes outcomes_of(const ExerciseReference& exercise, const Answers& answers) {
  Outcomes outcome;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    if (!answers[i]) continue;
    (passes(exercise, i, *answers[i]) ? outcome.right : outcome.wrong).push_back(i);
  }
  return outcome;
}

std::optional<Reason> diagnose_split(const ExerciseReference& exercise, const Answers& answers) {
  const Outcomes outcome = outcomes_of(exercise, answers);
  constexpr std::size_t fewest = 2, fewest_right = 4, most_features = 2;
  if (outcome.wrong.size() < fewest || outcome.right.size() < fewest_right) return std::nullopt;
  // Where the function ended without a value it is not right.
  if (outcome.wrong.size() + outcome.right.size() < exercise.cases.size()) return std::nullopt;
  std::vector<std::string> exact;
  std::vector<std::pair<std::string, std::size_t>> nearly;  // with how many right ones there
  struct Mostly {
    std::string words;
    std::size_t wrong, right;
  };
  std::vector<Mostly> mostly;  // where most are wrong, but not all
  for (const Feature& each : Features(exercise).all()) {
    const auto holds = [&](std::size_t i) { return each.holds[i]; };
    const auto wrong = static_cast<std::size_t>(std::ranges::count_if(outcome.wrong, holds));
    const auto right = static_cast<std::size_t>(std::ranges::count_if(outcome.right, holds));
    if (wrong < outcome.wrong.size()) {
      const bool is_most = 10 * (outcome.wrong.size() - wrong) <= wrong && 20 * right <= wrong &&
                           5 * right <= outcome.right.size() &&
                           4 * (outcome.wrong.size() - wrong) <= outcome.right.size() - right;
      if (is_most && exercise.result_kind != Kind::integer) mostly.push_back({each.words, wrong, right});
      continue;
    }
    if (right == 0) exact.push_back(each.words);
    // Where much is zero, a wrong answer may be right.
    const bool tells_apart = exercise.result_kind == Kind::integer  // of few answers a wrong one is often right
                                 ? outcome.wrong.size() >= right && outcome.right.size() >= right + 8
                                 : outcome.wrong.size() >= 6 * right && outcome.right.size() >= 10 * right;
    if (tells_apart && outcome.wrong.size() > 5) nearly.emplace_back(each.words, right);
  }
  // What is so of the whole is so of its components.
  for (const Argument& argument : exercise.arguments)
    if (!exact.empty() && exact.front() == argument.name + " = 0")
      std::erase_if(exact, [&](const std::string& words) { return words.find(argument.name + "[") != words.npos; });
  const std::string there = words_of_wrong(exercise, answers, outcome.wrong);
  const std::string total = plural(outcome.right.size() + outcome.wrong.size(), "case");
  if (!exact.empty() && exact.size() <= most_features)
    return Reason{
        ReasonKind::split, "split",
        fmt::format("Your result is wrong exactly where {}{} ({} of {}), and right elsewhere.{}", exact.front(),
                    exact.size() > 1 ? " (in these cases the same as: " + exact.back() + ")" : "", outcome.wrong.size(),
                    total, there)};
  // Of many that fit none is certain.
  if (exact.empty() && nearly.empty() && mostly.size() == 1) {
    const auto& [words, wrong, right] = mostly.front();
    const std::size_t cases = wrong + right;
    return Reason{
        ReasonKind::split, "split",
        fmt::format("Your result is wrong {} {} (at {} {}), and hardly elsewhere (at {} of {}).",
                    right == 0 ? "wherever" : "nearly wherever", words,
                    right == 0 ? "all" : fmt::format("{} of", wrong), plural(cases, "case"),
                    outcome.wrong.size() - wrong, plural(outcome.wrong.size() + outcome.right.size() - cases, "case"))};
  }
  if (!exact.empty() || nearly.size() != 1) return std::nullopt;
  const auto& [words, right] = nearly.front();
  return Reason{ReasonKind::split, "split",
                fmt::format("Your result is wrong only where {} (at {} of those {}), and right elsewhere.{}", words,
                            outcome.wrong.size(), plural(outcome.wrong.size() + right, "case"), there)};
}

namespace {

/// A size of the inputs, at every case.
struct Size {
  std::string words;
  Unit unit;
  std::vector<double> values;
};

/// Of every number and every vector; then of products without a unit, as of a rate and a time.
std::vector<Size> sizes_of(const ExerciseReference& exercise) {
  std::vector<Size> sizes;
  for (const Quantity& each : quantities_of(exercise)) {
    if (exercise.arguments[each.argument].kind == Kind::matrix3) continue;
    Size& size = sizes.emplace_back("|" + each.name + "|", each.unit, each.values);
    for (double& value : size.values) value = std::abs(value);
  }
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    const Argument& argument = exercise.arguments[a];
    if (argument.kind == Kind::number || argument.kind == Kind::integer) continue;
    Size& size = sizes.emplace_back("|" + argument.name + "|", argument.unit);
    for (const Case& one : exercise.cases) size.values.push_back(as_matrix(one.inputs[a]).norm());
  }
  const std::vector<Size> singles = sizes;
  for (auto one = singles.begin(); one != singles.end(); ++one)
    for (auto other = one + 1; other != singles.end(); ++other) {
      const Unit product = one->unit * other->unit;
      if (one->unit.second == 0 || product.kilogram != 0 || product.metre != 0 || product.second != 0) continue;
      Size& size = sizes.emplace_back(one->words + " " + other->words, units::none, one->values);
      for (std::size_t i = 0; i < size.values.size(); ++i) size.values[i] *= other->values[i];
    }
  return sizes;
}

}  // namespace

std::optional<Reason> diagnose_threshold(const ExerciseReference& exercise, const Answers& answers) {
  constexpr std::size_t fewest = 4;
  constexpr double chance = 1e-8;
  const Outcomes outcome = outcomes_of(exercise, answers);
  const std::size_t wrong = outcome.wrong.size(), right = outcome.right.size();
  const auto total = static_cast<double>(wrong + right);
  if (wrong < fewest || right < fewest ||
      std::pow(static_cast<double>(wrong) / total, wrong) * std::pow(static_cast<double>(right) / total, right) >
          chance)
    return std::nullopt;
  for (const Size& size : sizes_of(exercise)) {
    for (const bool is_above : {true, false}) {
      // As if large were wrong.
      const auto at = [&](std::size_t i) { return is_above ? size.values[i] : -size.values[i]; };
      const double first_wrong = at(*std::ranges::min_element(outcome.wrong, {}, at));
      if (std::ranges::any_of(outcome.right, [&](std::size_t i) { return !(at(i) < first_wrong); })) continue;
      return Reason{ReasonKind::split, "threshold",
                    fmt::format("Your result is right at all {} with {} {} {}, and wrong at all {} others.",
                                plural(right, "case"), size.words, is_above ? "<" : ">",
                                number_text(std::abs(first_wrong), 3), wrong),
                    Weight::symptom};
    }
  }
  return std::nullopt;
}

std::optional<Reason> diagnose_one_side(const ExerciseReference& exercise, const Answers& answers) {
  const Outcomes outcome = outcomes_of(exercise, answers);
  constexpr std::size_t fewest = 4;
  constexpr double chance = 1e-4;  // that wrong cases share a feature by accident
  if (outcome.wrong.empty()) return std::nullopt;
  const std::size_t total = outcome.right.size() + outcome.wrong.size();
  using Sides = std::vector<std::pair<std::string, std::size_t>>;
  Sides sides;   // where all is right, with the number of cases
  Sides needed;  // where all is that is wrong, with the number of cases elsewhere
  for (const Feature& each : Features(exercise).all()) {
    const auto holds = [&](std::size_t i) { return each.holds[i]; };
    const auto wrong = static_cast<std::size_t>(std::ranges::count_if(outcome.wrong, holds));
    const auto right = static_cast<std::size_t>(std::ranges::count_if(outcome.right, holds));
    const double share = static_cast<double>(wrong + right) / static_cast<double>(total);
    if (wrong == outcome.wrong.size() && std::pow(share, wrong) < chance)
      needed.emplace_back(each.words, total - wrong - right);
    const std::size_t right_elsewhere = outcome.right.size() - right;
    // Of few answers a wrong one is often right.
    const std::size_t telling = exercise.result_kind == Kind::integer ? 1 : 10;
    const auto is_zero = [&](std::size_t i) {
      return std::ranges::count(exercise.cases[i].expected.numbers, 0.0) ==
             std::ssize(exercise.cases[i].expected.numbers);
    };
    // Zeros come out of many a mistake.
    if (std::ranges::all_of(outcome.right, [&](std::size_t i) { return !holds(i) || is_zero(i); })) continue;
    if (!each.tells_right || wrong > 0 || right < fewest || right_elsewhere * telling > outcome.wrong.size() ||
        right_elsewhere > right)
      continue;
    sides.emplace_back(each.words, right);
  }
  // Of two that tell as much none is certain.
  const auto has_largest = [](Sides& all) {
    std::ranges::stable_sort(all, std::greater(), &Sides::value_type::second);
    return !all.empty() && (all.size() == 1 || all[0].second > all[1].second);
  };
  std::string sentence;
  if (has_largest(sides))
    sentence =
        fmt::format("Your result is right at all {} where {}, and wrong at {} of the {} others.",
                    plural(sides[0].second, "case"), sides[0].first, outcome.wrong.size(), total - sides[0].second);
  else if (has_largest(needed))
    sentence =
        fmt::format("Your result is wrong only where {} (at {} of those {}), and right elsewhere.", needed[0].first,
                    outcome.wrong.size() == total - needed[0].second ? "all" : std::to_string(outcome.wrong.size()),
                    plural(total - needed[0].second, "case"));
  else
    return std::nullopt;
  return Reason{ReasonKind::split, "one_side", sentence, Weight::symptom};
}

/// The kinds of cases that are wrong, by their names, where all others are right; nothing where these are most.
static std::vector<std::string> wrong_kinds(const ExerciseReference& exercise, const Outcomes& outcome) {
  constexpr std::size_t most_named = 6, fewest_right = 5;
  std::vector<std::string> wrong;
  std::size_t right = 0;
  const auto kind = [&](std::size_t i) { return "“" + replaced(exercise.cases[i].name, " [0-9]+$", "") + "”"; };
  for (const std::size_t i : outcome.wrong)
    if (i < exercise.described_cases() && std::ranges::count(wrong, kind(i)) == 0) wrong.push_back(kind(i));
  for (const std::size_t i : outcome.right) {
    if (i >= exercise.described_cases()) continue;
    if (std::ranges::count(wrong, kind(i)) > 0) return {};
    right += exercise.cases[i].group == Group::random ? 1 : 0;
  }
  return right < fewest_right || wrong.size() > most_named ? std::vector<std::string>() : wrong;
}

std::optional<Reason> diagnose_kinds(const ExerciseReference& exercise, const Answers& answers) {
  const Outcomes outcome = outcomes_of(exercise, answers);
  constexpr std::size_t fewest = 4;
  const std::vector<std::string> kinds = wrong_kinds(exercise, outcome);
  if (kinds.empty() || outcome.wrong.size() < fewest) return std::nullopt;
  return Reason{ReasonKind::split, "kinds",
                fmt::format("Your result is right at {} of {} and wrong at all of {} {}: {}.{}", outcome.right.size(),
                            plural(outcome.right.size() + outcome.wrong.size(), "case"),
                            kinds.size() == 1 ? "this" : "these", kinds.size() == 1 ? "kind" : "kinds", listed(kinds),
                            words_of_wrong(exercise, answers, outcome.wrong)),
                Weight::symptom};
}

/// What the right results become at all failing cases, but for those where only digits are lost.
static std::optional<Reason> changed_where_wrong(const ExerciseReference& whole, const Answers& answers,
                                                 const Outcomes& outcome) {
  constexpr std::size_t fewest = 5;
  constexpr double nearly_right = 1e-5;
  ExerciseReference exercise = whole;
  std::size_t clearly_wrong = outcome.wrong.size();
  for (const std::size_t i : outcome.right) exercise.cases[i].deciding = false;
  for (const std::size_t i : outcome.wrong) {
    const std::vector<Deviation> of_case = deviations(exercise, i, *answers[i]);
    if (std::ranges::any_of(of_case, [](const Deviation& each) { return !(each.relative_size() <= nearly_right); }))
      continue;
    exercise.cases[i].deciding = false;
    --clearly_wrong;
  }
  const std::size_t deciding = deciding_cases(exercise).size();
  if (deciding < fewest || deciding == deciding_cases(whole).size()) return std::nullopt;
  for (const auto& mechanism : {diagnose_transform, diagnose_factor}) {
    std::optional<Reason> found = mechanism(exercise, answers);
    if (!found || !found->is_cause()) continue;
    found->sentence = fmt::format("At the {} of {} where your result is {}wrong: {}", clearly_wrong,
                                  plural(outcome.right.size() + outcome.wrong.size(), "case"),
                                  clearly_wrong < outcome.wrong.size() ? "clearly " : "",
                                  replaced(found->sentence, " at every case", " at each of them"));
    return found;
  }
  return std::nullopt;
}

std::optional<Reason> diagnose_conditional(const ExerciseReference& exercise, const Answers& answers) {
  const Outcomes outcome = outcomes_of(exercise, answers);
  std::vector<std::size_t> wrong = outcome.wrong;
  std::erase_if(wrong, [&](std::size_t i) { return i >= exercise.described_cases(); });
  constexpr std::size_t fewest = 3;
  // Where many values are one answer, as angles of one attitude are, or there are few, cases agree by accident.
  if (exercise.comparison != Comparison::plain || exercise.result_kind == Kind::integer || wrong.size() < fewest ||
      outcome.right.empty())
    return std::nullopt;
  const auto is_trivial = [&](const Value& value) {
    return !value.is_finite() || std::ranges::all_of(value.numbers, [](double number) { return number == 0; });
  };
  std::optional<Reason> named;
  for (const Misconception& each : exercise.misconceptions) {
    // Zeros agree with every wrong answer that happens to vanish there.
    const bool is_telling = std::ranges::all_of(each.outputs, is_trivial) ||
                            std::ranges::none_of(wrong, [&](std::size_t i) { return is_trivial(each.outputs[i]); });
    const bool fits =
        is_telling && std::ranges::all_of(wrong, [&](std::size_t i) {
          return !passes(exercise, i, each.outputs[i]) && is_same_answer(exercise, i, *answers[i], each.outputs[i]);
        });
    if (!fits) continue;
    const std::string sentence =
        fmt::format("At the cases where your result is wrong, and only there: {}", each.message);
    if (named && named->sentence != sentence) return changed_where_wrong(exercise, answers, outcome);
    named = Reason{ReasonKind::misconception, each.name, sentence, Weight::cause, each.notes};
  }
  return named ? named : changed_where_wrong(exercise, answers, outcome);
}

}  // namespace workbook
