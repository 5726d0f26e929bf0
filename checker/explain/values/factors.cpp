// A factor that is missing or one too many: the right result times powers of the inputs.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace workbook {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

constexpr Index spare_cases = 5;              // an exact fit of so many more cases than unknowns is no accident
constexpr double logarithm_exactness = 1e-7;  // of a logarithm
constexpr double largest_exponent = 4;
constexpr Index most_columns = 150, most_of_three = 20;

/// What a formula may be multiplied by at the cases: size and sign, or what becomes of a result.
struct Column {
  std::string name;
  VectorXd logarithm;
  VectorXd sign;
};

Column column_of(const std::string& name, const VectorXd& values) {
  return {name, values.cwiseAbs().array().log(), values.cwiseSign()};
}

/// name^exponent
struct InputPower {
  InputPower(const Column& column, double power)
      : name(column.name), exponent(power), is_positive((column.sign.array() >= 0).all()) {}
  std::string name;
  double exponent;
  bool is_positive;
};

std::string text_of(const InputPower& power) {
  const double size = std::abs(power.exponent);
  if (size == 1) return power.name;
  if (size == 0.5 && power.is_positive) return "√" + power.name;
  const std::size_t bracket = power.name.starts_with('(') ? 1 : 0;
  if (size == 0.5) return "√|" + power.name.substr(bracket, power.name.size() - 2 * bracket) + "|";
  if (size == std::trunc(size)) return power.name + std::array{"²", "³", "⁴"}.at(static_cast<std::size_t>(size) - 2);
  return fmt::format("{}^({})", power.name, coefficient_text(size));
}

}  // namespace

std::string simple_number(double number) {
  const auto fraction = [](double value) -> std::string {
    const std::string text = coefficient_text(value);
    const bool is_exact = text.find_first_of(".e") == std::string::npos && std::abs(value) < 1000;
    return is_exact && text != "0" ? text : "";
  };
  if (const std::string plain = fraction(number); !plain.empty()) return plain;
  const std::string sign = number < 0 ? "−" : "";
  if (const std::string square = fraction(number * number); !square.empty())
    return sign + "√" + (square.find('/') == std::string::npos ? square : "(" + square + ")");
  if (const std::string multiple = fraction(std::abs(number) / std::numbers::pi); !multiple.empty())
    return sign + (multiple == "1" ? "π" : multiple + "·π");
  if (const std::string over = fraction(std::abs(number) * std::numbers::pi); !over.empty()) {
    const std::size_t slash = over.find('/');
    return slash == std::string::npos ? fmt::format("{}{}/π", sign, over)
                                      : fmt::format("{}{}/({}π)", sign, over.substr(0, slash), over.substr(slash + 1));
  }
  return "";
}

namespace {

/// "times 2·m/(r²·g)" or "divided by r²"
std::string factor_text(const std::string& coefficient, const std::vector<InputPower>& powers) {
  std::vector<std::string> above, below;
  const bool is_fraction = coefficient.find_first_not_of("−0123456789/") == std::string::npos;
  const std::size_t slash = is_fraction ? coefficient.find('/') : std::string::npos;
  if (const std::string number = coefficient.substr(0, slash); number != "1") above.push_back(number);
  if (slash != std::string::npos) below.push_back(coefficient.substr(slash + 1));
  for (const InputPower& each : powers) (each.exponent > 0 ? above : below).push_back(text_of(each));
  const std::string divisor = fmt::format(fmt::runtime(below.size() > 1 ? "({})" : "{}"), fmt::join(below, "·"));
  if (above.empty()) return "divided by " + divisor;
  if (above.size() > 1 && above.front() == "−1") {
    above.erase(above.begin());
    above.front().insert(0, "−");
  }
  return fmt::format("times {}{}", fmt::join(above, "·"), below.empty() ? "" : "/" + divisor);
}

/// The quantities, their sines and cosines, the components of the result that are right, lengths of vectors and
/// of L, sums and differences of what has the same unit: those that vary and are nowhere zero at the cases, the
/// simplest first.
std::vector<Column> columns_at(const ExerciseReference& exercise, const std::set<std::size_t>& wrong,
                               const std::vector<std::size_t>& rows) {
  std::vector<Column> columns;
  const auto add = [&](const std::string& name, const std::function<double(std::size_t)>& value_at) {
    VectorXd values(static_cast<Index>(rows.size()));
    for (std::size_t k = 0; k < rows.size(); ++k) values[static_cast<Index>(k)] = value_at(rows[k]);
    Column column = column_of(name, values);
    const VectorXd& size = column.logarithm;
    if (!size.allFinite() || size.maxCoeff() - size.minCoeff() < 1e-3) return;
    const bool is_known = std::ranges::any_of(columns, [&](const Column& other) {
      return (other.logarithm - size).cwiseAbs().maxCoeff() < logarithm_exactness;
    });
    if (!is_known && std::ssize(columns) < most_columns) columns.push_back(std::move(column));
  };
  const std::vector<Quantity> quantities = quantities_of(exercise);
  for (const Quantity& each : quantities) {
    if (!each.is_angle()) {
      add(each.name, [&](std::size_t i) { return each.values[i]; });
      continue;
    }
    add("sin(" + each.name + ")", [&](std::size_t i) { return std::sin(each.values[i]); });
    add("cos(" + each.name + ")", [&](std::size_t i) { return std::cos(each.values[i]); });
  }
  const Value& shape = exercise.cases.front().expected;
  for (std::size_t n = 0; n < shape.numbers.size() && shape.numbers.size() <= 3; ++n) {
    if (wrong.contains(n)) continue;
    const std::string name = entry_name(shape, exercise.result_kind, n);
    const auto number = [&, n](std::size_t i) { return exercise.cases[i].expected.numbers[n]; };
    if (exercise.result_units[exercise.result_units.size() == 1 ? 0 : n] == units::radian) {
      add("sin(" + name + ")", [&](std::size_t i) { return std::sin(number(i)); });
      add("cos(" + name + ")", [&](std::size_t i) { return std::cos(number(i)); });
    } else {
      add(name, number);
    }
  }
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    const Argument& argument = exercise.arguments[a];
    const auto numbers = [&](std::size_t i) {
      const std::vector<double>& all = exercise.cases[i].inputs[a].numbers;
      return Eigen::Map<const VectorXd>(all.data(), static_cast<Index>(all.size()));
    };
    if (argument.kind == Kind::vector3 || argument.kind == Kind::vector2)
      add("|" + argument.name + "|", [&](std::size_t i) { return numbers(i).norm(); });
    for (std::size_t b = 0; b < exercise.arguments.size(); ++b) {  // moments, or a tensor: the length of L
      const Argument& moments = exercise.arguments[b];
      const bool is_tensor = moments.kind == Kind::matrix3;
      if (argument.kind != Kind::vector3 || b == a || (moments.kind != Kind::vector3 && !is_tensor) ||
          !(moments.unit == units::moment_of_inertia))
        continue;
      add(fmt::format("|{} {}|", moments.name, argument.name), [&](std::size_t i) {
        const auto I = as_matrix(exercise.cases[i].inputs[b]);
        return is_tensor ? (I * numbers(i)).norm() : I.cwiseProduct(numbers(i)).norm();
      });
    }
    if (argument.kind != Kind::vector && argument.kind != Kind::points) continue;
    add("the number of entries of " + argument.name, [&](std::size_t i) {
      const Value& list = exercise.cases[i].inputs[a];
      return static_cast<double>(argument.kind == Kind::vector ? list.rows : list.cols);
    });
    if (argument.kind == Kind::vector)
      add("the sum of " + argument.name, [&](std::size_t i) { return numbers(i).sum(); });
  }
  for (const Quantity& one : quantities) {
    if (one.is_angle()) {
      add("sin(" + one.name + "/2)", [&](std::size_t i) { return std::sin(one.values[i] / 2); });
      add("cos(" + one.name + "/2)", [&](std::size_t i) { return std::cos(one.values[i] / 2); });
      add(one.name, [&](std::size_t i) { return one.values[i]; });
      continue;
    }
    if (one.unit == units::none) {
      for (const double sign : {1.0, -1.0}) {
        const char* const symbol = sign > 0 ? "+" : "−";
        add(fmt::format("(1 {} {})", symbol, one.name), [&](std::size_t i) { return 1 + sign * one.values[i]; });
        add(fmt::format("(1 {} {}²)", symbol, one.name),
            [&](std::size_t i) { return 1 + sign * one.values[i] * one.values[i]; });
      }
    }
    for (const Quantity& other : quantities) {
      if (&other <= &one || !(other.unit == one.unit)) continue;
      add(fmt::format("({} + {})", one.name, other.name),
          [&](std::size_t i) { return one.values[i] + other.values[i]; });
      const bool is_negative = !rows.empty() && one.values[rows[0]] < other.values[rows[0]];
      const Quantity &larger = is_negative ? other : one, &smaller = is_negative ? one : other;
      add(fmt::format("({} − {})", larger.name, smaller.name),
          [&](std::size_t i) { return larger.values[i] - smaller.values[i]; });
    }
  }
  return columns;
}

bool is_simple_exponent(double number) {
  return number != 0 && std::abs(number) <= largest_exponent && 2 * number == std::trunc(2 * number);
}
double to_exponent(double number) { return std::round(2 * number) / 2; }

/// The number that all rows are; 0 where they differ.
double common_number(const VectorXd& logarithm, const VectorXd& sign) {
  const double mean = logarithm.mean();
  const bool is_common =
      (logarithm.array() - mean).abs().maxCoeff() <= logarithm_exactness && (sign.array() == sign[0]).all();
  return is_common ? sign[0] * std::exp(mean) : 0;
}

/// The next choice of ascending numbers below n; false after the last one.
bool go_on(std::vector<Index>& chosen, Index n) {
  for (std::size_t k = chosen.size(); k-- > 0;) {
    if (++chosen[k] > n - static_cast<Index>(chosen.size() - k)) continue;
    std::iota(chosen.begin() + static_cast<std::ptrdiff_t>(k), chosen.end(), chosen[k]);
    return true;
  }
  return false;
}

/// What is c·q^k, c·q^k·p^l or with one power more; empty where none fits exactly.
std::string fitted(const Column& factor, const std::vector<Column>& columns) {
  const VectorXd& target = factor.logarithm;
  if (target.size() < 2 + spare_cases) return "";
  if (const double common = common_number(target, factor.sign); common != 0) {
    const std::string number = simple_number(common);
    return number == "−1" ? "with the other sign" : number.empty() || number == "1" ? "" : "times " + number;
  }
  const auto checked = [&](const std::vector<Index>& used, const VectorXd& exponents) -> std::string {
    VectorXd rest = target, sign = factor.sign;
    std::vector<InputPower> powers;
    for (std::size_t k = 0; k < used.size(); ++k) {
      const double exponent = to_exponent(exponents[static_cast<Index>(k)]);
      if (!is_simple_exponent(exponent)) return "";
      const Column& column = columns[static_cast<std::size_t>(used[k])];
      powers.emplace_back(column, exponent);
      rest -= exponent * column.logarithm;
      if (std::fmod(std::abs(exponent), 2) == 1) sign = sign.cwiseProduct(column.sign);
    }
    const std::string coefficient = simple_number(common_number(rest, sign));
    return coefficient.empty() ? "" : factor_text(coefficient, powers);
  };
  const VectorXd wanted = target.array() - target.mean();
  Matrix centred(target.size(), static_cast<Index>(columns.size()));
  for (Index k = 0; k < centred.cols(); ++k) {
    const VectorXd& logarithm = columns[static_cast<std::size_t>(k)].logarithm;
    centred.col(k) = logarithm.array() - logarithm.mean();
  }
  const Matrix squares = centred.transpose() * centred;
  const VectorXd products = centred.transpose() * wanted;
  for (const auto& [count, most] : {std::pair<Index, Index>{1, most_columns}, {2, most_columns}, {3, most_of_three}}) {
    const Index among = std::min(centred.cols(), most);
    if (target.size() < 1 + count + spare_cases || among < count) return "";
    std::vector<Index> used(static_cast<std::size_t>(count));
    std::iota(used.begin(), used.end(), 0);
    for (bool is_there = true; is_there; is_there = go_on(used, among)) {
      const Matrix of_used = squares(used, used);
      if (of_used.determinant() < 1e-6 * of_used.diagonal().prod()) continue;
      const VectorXd exponents = of_used.inverse() * products(used);
      if (const std::string text = checked(used, exponents); !text.empty()) return text;
    }
  }
  return "";
}

/// How one number of the result goes with the right one: "times cos(theta)"; empty if it is right or nothing fits.
struct Relation {
  bool is_wrong = false;
  std::string words = {};
};

Relation relation(const ExerciseReference& exercise, const Answers& answers, const std::set<std::size_t>& wrong,
                  std::size_t number, bool by_inputs, double (*of)(double)) {
  constexpr double telling = 1e-5;  // of the natural size
  std::vector<std::size_t> rows;
  std::vector<double> factors, products;
  Relation found;
  for (const std::size_t i : deciding_cases(exercise)) {
    const Case& one = exercise.cases[i];
    const double scale = of == nullptr ? scale_at(one, number) : 1;
    double y = answers[i]->numbers[number], e = one.expected.numbers[number];
    found.is_wrong = found.is_wrong || !(std::abs(y - e) <= one.tolerance * scale_at(one, number));
    if (of != nullptr) y = of(y), e = of(e);
    if (std::abs(e) <= telling * scale && std::abs(y) <= telling * scale) continue;
    if (std::abs(e) <= telling * scale || y == 0) return {true};
    rows.push_back(i);
    factors.push_back(y / e);
    products.push_back(y * e);
  }
  if (!found.is_wrong) return found;
  if (rows.empty()) return {true};
  const auto column = [](const std::vector<double>& values) {
    return column_of("", Eigen::Map<const VectorXd>(values.data(), static_cast<Index>(values.size())));
  };
  const Column product = column(products);
  if (std::ssize(products) > spare_cases &&
      std::abs(common_number(product.logarithm, product.sign) - 1) < logarithm_exactness)
    return {true, "as a reciprocal, 1 over it,"};
  found.words = fitted(column(factors), by_inputs ? columns_at(exercise, wrong, rows) : std::vector<Column>());
  return found;
}

/// @param of  what is compared of each number, if not itself
/// @param told_of  to stand before its name
std::optional<Reason> factor_of(const ExerciseReference& exercise, const Answers& answers, bool by_inputs,
                                double (*of)(double) = nullptr, const char* told_of = "") {
  if (exercise.comparison != Comparison::plain || exercise.result_kind == Kind::integer) return std::nullopt;
  if (!all_deciding_cases_answered(exercise, answers)) return std::nullopt;
  const Value& shape = exercise.cases.front().expected;
  if (!std::ranges::all_of(deciding_cases(exercise), [&](std::size_t i) {
        return answers[i]->is_finite() && exercise.cases[i].expected.has_shape_of(shape);
      }))
    return std::nullopt;
  const std::set<std::size_t> wrong = wrong_entries(exercise, answers);
  std::vector<std::string> names;
  std::string words;
  for (std::size_t n = 0; n < shape.numbers.size(); ++n) {
    const Relation found = relation(exercise, answers, wrong, n, by_inputs, of);
    if (!found.is_wrong) continue;
    if (found.words.empty() || (!words.empty() && words != found.words)) return std::nullopt;
    words = found.words;
    names.push_back(entry_name(shape, exercise.result_kind, n));
  }
  if (names.empty()) return std::nullopt;
  const bool is_whole = names.size() == shape.numbers.size();
  return Reason{ReasonKind::transform, "missing_factor",
                of != nullptr
                    ? fmt::format("{}your result is that of the expected one {} at every case.", told_of, words)
                : is_whole ? fmt::format("Your result is the expected one {} at every case.", words)
                           : fmt::format("In your result {} {} {} at every case; all else is right.", listed(names),
                                         names.size() == 1 ? "is the expected one" : "are the expected ones", words),
                // A change in the file may say more simply how such a factor came about.
                words.find(" − ") == std::string::npos && words.find(" + ") == std::string::npos ? Weight::cause
                                                                                                 : Weight::possible};
}

/// Of a number, or of functions of an angle.
std::optional<Reason> factor_or_of_angle(const ExerciseReference& exercise, const Answers& answers, bool by_inputs) {
  if (const auto found = factor_of(exercise, answers, by_inputs)) return found;
  if (exercise.result_kind != Kind::number || exercise.result_units != std::vector{units::radian}) return std::nullopt;
  if (const auto found = factor_of(exercise, answers, by_inputs, &std::tan, "The tangent of ")) return found;
  if (const auto found = factor_of(exercise, answers, by_inputs, &std::sin, "The sine of ")) return found;
  return factor_of(exercise, answers, by_inputs, &std::cos, "The cosine of ");
}

}  // namespace

std::optional<Reason> diagnose_number(const ExerciseReference& exercise, const Answers& answers) {
  return factor_or_of_angle(exercise, answers, false);
}

std::optional<Reason> diagnose_factor(const ExerciseReference& exercise, const Answers& answers) {
  return factor_or_of_angle(exercise, answers, true);
}

}  // namespace workbook
