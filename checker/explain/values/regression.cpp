// By what a wrong component differs from the right one: its error as one or two products of the inputs. Whether a term
// is missing or has another sign, the error does not tell.
#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace workbook {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int most_factors = 4;          // of one product, without sines and cosines
constexpr int most_angle_functions = 2;  // of one product
constexpr std::size_t most_products = 2500;
constexpr std::size_t most_products_in_pairs = 900;
constexpr Index spare_equations = 5;  // an exact fit of so many more equations than unknowns is no accident
constexpr double exactness = 1e-8;    // of the natural size
constexpr std::size_t most_components_named = 3;

struct Product {
  std::string name;
  VectorXd values;  ///< at the rows of the fit
  int factors = 0;
};

struct FittedProduct {
  double coefficient;
  const Product* product;
};

/// The cases at which the student's answer can be used.
std::vector<std::size_t> usable_cases(const Answers& answers) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i] && answers[i]->is_finite()) rows.push_back(i);
  }
  return rows;
}

VectorXd at_rows(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  VectorXd chosen(static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) chosen[static_cast<Index>(k)] = values[rows[k]];
  return chosen;
}

/// Products of quantities with a given dimension, times sines and cosines of the angles.
class Products {
 public:
  Products(const std::vector<Quantity>& quantities, const std::vector<std::size_t>& rows) : rows_(rows) {
    for (const Quantity& quantity : quantities) {
      if (quantity.is_angle()) {
        const VectorXd angle = at_rows(quantity.values, rows);
        angle_functions_.push_back({fmt::format("sin({})", quantity.name), angle.array().sin(), 0});
        angle_functions_.push_back({fmt::format("cos({})", quantity.name), angle.array().cos(), 0});
      } else {
        quantities_.push_back(&quantity);
      }
    }
  }

  /// Empty if there would be too many to be sure of any.
  std::vector<Product> of(Unit unit) {
    unit_ = unit;
    found_.clear();
    extend({"", VectorXd::Ones(static_cast<Index>(rows_.size())), 0}, {}, 0);
    std::vector<Product> all;
    for (const Product& plain : found_) {
      add_angles(all, plain, 0, most_angle_functions);
      if (all.size() > most_products) return {};
    }
    return all;
  }

 private:
  static bool has_dimension_of(Unit one, Unit other) {
    return one.kilogram == other.kilogram && one.metre == other.metre && one.second == other.second;
  }

  void extend(const Product& product, Unit unit, std::size_t first) {
    if (found_.size() > most_products) return;
    const bool is_pure_number = product.factors == 0;
    if (has_dimension_of(unit, unit_) && (!is_pure_number || has_dimension_of(unit_, {}))) found_.push_back(product);
    if (product.factors == most_factors) return;
    for (std::size_t q = first; q < quantities_.size(); ++q) {
      const Quantity& quantity = *quantities_[q];
      const Unit larger = unit * quantity.unit;
      // Factors only ever raise the powers of mass and length, so what is too high already stays so.
      if (quantity.unit == units::none ? product.factors >= 2 : larger.kilogram > unit_.kilogram) continue;
      extend({product.name + (product.name.empty() ? "" : "·") + quantity.name,
              product.values.cwiseProduct(at_rows(quantity.values, rows_)), product.factors + 1},
             larger, q);
    }
  }

  void add_angles(std::vector<Product>& all, const Product& product, std::size_t first, int left) const {
    if (product.values.cwiseAbs().maxCoeff() > 0) all.push_back(product);
    if (left == 0) return;
    for (std::size_t k = first; k < angle_functions_.size(); ++k) {
      const Product& function = angle_functions_[k];
      add_angles(all,
                 {product.name + (product.name.empty() ? "" : "·") + function.name,
                  product.values.cwiseProduct(function.values), product.factors},
                 k, left - 1);
    }
  }

  const std::vector<std::size_t>& rows_;
  std::vector<const Quantity*> quantities_;
  std::vector<Product> angle_functions_;
  Unit unit_;
  std::vector<Product> found_;
};

/// Is the number a fraction that a formula may have?
bool is_simple(double coefficient) {
  const std::string text = coefficient_text(coefficient);
  return text != "0" && text.find('.') == std::string::npos && text.find('e') == std::string::npos && text.size() <= 6;
}

/// The error as exactly one, or else exactly two of the products; empty if none, or more than one choice, fits.
std::vector<FittedProduct> fit(const VectorXd& error, const std::vector<Product>& products, int most_terms) {
  const Index rows = error.size();
  std::vector<std::vector<FittedProduct>> fits;
  const auto is_exact = [&](const VectorXd& rest) { return rest.cwiseAbs().maxCoeff() <= exactness; };
  if (rows < 1 + spare_equations) return {};
  for (const Product& product : products) {
    const double coefficient = product.values.dot(error) / product.values.squaredNorm();
    if (is_exact(error - coefficient * product.values) && is_simple(coefficient))
      fits.push_back({{coefficient, &product}});
  }
  if (!fits.empty()) return fits.size() == 1 ? fits.front() : std::vector<FittedProduct>{};
  if (most_terms < 2 || products.size() > most_products_in_pairs || rows < 2 + spare_equations) return {};
  for (std::size_t a = 0; a < products.size(); ++a) {
    const VectorXd direction = products[a].values.normalized();
    const VectorXd rest = error - direction.dot(error) * direction;
    for (std::size_t b = a + 1; b < products.size(); ++b) {
      const VectorXd& other = products[b].values;
      const double along = direction.dot(other);
      const double square = other.squaredNorm() - along * along;
      if (square <= 1e-12 * other.squaredNorm()) continue;
      const double second = rest.dot(other) / square;  // rest is orthogonal to the direction
      if (!is_simple(second)) continue;
      const double first = direction.dot(error - second * other) / products[a].values.norm();
      if (!is_simple(first) || !is_exact(error - first * products[a].values - second * other)) continue;
      fits.push_back({{first, &products[a]}, {second, &products[b]}});
      if (fits.size() > 1) return {};
    }
  }
  return fits.empty() ? std::vector<FittedProduct>{} : fits.front();
}

std::string with_coefficient(double size, const std::string& factors) {
  const std::string text = coefficient_text(size);
  const std::string product = replaced(factors, R"((?<![^·/])([^·/]+)·\1(?=·|/|$))", "$1²");
  return text == "1" ? (product.empty() ? "1" : product) : product.empty() ? text : text + "·" + product;
}

/// "is too small by omega[0]·omega[1]", "is too large by g·(1 - cos(latitude))"
std::string difference(const std::vector<FittedProduct>& terms) {
  std::string text;
  const auto side = [](const FittedProduct& term) { return term.coefficient < 0 ? "small" : "large"; };
  if (terms.size() == 2 && coefficient_text(terms[0].coefficient) == coefficient_text(-terms[1].coefficient))
    for (const auto& [whole, part] : {std::pair(terms[0], terms[1]), std::pair(terms[1], terms[0])})
      if (const std::string beginning = whole.product->name + "·"; part.product->name.starts_with(beginning))
        return fmt::format("is too {} by {}(1 - {})", side(whole),
                           with_coefficient(std::abs(whole.coefficient), beginning),
                           part.product->name.substr(beginning.size()));
  for (const FittedProduct& term : terms) {
    const std::string size = with_coefficient(std::abs(term.coefficient), term.product->name);
    text += fmt::format("{}too {} by {}", text.empty() ? "is " : " and ", side(term), size);
  }
  return text;
}

/// Fits errors by products, and if need be by products over one of the quantities.
class Fitter {
 public:
  Fitter(const std::vector<Quantity>& quantities, const std::vector<std::size_t>& rows, int most_terms)
      : quantities_(quantities), rows_(rows), most_terms_(most_terms), products_(quantities, rows) {}

  /// "is too small by omega[0]·omega[1]"; empty where nothing fits.
  std::string words(const VectorXd& error, const VectorXd& scale, Unit unit) {
    std::string plain = words_over(error, scale, unit, nullptr);
    if (!plain.empty()) return plain;
    for (const Quantity& divisor : quantities_) {
      if (divisor.unit == units::none || divisor.is_angle()) continue;
      if (at_rows(divisor.values, rows_).cwiseAbs().minCoeff() == 0) continue;
      std::string ratio = words_over(error, scale, unit, &divisor);
      if (!ratio.empty()) return ratio;
    }
    return "";
  }

 private:
  std::string words_over(const VectorXd& error, const VectorXd& scale, Unit unit, const Quantity* divisor) {
    const Unit product_unit = divisor == nullptr ? unit : unit * divisor->unit;
    const std::string key = to_string(product_unit);
    if (!known_.contains(key)) known_[key] = products_.of(product_unit);
    std::vector<Product> candidates = known_[key];
    const VectorXd below = divisor == nullptr ? scale : scale.cwiseProduct(at_rows(divisor->values, rows_)).eval();
    for (Product& product : candidates) {
      product.values = product.values.cwiseQuotient(below);
      if (divisor != nullptr) product.name = (product.name.empty() ? "1" : product.name) + "/" + divisor->name;
    }
    return difference(fit(error, candidates, most_terms_));
  }

  const std::vector<Quantity>& quantities_;
  const std::vector<std::size_t>& rows_;
  const int most_terms_;
  Products products_;
  std::map<std::string, std::vector<Product>> known_;
};

/// What is compared of a number of the result.
struct ComparedPower {
  int exponent;
  const char* of;  ///< to stand before its name
};

/// The differences of all wrong numbers, or of their powers; nothing where one of them is not explained.
std::optional<Reason> differences(const ExerciseReference& exercise, const Answers& answers, const ComparedPower& power,
                                  int most_terms) {
  if (exercise.comparison != Comparison::plain) return std::nullopt;
  const Value& shape = exercise.cases.front().expected;
  if (!std::ranges::all_of(exercise.cases, [&](const Case& one) { return one.expected.has_shape_of(shape); }))
    return std::nullopt;
  const std::vector<std::size_t> rows = usable_cases(answers);
  const std::vector<Quantity> quantities = quantities_of(exercise);
  if (quantities.empty() || rows.size() < 1 + spare_equations) return std::nullopt;

  Fitter fitter(quantities, rows, most_terms);
  std::string sentence;
  std::size_t wrong = 0;
  for (std::size_t n = 0; n < shape.numbers.size(); ++n) {
    VectorXd error(static_cast<Index>(rows.size()));
    VectorXd scale(error.size());
    bool is_wrong = false, is_positive = true;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const Case& one = exercise.cases[rows[k]];
      const auto row = static_cast<Index>(k);
      const double yours = answers[rows[k]]->numbers[n], right = one.expected.numbers[n];
      is_wrong = is_wrong || !(std::abs(yours - right) <= one.tolerance * scale_at(one, n));
      is_positive = is_positive && yours > 0 && right > 0;
      scale[row] = power.exponent == 1 ? scale_at(one, n) : std::pow(right, power.exponent);
      error[row] = (std::pow(yours, power.exponent) - std::pow(right, power.exponent)) / scale[row];
    }
    if (!is_wrong) continue;
    if (++wrong > most_components_named || (power.exponent != 1 && !is_positive)) return std::nullopt;
    const Unit of_result = exercise.result_units[exercise.result_units.size() == 1 ? 0 : n];
    Unit unit;
    for (int k = 0; k < std::abs(power.exponent); ++k) unit = power.exponent > 0 ? unit * of_result : unit / of_result;
    const std::string words = fitter.words(error, scale, unit);
    if (words.empty()) return std::nullopt;
    const bool is_whole = shape.numbers.size() == 1;
    const std::string name = is_whole ? "your result" : entry_name(shape, exercise.result_kind, n);
    sentence += (sentence.empty() ? is_whole ? "" : "in your result " : "; ") + (power.of + name) + " " + words;
  }
  if (wrong == 0) return std::nullopt;
  if (shape.numbers.size() > wrong) sentence += "; all else is right";
  return Reason{ReasonKind::difference, "difference", capitalized(sentence) + "."};
}

}  // namespace

std::optional<Reason> diagnose_one_term(const ExerciseReference& exercise, const Answers& answers) {
  return differences(exercise, answers, {1, ""}, 1);
}

std::optional<Reason> diagnose_difference(const ExerciseReference& exercise, const Answers& answers) {
  constexpr ComparedPower powers[] = {{2, "the square of "}, {-1, "one over "}, {-2, "one over the square of "}};
  if (const auto found = differences(exercise, answers, {1, ""}, 2)) return found;
  for (const ComparedPower& power : powers)
    if (const auto found = differences(exercise, answers, power, 1)) return found;
  return std::nullopt;
}

}  // namespace workbook
