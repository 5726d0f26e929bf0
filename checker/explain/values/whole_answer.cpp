#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace workbook {

namespace {

using Eigen::MatrixXd;

constexpr std::size_t telling_numbers = 3;  // a factor common to so many numbers is no accident
constexpr int largest_permuted_size = 4;

/// Are these the student's answers at all deciding cases?
bool agree(const ExerciseReference& exercise, const Answers& answers,
           const std::function<Value(std::size_t case_index)>& value_at) {
  return std::ranges::all_of(deciding_cases(exercise),
                             [&](std::size_t i) { return is_same_answer(exercise, i, *answers[i], value_at(i)); });
}

bool is_wrong_somewhere(const ExerciseReference& exercise, const Answers& answers) {
  return std::ranges::any_of(deciding_cases(exercise),
                             [&](std::size_t i) { return !passes(exercise, i, *answers[i]); });
}

struct Transform {
  std::string name;
  std::string message;
  std::function<MatrixXd(const MatrixXd&)> apply;
  Weight weight = Weight::cause;
  ReasonKind kind = ReasonKind::transform;
};

/// The factor by least squares, each number measured in its natural size.
std::optional<double> common_factor(const ExerciseReference& exercise, const Answers& answers) {
  double product = 0.0;
  double square = 0.0;
  std::size_t telling = 0;
  for (std::size_t i : deciding_cases(exercise)) {
    const Case& one = exercise.cases[i];
    for (std::size_t n = 0; n < one.expected.numbers.size(); ++n) {
      const double scale = scale_at(one, n);
      const double expected = one.expected.numbers[n] / scale;
      product += expected * answers[i]->numbers[n] / scale;
      square += expected * expected;
      if (std::abs(expected) > 1e-6) ++telling;
    }
  }
  if (telling < telling_numbers || !std::isfinite(product)) return std::nullopt;
  return product / square;
}

bool is_an_angle(const ExerciseReference& exercise) {
  return std::ranges::any_of(exercise.result_units, [](const Unit& unit) { return unit.radian != 0; });
}

std::string factor_sentence(const std::string& text) {
  if (text == "−1")
    return "Your result is the negative of the expected one at every case: a sign is lost or one too many.";
  if (text == "1/2") return "Your result is half of the expected one at every case.";
  return fmt::format("Your result is {} times the expected one at every case.", text);
}

Transform scaled(const ExerciseReference& exercise, double factor) {
  constexpr double degrees_per_radian = 180 / std::numbers::pi;
  const auto is_near = [factor](double other) { return std::abs(factor - other) <= 1e-6 * other; };
  const auto apply = [factor](const MatrixXd& right) -> MatrixXd { return factor * right; };
  if (is_an_angle(exercise) && is_near(degrees_per_radian))
    return {"degrees", "Your result is in degrees; angles here are in radians.", apply};
  if (is_an_angle(exercise) && is_near(1 / degrees_per_radian)) {
    return {"converted_twice",
            "Your result is converted from degrees to radians once too often: it is π/180 times the expected one.",
            apply};
  }
  const std::string text = coefficient_text(factor);
  if (text == "0")
    return {"zero", "Your result is zero everywhere, also where the expected one is not.", apply, Weight::symptom};
  constexpr double nearly = 2e-2;  // so near to 1 is the sum or the integration of large steps too
  if (std::abs(factor - 1) < nearly)
    return {"factor", factor_sentence(text), apply, Weight::possible, ReasonKind::accuracy};
  const std::string simple = simple_number(factor);
  return {"factor", factor_sentence(simple.empty() ? text : simple), apply};
}

/// Every other order of the rows: of the components of a vector, or of every column of a list of points.
std::vector<Transform> permutations(int rows) {
  std::vector<Transform> found;
  std::vector<int> order(static_cast<std::size_t>(rows));
  std::iota(order.begin(), order.end(), 0);
  while (std::ranges::next_permutation(order).found) {
    found.push_back(
        {"permuted",
         fmt::format("Your components are the expected ones in another order: [{}].", fmt::join(order, "], [")),
         [order](const MatrixXd& right) { return MatrixXd(right(order, Eigen::all)); }});
  }
  return found;
}

/// A misconception, or changed inputs.
struct KnownMistake {
  ReasonKind kind;
  std::string name, message, notes;
  const std::vector<Value>* outputs;

  bool is_of_other_function() const { return kind == ReasonKind::input_transform && name.starts_with("of_"); }
};

/// Each with results of its own.
std::vector<KnownMistake> known_mistakes(const ExerciseReference& exercise) {
  std::vector<KnownMistake> known;
  const auto add = [&](KnownMistake mistake) {
    const auto is_same = [&](const KnownMistake& other) {
      return std::ranges::all_of(deciding_cases(exercise), [&](std::size_t i) {
        return is_same_answer(exercise, i, mistake.outputs->at(i), other.outputs->at(i));
      });
    };
    if (std::ranges::none_of(known, is_same)) known.push_back(std::move(mistake));
  };
  for (const Misconception& each : exercise.misconceptions)
    add({ReasonKind::misconception, each.name, each.message, each.notes, &each.outputs});
  for (const InputTransform& each : exercise.input_transforms)
    add({ReasonKind::input_transform, each.name, fmt::format("This is the right result for {}.", each.message), "",
         &each.outputs});
  return known;
}

/// Some wrong numbers of a result, and the mistake that gives them.
struct Part {
  KnownMistake mistake;
  std::set<std::size_t> entries = {};

  std::string names(const ExerciseReference& exercise) const {
    std::vector<std::string> all;
    for (const std::size_t entry : entries)
      all.push_back(entry_name(exercise.cases.front().expected, exercise.result_kind, entry));
    return listed(all);
  }
};

/// The mistake that gives most of the wrong numbers, and that which gives most of the others.
std::vector<Part> parts_of(const ExerciseReference& exercise, const Answers& answers, std::set<std::size_t> wrong) {
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  const auto gives = [&](const KnownMistake& mistake, std::size_t entry) {
    return agree(exercise, answers, [&](std::size_t i) {
      Value value = *answers[i];
      value.numbers[entry] = mistake.outputs->at(i).numbers[entry];
      return value;
    });
  };
  const std::vector<KnownMistake> known = known_mistakes(exercise);
  std::vector<Part> parts;
  for (int k = 0; k < 2; ++k) {
    Part best;
    for (const KnownMistake& mistake : known) {
      // A number in common with another function, or beside a mistake, with the result for changed inputs is a
      // coincidence.
      const bool is_named = mistake.kind == ReasonKind::misconception;
      if (mistake.is_of_other_function() || (k > 0 && !is_named)) continue;
      Part part{mistake};
      for (const std::size_t entry : wrong)
        if (gives(mistake, entry)) part.entries.insert(entry);
      // Zeros agree with every mistake in which something vanishes.
      const auto is_telling = [&](std::size_t i) {
        const Deviation deviation = deviations(exercise, i, *answers[i]).front();
        return std::ranges::any_of(part.entries, [&](std::size_t entry) {
          return answers[i]->numbers[entry] != 0 && !deviation.is_within(entry);
        });
      };
      if (part.entries.size() > best.entries.size() &&
          std::cmp_greater_equal(std::ranges::count_if(deciding, is_telling), telling_numbers))
        best = part;
    }
    if (best.entries.empty()) break;
    for (const std::size_t entry : best.entries) wrong.erase(entry);
    parts.push_back(std::move(best));
  }
  return parts;
}

std::vector<Transform> reorderings(const ExerciseReference& exercise) {
  switch (exercise.result_kind) {
    case Kind::vector2:
      return permutations(2);
    case Kind::vector3:
    case Kind::points:
      return permutations(3);
    case Kind::vector: {
      std::vector<Transform> found = {{"reversed", "Your components are the expected ones in reverse order.",
                                       [](const MatrixXd& right) -> MatrixXd { return right.colwise().reverse(); }}};
      const int rows = exercise.cases.front().expected.rows;
      const bool same_length =
          std::ranges::all_of(exercise.cases, [rows](const Case& one) { return one.expected.rows == rows; });
      if (same_length && rows <= largest_permuted_size)
        std::ranges::move(permutations(rows), std::back_inserter(found));
      return found;
    }
    case Kind::matrix3:
      return {{"transposed", "Your matrix is the transpose of the expected one: rows and columns are exchanged.",
               [](const MatrixXd& right) -> MatrixXd { return right.transpose(); }}};
    case Kind::number:
    case Kind::integer:
    case Kind::matrices:
      return {};
  }
  return {};
}

}  // namespace

std::optional<Reason> diagnose_misconception(const ExerciseReference& exercise, const Answers& answers) {
  if (!all_deciding_cases_answered(exercise, answers)) return std::nullopt;
  std::optional<Reason> named;
  for (const Misconception& misconception : exercise.misconceptions) {
    // Where both are wrong, the agreement says something.
    const auto both_are_wrong = [&](std::size_t i) {
      return !passes(exercise, i, *answers[i]) && !passes(exercise, i, misconception.outputs.at(i));
    };
    if (!agree(exercise, answers, [&](std::size_t i) { return misconception.outputs.at(i); }) ||
        std::ranges::none_of(deciding_cases(exercise), both_are_wrong))
      continue;
    if (named && named->sentence != misconception.message) return std::nullopt;
    if (!named)
      named = {ReasonKind::misconception, misconception.name, misconception.message, Weight::cause,
               misconception.notes};
  }
  return named;
}

std::optional<Reason> diagnose_transform(const ExerciseReference& exercise, const Answers& answers) {
  if (!all_deciding_cases_answered(exercise, answers) || !is_wrong_somewhere(exercise, answers)) return std::nullopt;
  std::vector<Transform> candidates;
  const std::optional<double> factor = common_factor(exercise, answers);
  // Beside the right result, all that is small enough is the product with a small factor.
  const auto is_product = [&](std::size_t i) {
    return *factor == 0 || passes(exercise, i, to_value(as_matrix(*answers[i]) / *factor));
  };
  // One that is written as 1 would say that the answer is right; it is inaccurate.
  if (factor && coefficient_text(*factor) != "1" && std::ranges::all_of(deciding_cases(exercise), is_product))
    candidates.push_back(scaled(exercise, *factor));
  std::ranges::move(reorderings(exercise), std::back_inserter(candidates));

  for (const Transform& transform : candidates) {
    const auto transformed = [&](std::size_t i) {
      return to_value(transform.apply(as_matrix(exercise.cases[i].expected)));
    };
    if (agree(exercise, answers, transformed))
      return Reason{transform.kind, transform.name, transform.message, transform.weight};
  }
  return std::nullopt;
}

std::optional<Reason> diagnose_whole_turns(const ExerciseReference& exercise, const Answers& answers) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  const auto is_angle = [&](std::size_t n) {
    const std::vector<Unit>& of = exercise.result_units;
    return of[of.size() > 1 ? n : 0] == units::radian;
  };
  if (wrong.empty() || !std::ranges::all_of(wrong, is_angle) || !all_deciding_cases_answered(exercise, answers))
    return std::nullopt;
  for (const auto& [size, text] : {std::pair(2 * std::numbers::pi, "2π"), std::pair(std::numbers::pi, "π")}) {
    const double period = size;  // clang 14 lets no lambda capture a name of a structured binding
    std::size_t cases = 0;
    bool are_turns = true, are_complements = true;  // as those of an obtuse angle, or of the long way round
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      if (!answers[i]) continue;
      const Deviation deviation = deviations(exercise, i, *answers[i]).front();
      cases += deviation.is_within() ? 0 : 1;
      for (const std::size_t n : wrong) {
        const double most = std::max(deviation.allowed[n], deviation.tolerance * period);
        const double sum = answers[i]->numbers[n] + exercise.cases[i].expected.numbers[n];
        are_turns = are_turns && std::abs(std::remainder(deviation.difference.numbers[n], period)) <= most;
        are_complements = are_complements && (deviation.is_within(n) || std::abs(sum - period) <= most);
      }
    }
    if (cases < telling_numbers) continue;
    if (are_turns)
      return Reason{ReasonKind::transform, "whole_turns",
                    fmt::format("At every case your angle is right up to a multiple of {}; at {} that multiple is not "
                                "zero. {}",
                                text, plural(cases, "case"),
                                period > 4 ? "Follow the angle, or bring it into the range that is asked for."
                                           : "Half a turn is missing there, or too much.")};
    if (are_complements)
      return Reason{ReasonKind::transform, "complement",
                    fmt::format("At the {} where your result is wrong it is {} less the right angle: which of the two "
                                "do your functions return?",
                                plural(cases, "case"), text)};
  }
  return std::nullopt;
}

/// The right numbers at other places, as of a matrix that is filled in another order.
std::optional<Reason> diagnose_places(const ExerciseReference& exercise, const Answers& answers) {
  const Value& shape = exercise.cases.front().expected;
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  if (exercise.comparison != Comparison::plain || wrong.size() < 2 || !all_deciding_cases_answered(exercise, answers))
    return std::nullopt;
  const std::vector<std::size_t> deciding = deciding_cases(exercise);
  std::set<std::size_t> taken;
  std::vector<std::string> places;
  for (const std::size_t here : wrong)
    for (const std::size_t there : wrong) {
      const bool is_there =
          here != there && !taken.contains(there) && std::ranges::all_of(deciding, [&](std::size_t i) {
            const Case& one = exercise.cases[i];
            return one.expected.has_shape_of(shape) && answers[i]->has_shape_of(shape) &&
                   std::abs(answers[i]->numbers[here] - one.expected.numbers[there]) <=
                       one.tolerance * (scale_at(one, here) + scale_at(one, there));
          });
      if (!is_there) continue;
      taken.insert(there);
      places.push_back(fmt::format("{} holds what belongs to {}", entry_name(shape, exercise.result_kind, here),
                                   entry_name(shape, exercise.result_kind, there)));
      break;
    }
  if (places.size() < wrong.size()) return std::nullopt;
  constexpr std::size_t most_named = 3;
  if (places.size() > most_named) places.resize(most_named);
  return Reason{ReasonKind::transform, "other_places",
                fmt::format("Your numbers are right, but stand in other places: {}{}.{}", fmt::join(places, ", "),
                            wrong.size() > most_named ? " …" : "",
                            shape.cols > 1 ? " Look at rows and columns, and at the order behind <<." : "")};
}

/// Where numbers have the right size, or that which a mistake gives, but at some cases another sign.
std::optional<Reason> diagnose_signs(const ExerciseReference& exercise, const Answers& answers) {
  if (exercise.comparison != Comparison::plain || exercise.result_kind == Kind::integer ||
      !all_deciding_cases_answered(exercise, answers) || !is_wrong_somewhere(exercise, answers))
    return std::nullopt;
  std::size_t others = 0;  // cases with another sign
  const auto have_size = [&](const auto& value_at) {
    others = 0;
    return agree(exercise, answers, [&](std::size_t i) {
      Value value = value_at(i);
      bool differs = false;
      if (!value.has_shape_of(*answers[i])) return value;
      for (std::size_t n = 0; n < value.numbers.size(); ++n) {
        const bool is_other = std::signbit(value.numbers[n]) != std::signbit(answers[i]->numbers[n]);
        differs = differs || (is_other && std::abs(value.numbers[n]) > 1e-3 * scale_at(exercise.cases[i], n));
        value.numbers[n] = std::copysign(value.numbers[n], answers[i]->numbers[n]);
      }
      others += differs ? 1 : 0;
      return value;
    });
  };
  if (have_size([&](std::size_t i) { return exercise.cases[i].expected; })) {
    if (others < telling_numbers) return std::nullopt;
    return Reason{ReasonKind::transform, "signs",
                  fmt::format("At every case your numbers have the right size; at {} of the {} cases that were looked "
                              "at, a sign is wrong.",
                              others, deciding_cases(exercise).size())};
  }
  for (const Misconception& each : exercise.misconceptions)
    if (have_size([&](std::size_t i) { return each.outputs[i]; }) && others >= 1)
      return Reason{ReasonKind::misconception, each.name, "But for a sign: " + each.message, Weight::cause, each.notes};
  return std::nullopt;
}

namespace {

/// @param must_be_all  of the wrong numbers
std::optional<Reason> known_parts(const ExerciseReference& exercise, const Answers& answers, bool must_be_all) {
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  if (wrong.empty() || exercise.cases.front().expected.numbers.size() == 1 ||
      !all_deciding_cases_answered(exercise, answers))
    return std::nullopt;
  const std::vector<Part> parts = parts_of(exercise, answers, wrong);
  std::size_t given = 0;
  for (const Part& part : parts) given += part.entries.size();
  if (parts.empty() || (must_be_all && given < wrong.size())) return std::nullopt;
  const KnownMistake& first = parts.front().mistake;
  const bool are_all = given == wrong.size(), is_one = are_all && parts.size() == 1;
  // Changed inputs that have no name, and explain a part only, may be a coincidence.
  const bool has_name = first.kind == ReasonKind::misconception;
  if (!has_name && !are_all) return std::nullopt;
  std::string sentence = fmt::format("In {}{} your result is what this mistake gives: {}",
                                     parts.front().names(exercise), is_one ? ", and nowhere else," : "", first.message);
  if (!are_all) {  // a second one in a part of the rest would be a coincidence
    Part rest{first, wrong};
    for (const std::size_t entry : parts.front().entries) rest.entries.erase(entry);
    sentence += fmt::format(" Wrong as well: {}.", rest.names(exercise));
  } else if (!is_one) {
    sentence +=
        fmt::format(" In {} it is what another one gives: {}", parts[1].names(exercise), parts[1].mistake.message);
  }
  return Reason{first.kind, first.name, sentence, is_one || has_name ? Weight::cause : Weight::possible, first.notes};
}

}  // namespace

std::optional<Reason> diagnose_wrong_part(const ExerciseReference& exercise, const Answers& answers) {
  return known_parts(exercise, answers, true);
}

std::optional<Reason> diagnose_some_part(const ExerciseReference& exercise, const Answers& answers) {
  return known_parts(exercise, answers, false);
}

std::optional<Reason> diagnose_both_mistakes(const ExerciseReference& exercise, const Answers& answers) {
  if (exercise.comparison != Comparison::plain || exercise.result_kind == Kind::integer ||
      !all_deciding_cases_answered(exercise, answers))
    return std::nullopt;
  const std::vector<KnownMistake> known = known_mistakes(exercise);
  std::optional<Reason> found;
  for (auto one = known.begin(); one != known.end(); ++one) {
    for (auto other = one + 1; other != known.end(); ++other) {
      for (const bool are_added : {true, false}) {
        const auto together = [&](std::size_t i) {
          Value value = exercise.cases[i].expected;
          for (std::size_t n = 0; n < value.numbers.size(); ++n) {
            double& number = value.numbers[n];
            const double first = one->outputs->at(i).numbers[n], second = other->outputs->at(i).numbers[n];
            number = are_added || number == 0 ? first + second - number : first * second / number;
          }
          return value;
        };
        if (!agree(exercise, answers, together)) continue;
        if (found) return std::nullopt;  // of several none is certain
        // A single slip in the code, which other explainers look for, may give the same.
        found = {
            one->kind, one->name,
            fmt::format("Two mistakes together give your result. One: {} The other: {}", one->message, other->message),
            Weight::possible, one->notes};
        break;
      }
    }
  }
  return found;
}

std::optional<Reason> diagnose_input_transform(const ExerciseReference& exercise, const Answers& answers) {
  if (!all_deciding_cases_answered(exercise, answers) || !is_wrong_somewhere(exercise, answers)) return std::nullopt;
  for (const InputTransform& transform : exercise.input_transforms) {
    if (!agree(exercise, answers, [&](std::size_t i) { return transform.outputs[i]; })) continue;
    // Of a few possible results another one is soon the same by chance.
    return Reason{ReasonKind::input_transform, transform.name,
                  fmt::format("At every case your result is the right one for {}.", transform.message),
                  exercise.result_kind == Kind::integer ? Weight::possible : Weight::cause};
  }
  return std::nullopt;
}

}  // namespace workbook
