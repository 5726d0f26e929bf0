#include "solutions/judging/corners.hpp"

#include "checker/base/text.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/judging/comparison.hpp"
#include "solutions/judging/mechanics.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>

namespace workbook::judging {

namespace {

constexpr std::size_t most_bases = 3;  // described cases that others are made from

bool is_symmetric(const Value& matrix) {
  const auto m = as_matrix(matrix);
  return m.rows() == m.cols() && (m - m.transpose()).norm() <= 1e-12 * m.norm();
}

/// One number of an argument that can be changed by itself: of a symmetric matrix together with its mirror image.
struct Handle {
  std::size_t argument;
  std::size_t entry;
  std::string name;
  Unit unit;
  bool has_mirror = false;

  /// A list of another case may be shorter.
  bool is_in(const Values& inputs) const { return entry < inputs[argument].numbers.size(); }
  double get(const Values& inputs) const { return inputs[argument].numbers[entry]; }
  void set(Values& inputs, double number) const {
    inputs[argument].numbers[entry] = number;
    if (has_mirror) inputs[argument].numbers[entry % 3 * 3 + entry / 3] = number;
  }
};

std::string entry_name(const Argument& argument, std::size_t entry) {
  if (argument.kind == Kind::vector) return fmt::format("{}[{}]", argument.name, entry);
  if (argument.kind == Kind::points) return fmt::format("{}({},{})", argument.name, entry % 3, entry / 3);
  return argument.name + entry_suffix(argument.kind, entry);
}

std::vector<Handle> handles_of(const ExerciseReference& exercise, const Values& inputs) {
  std::vector<Handle> handles;
  for (std::size_t a = 0; a < inputs.size(); ++a) {
    const Argument& argument = exercise.arguments[a];
    if (argument.kind == Kind::integer || argument.kind == Kind::matrices) continue;
    const bool mirrored = argument.kind == Kind::matrix3 && is_symmetric(inputs[a]);
    for (std::size_t n = 0; n < std::min<std::size_t>(inputs[a].numbers.size(), argument.kind == Kind::matrix3 ? 9 : 4);
         ++n) {
      if (mirrored && n % 3 > n / 3) continue;
      handles.push_back({a, n, entry_name(argument, n), argument.unit, mirrored && n % 3 != n / 3});
    }
  }
  return handles;
}

/// "omega_2 = 0", "omega_2 × 1.37".
std::string scaled(const std::string& name, double factor) {
  return factor == 0 ? name + " = 0" : factor == -1 ? "−" + name : fmt::format("{} × {:.3g}", name, factor);
}

/// Puts every number through f.
auto each(std::function<double(double)> f) {
  return [f = std::move(f)](Value& value) { std::ranges::transform(value.numbers, value.numbers.begin(), f); };
}

void scale(Value& value, double factor) {
  for (double& number : value.numbers) number *= factor;
}

double norm(const Value& value) { return as_matrix(value).norm(); }

/// None larger than the sum of the others.
bool has_moments_of_body(const Value& value) {
  const Vector3d moments = as_matrix(value);
  return 2 * moments.maxCoeff() <= moments.sum() * (1 + 1e-9);
}

/// All candidates, cases without results so far, that are made from one described case.
class Neighbours {
 public:
  Neighbours(const ExerciseReference& exercise, std::size_t base)
      : exercise_(exercise),
        base_(base),
        inputs_(exercise.cases[base].inputs),
        handles_(handles_of(exercise, inputs_)) {}

  std::vector<Case> all() {
    single_numbers({0, -1, 1.37, 1e-3, 1e-6});
    whole_arguments({0, -1, 1e-3, 1e-2, 1. / 30, 30, 1e2, 1e3});
    equalities();
    units_together();
    directions();
    single_axes();
    angles();
    relations();
    return std::move(found_);
  }

  /// Every number and every argument somewhat changed: enough to see on what a result depends.
  std::vector<Case> probes() {
    single_numbers({1.37});
    whole_arguments({2});
    return std::move(found_);
  }

  /// Besides these every number and every argument through all orders of magnitude, times but a few, and every rotation
  /// matrix next to those with zeros.
  std::vector<Case> dense() {
    for (int decade = -12; decade <= 4; ++decade) {
      const double factor = std::pow(10.0, decade);
      for (const Handle& handle : handles_) {
        for (const double number : {0.7 * factor, -0.7 * factor}) {
          if (handle.unit == units::second && decade > 1) continue;
          Values changed = inputs_;
          handle.set(changed, number);
          add(fmt::format("{} = {:.3g}", handle.name, number), changed);
        }
      }
      for (std::size_t a = 0; a < inputs_.size(); ++a) {
        if (exercise_.arguments[a].unit == units::second && decade > 1) continue;
        Values changed = inputs_;
        scale(changed[a], factor);
        add(scaled(name_of(a), factor), changed);
      }
    }
    for (std::size_t a = 0; a < inputs_.size(); ++a) {
      if (exercise_.arguments[a].kind == Kind::matrix3 && !is_symmetric(inputs_[a])) attitudes(a);
    }
    return all();
  }

 private:
  const std::string& name_of(std::size_t argument) const { return exercise_.arguments[argument].name; }

  /// No argument is out of all proportion to that of the described case, and moments that are a body's stay so.
  bool is_real(const Values& inputs) const {
    constexpr double most = 1e6;
    for (std::size_t a = 0; a < inputs.size(); ++a) {
      const Argument& argument = exercise_.arguments[a];
      if (argument.kind == Kind::integer || argument.unit == units::radian) continue;
      const double ratio = norm(inputs[a]) / norm(inputs_[a]);
      if (ratio > most || (ratio > 0 && ratio < 1 / most)) return false;
      if (argument.kind == Kind::vector3 && argument.unit == kg_m2 && has_moments_of_body(inputs_[a]) &&
          !has_moments_of_body(inputs[a]))
        return false;
    }
    return true;
  }

  void add(const std::string& name, Values inputs, int argument = -1, int entry = -1) {
    if (!is_real(inputs)) return;
    add_in_any_unit(name, std::move(inputs), argument, entry);
    // What has this case's size somewhere on a sound way is rounded like it, however small the result may be.
    found_.back().scale = exercise_.cases[base_].scale;
  }

  void add_in_any_unit(const std::string& name, Values inputs, int argument = -1, int entry = -1) {
    Case& made = found_.emplace_back();
    made.name = fmt::format("{} ({})", name, exercise_.cases[base_].name);
    made.inputs = std::move(inputs);
    made.base = static_cast<int>(base_);
    made.argument = argument;
    made.entry = entry;
  }

  void single_numbers(const std::vector<double>& factors) {
    for (const Handle& handle : handles_) {
      for (const double factor : factors) set(handle, factor * handle.get(inputs_), scaled(handle.name, factor));
    }
  }

  void whole_arguments(const std::vector<double>& factors) {
    for (std::size_t a = 0; a < inputs_.size(); ++a) {
      const Unit unit = exercise_.arguments[a].unit;
      if (exercise_.arguments[a].kind == Kind::integer || unit == units::radian) continue;
      for (const double factor : factors) {
        if (unit == units::second && (factor > 30 || factor < 0)) continue;
        Values changed = inputs_;
        scale(changed[a], factor);
        add(scaled(name_of(a), factor), changed, static_cast<int>(a));
      }
    }
  }

  void equalities() {
    for (std::size_t i = 0; i < handles_.size(); ++i) {
      for (std::size_t k = i + 1; k < handles_.size(); ++k) {
        if (!(handles_[i].unit == handles_[k].unit) || handles_[i].unit == units::none) continue;
        for (const double factor : {1.0, -1.0, 1 + 1e-3, 1 + 1e-6}) {
          Values changed = inputs_;
          handles_[k].set(changed, factor * handles_[i].get(inputs_));
          const std::string sign_or_factor = factor == 1 ? "" : factor == -1 ? "−" : fmt::format("{} ", factor);
          add(handles_[k].name + " = " + sign_or_factor + handles_[i].name, changed);
        }
      }
    }
  }

  /// A rotation matrix close to one with zeros. What else is no symmetric matrix turns along: a rate of it stays one.
  void attitudes(std::size_t a) {
    const Vector3d axes[] = {x_axis, y_axis, z_axis};
    for (const Vector3d& about : axes) {
      for (const Vector3d& off : axes) {
        for (const double angle : {0.0, pi / 2, pi}) {
          for (const double small : {0.1, 1e-2, 3e-3, 3e-4, 1e-5, 1e-7, 1e-10}) {
            const Matrix3d wanted = turn(about, angle) * turn(off, small);
            Values changed = inputs_;
            for (std::size_t b = 0; b < inputs_.size(); ++b) {
              if (exercise_.arguments[b].kind == Kind::matrix3 && !is_symmetric(inputs_[b]))
                changed[b] = to_value(wanted * as_matrix(inputs_[a]).transpose() * as_matrix(inputs_[b]));
            }
            add(fmt::format("{} turned by {:.3g} about {} and {} about {}", name_of(a), angle, "xyz"[&about - axes],
                            small, "xyz"[&off - axes]),
                changed);
          }
        }
      }
    }
  }

  void units_together() {
    const auto power = [](Unit unit, char base) {
      return base == 'k' ? unit.kilogram : base == 'm' ? unit.metre : unit.second;
    };
    for (const char base : {'k', 'm', 's'}) {
      for (const double factor : {1e-6, 1e-3, 1e3, 1e6}) {
        Values changed = inputs_;
        for (std::size_t a = 0; a < changed.size(); ++a)
          scale(changed[a], std::pow(factor, power(exercise_.arguments[a].unit, base)));
        if (changed != inputs_)
          add_in_any_unit(scaled(base == 'k'   ? "all masses"
                                 : base == 'm' ? "all lengths"
                                               : "all times",
                                 factor),
                          changed);
      }
    }
  }

  void directions() {
    for (std::size_t a = 0; a < inputs_.size(); ++a) {
      if (exercise_.arguments[a].kind != Kind::vector3 || !(exercise_.arguments[a].unit == units::none)) continue;
      for (const double length : {0.9, 0.95, 0.99, 0.999, 1.0, 1.001, 1.01, 1.05, 1.1}) {
        Values changed = inputs_;
        scale(changed[a], length / norm(inputs_[a]));
        add(fmt::format("{} of length {}", name_of(a), length), changed);
      }
    }
  }

  /// Vectors along one axis; those in a coordinate plane have one component zero. In several lengths: whether a
  /// difference that should be zero comes out negative is a matter of rounding.
  void single_axes() {
    for (std::size_t a = 0; a < inputs_.size(); ++a) {
      if (exercise_.arguments[a].kind != Kind::vector3) continue;
      for (std::size_t n = 0; n < 3; ++n) {
        for (const double length : {1.0, 1.1, 1.3, 0.7, 0.9}) {
          Values changed = inputs_;
          for (std::size_t k = 0; k < 3; ++k) changed[a].numbers[k] *= k == n ? length : 0;
          add(fmt::format("{}[{}] alone{}, its other components 0", name_of(a), n,
                          length == 1 ? "" : fmt::format(" × {}", length)),
              changed);
        }
      }
    }
  }

  void angles() {
    for (const Handle& handle : handles_) {
      if (!(handle.unit == units::radian)) continue;
      for (const double around : {0.0, pi / 2, pi, -pi / 2}) {
        for (const double off : {0.0, 1e-6, -1e-3, 1e-2}) set_angle(handle, around + off);
      }
      for (const double angle : {-0.7, 4.0, 2 * pi + 0.4, -pi - 0.4, 20.3}) set_angle(handle, angle);
    }
  }

  void set_angle(const Handle& handle, double angle) {
    set(handle, angle, fmt::format("{} = {:.7g}", handle.name, angle));
  }

  void set(const Handle& handle, double number, const std::string& name) {
    Values changed = inputs_;
    handle.set(changed, number);
    add(name, changed, static_cast<int>(handle.argument), static_cast<int>(handle.entry));
  }

  void relations() {
    for (std::size_t a = 0; a < inputs_.size(); ++a) {
      const Argument& argument = exercise_.arguments[a];
      Values changed = inputs_;
      if (argument.kind == Kind::matrix3 && is_symmetric(inputs_[a])) {
        changed[a] = to_value(Matrix3d::Identity() * as_matrix(inputs_[a]).trace() / 3);
        add(name_of(a) + " a multiple of the unit matrix", changed);
        changed[a] = to_value(diagonal_part(as_matrix(inputs_[a])));
        add(name_of(a) + " diagonal", changed);
      } else if (argument.kind == Kind::matrix3) {
        // Small turns and what lacks little of half a turn: where a guard or a series may reach too far.
        const Vector3d oblique = Vector3d(1, 2, 2) / 3;
        const std::pair<const char*, Matrix3d> turns[] = {
            {"the unit matrix", Matrix3d::Identity()}, {"a quarter turn about x", turn(x_axis, pi / 2)},
            {"half a turn about z", turn(z_axis, pi)}, {"a turn by 0.003", turn(oblique, 0.003)},
            {"a turn by 0.05", turn(oblique, 0.05)},   {"half a turn less 0.05", turn(oblique, pi - 0.05)}};
        for (const auto& [name, A] : turns) {
          changed[a] = to_value(A);
          add(name_of(a) + " " + name, changed);
        }
      }
      if (argument.kind != Kind::vector3) continue;
      for (std::size_t b = 0; b < inputs_.size(); ++b) {
        if (b == a || exercise_.arguments[b].kind != Kind::vector3) continue;
        const Vector3d u = as_matrix(inputs_[a]), v = as_matrix(inputs_[b]);
        const std::pair<const char*, Vector3d> relatives[] = {
            {"parallel to", u * (v.norm() / u.norm())},
            {"minus", -u},
            {"equal to", u},
            {"at right angles to", v - u * (u.dot(v) / u.squaredNorm())}};
        for (const auto& [relation, w] : relatives) {
          changed[b] = to_value(w);
          add(fmt::format("{} {} {}", name_of(b), relation, name_of(a)), changed);
        }
        changed[b] = inputs_[b];
      }
    }
  }

  const ExerciseReference& exercise_;
  std::size_t base_;
  const Values& inputs_;
  std::vector<Handle> handles_;
  std::vector<Case> found_;
};

/// The described cases that others are made from: generic ones.
std::vector<std::size_t> bases_of(const ExerciseReference& exercise) {
  std::vector<std::size_t> bases;
  for (std::size_t i = 0; i < exercise.cases.size() && bases.size() < most_bases; ++i) {
    if (exercise.cases[i].group == Group::random) bases.push_back(i);
  }
  return bases;
}

std::vector<Case> dense_sample(const Subject& subject) {
  std::vector<Case> sample;
  for (const std::size_t base : bases_of(subject.described))
    std::ranges::move(Neighbours(subject.described, base).dense(), std::back_inserter(sample));
  return sample;
}

/// What a function gives, or nothing where it throws or its result is not finite.
std::optional<Value> attempt(const std::function<Value(const Values&)>& function, const Values& inputs) {
  try {
    Value value = function(inputs);
    if (value.is_finite() && value.is_complete()) return value;
  } catch (const std::exception&) {
  }
  return std::nullopt;
}

/// What decides whether an answer passes, and nothing else: it is copied for every answer.
ExerciseReference without_outputs(const ExerciseReference& exercise, const Case& one) {
  ExerciseReference alone;
  alone.name = exercise.name;
  alone.arguments = exercise.arguments;
  alone.result_kind = exercise.result_kind;
  alone.result_units = exercise.result_units;
  alone.comparison = exercise.comparison;
  alone.cases = {one};
  return alone;
}

bool passes_at(const Subject& subject, const Case& one, const std::optional<Value>& value) {
  return value && passes(without_outputs(subject.described, one), 0, *value);
}

/// This candidate with the reference's value, be it within the reach of other routes or not.
std::optional<Case> unchecked_case_at(const Subject& subject, const Case& candidate) {
  if (!std::ranges::all_of(candidate.inputs, &Value::is_finite) || !subject.legal(candidate.inputs))
    return std::nullopt;
  try {
    return subject.judged(candidate);
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

/// Every number of these inputs moved by a few units in its last place, up or down.
Values rounded_otherwise(Values inputs, unsigned pattern) {
  constexpr double shift = 4 * std::numeric_limits<double>::epsilon();
  for (Value& input : inputs)
    for (double& number : input.numbers) {
      pattern = pattern * 1664525 + 1013904223;
      number *= 1 + (pattern >> 31 != 0 ? shift : -shift);
    }
  return inputs;
}

/// A case of this candidate, if it is legal and all routes agree there. They must agree better than an answer must, so
/// that a right answer by yet another route passes.
std::optional<Case> case_at(const Subject& subject, const Case& candidate) {
  std::optional<Case> one = unchecked_case_at(subject, candidate);
  if (!one) return std::nullopt;
  Case strict = *one;
  strict.tolerance /= 5;
  const auto agrees = [&](const auto& route) { return passes_at(subject, strict, attempt(route, strict.inputs)); };
  if (!std::ranges::all_of(subject.routes, agrees)) return std::nullopt;
  if (!make_answerable(*one, subject.described, subject.right)) return std::nullopt;
  return one;
}

// --- small whole numbers

constexpr std::size_t rungs = 7, most_rungs = 3;

Vector3d small_vector(std::size_t rung, std::size_t argument) {
  const Vector3d axis = Vector3d::Unit(static_cast<Eigen::Index>(argument % 3));
  if (rung < 2) return rung == 0 ? axis : Vector3d::Ones() - axis;
  const Vector3d vectors[] = {{1, 2, 3}, {2, -1, 1}, {1, 1, -2}, {3, 0, 1}, {0, 2, -1}};
  return vectors[(argument + rung) % 5];
}

Matrix3d small_tensor(std::size_t rung) {
  if (rung < 2) return Vector3d(1, 1.0 + static_cast<double>(rung), 1.0 + static_cast<double>(rung)).asDiagonal();
  return Matrix3d{{3, -1, 0}, {-1, 3, 0}, {0, 0, 4}} * std::pow(10.0, static_cast<double>(rung - 2) / 2);
}

Matrix3d small_rotation(std::size_t rung) {
  const Matrix3d rotations[] = {Matrix3d::Identity(), Matrix3d{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                                Matrix3d{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
  return rotations[std::min<std::size_t>(rung, 2)];
}

Eigen::MatrixXd small_input(const Argument& argument, std::size_t a, std::size_t rung) {
  const auto n = static_cast<double>(rung + 1);
  const bool is_angle = argument.unit == units::radian;
  const auto count = static_cast<Eigen::Index>(std::min<std::size_t>(rung, 2) + 1);
  switch (argument.kind) {
    case Kind::number:
      return Eigen::MatrixXd::Constant(1, 1, is_angle ? n - 1 : rung == 0 ? 1 : n + static_cast<double>(a) - 1);
    case Kind::integer:
      return Eigen::MatrixXd::Constant(1, 1, static_cast<double>(rung % 3));
    case Kind::vector2:
      return small_vector(rung, a).head<2>();
    case Kind::vector3:
      if (is_angle) return Vector3d(rung > 0 ? 1 : 0, rung > 1 ? 2 : 1, rung > 1 ? 3 : 0);
      if (argument.unit == units::kilogram * units::metre * units::metre)
        return rung < 2 ? Vector3d(1, n, n) : Vector3d(2, 3, 4);
      return small_vector(rung, a);
    case Kind::vector:
      return VectorXd::LinSpaced(count, 1, static_cast<double>(count));
    case Kind::points: {
      Eigen::MatrixXd points(3, count);
      for (Eigen::Index k = 0; k < count; ++k) points.col(k) = small_vector(rung, static_cast<std::size_t>(k));
      return points;
    }
    case Kind::matrix3:
      return argument.unit == units::none ? small_rotation(rung) : small_tensor(rung);
    case Kind::matrices:
      return small_tensor(rung).replicate(1, count);
  }
  return {};
}

// --- changed inputs

using Change = std::function<void(Values&)>;

struct NamedChange {
  std::string name;
  std::string words;
  Change change;
  bool may_leave_domain = true;  ///< false for what few slips do: outside the domain an integration may never end
};

void add_changes_of(std::vector<NamedChange>& changes, const Argument& argument, std::size_t a, bool has_few_results) {
  const std::string& name = argument.name;
  const auto add = [&](const std::string& key, const std::string& words, const std::function<void(Value&)>& change) {
    changes.push_back({name + "_" + key, words, [a, change](Values& inputs) { change(inputs[a]); }});
  };
  add("negated", "−" + name, each([](double x) { return -x; }));
  add("zero", name + " = 0", each([](double) { return 0.0; }));
  changes.back().may_leave_domain = false;
  add("absolute", "|" + name + "|", each([](double x) { return std::abs(x); }));
  if (has_few_results) return;
  add("doubled", "2·" + name, each([](double x) { return 2 * x; }));
  add("halved", name + "/2", each([](double x) { return x / 2; }));
  if (argument.unit == units::radian) {
    add("degrees", name + " read as degrees", each([](double x) { return x * pi / 180; }));
    add("complement", "π/2 − " + name, each([](double x) { return pi / 2 - x; }));
  }
  if (argument.kind == Kind::vector3 || argument.kind == Kind::vector2) {
    const std::size_t size = argument.kind == Kind::vector3 ? 3 : 2;
    for (std::size_t n = 0; n < size; ++n) {
      const std::string entry = fmt::format("{}[{}]", name, n);
      for (std::size_t k = 0; k < size; ++k)
        if (k != n) {
          add(fmt::format("{}_is_{}", n + 1, k + 1), fmt::format("{}[{}] in place of {}", name, k, entry),
              [n, k](Value& value) { value.numbers[n] = value.numbers[k]; });
          changes.back().may_leave_domain = false;
        }
      add(fmt::format("{}_zero", n + 1), entry + " = 0", [n](Value& value) { value.numbers[n] = 0; });
      add(fmt::format("{}_negated", n + 1), fmt::format("−{0} in place of {0}", entry),
          [n](Value& value) { value.numbers[n] *= -1; });
      for (std::size_t k = n + 1; k < size; ++k)
        add(fmt::format("{}_{}_exchanged", n + 1, k + 1), fmt::format("{0}[{1}] and {0}[{2}] exchanged", name, n, k),
            [n, k](Value& value) { std::swap(value.numbers[n], value.numbers[k]); });
    }
    if (size == 3)
      for (const int shift : {1, 2})
        add(fmt::format("shifted_{}", shift), fmt::format("{} with its components shifted round by {}", name, shift),
            [shift](Value& value) {
              std::rotate(value.numbers.begin(), value.numbers.begin() + shift, value.numbers.end());
            });
    add("unit", name + " divided by its length", [](Value& value) { scale(value, 1 / norm(value)); });
  }
  if (argument.kind == Kind::vector || argument.kind == Kind::vector3 || argument.kind == Kind::vector2) {
    add("ascending", name + " with its entries in ascending order",
        [](Value& value) { std::ranges::sort(value.numbers); });
    add("descending", name + " with its entries in descending order",
        [](Value& value) { std::ranges::sort(value.numbers, std::greater()); });
  }
  if (argument.kind == Kind::matrix3) {
    add("transposed", "the transpose of " + name, [](Value& value) { value = to_value(as_matrix(value).transpose()); });
    add("diagonal", "the diagonal part of " + name,
        [](Value& value) { value = to_value(diagonal_part(as_matrix(value))); });
    add("off_diagonal_negated", name + " with the opposite signs off its diagonal",
        [](Value& value) { value = to_value(products_flipped(as_matrix(value))); });
  }
  if (argument.kind == Kind::vector || argument.kind == Kind::points) {
    const auto drop = [is_list = argument.kind == Kind::points](bool first) {
      return [=](Value& value) {
        const Eigen::MatrixXd all = as_matrix(value);
        const Eigen::Index left = (is_list ? all.cols() : all.rows()) - 1;
        if (left < 1) return;
        value = is_list ? to_value(first ? all.rightCols(left) : all.leftCols(left))
                        : to_value(first ? all.bottomRows(left) : all.topRows(left));
      };
    };
    add("without_last", name + " without its last entry", drop(false));
    add("without_first", name + " without its first entry", drop(true));
  }
}

/// The mass of the whole for that of the rest.
void add_sums_of(std::vector<NamedChange>& changes, const ExerciseReference& exercise, std::size_t a, std::size_t b) {
  const std::string &one = exercise.arguments[a].name, &other = exercise.arguments[b].name;
  for (const double sign : {1.0, -1.0}) {
    const std::string sum = fmt::format("{} {} {}", one, sign > 0 ? "+" : "−", other);
    changes.push_back({fmt::format("{}_{}_{}", one, sign > 0 ? "plus" : "minus", other), sum + " in place of " + one,
                       [a, b, sign](Values& inputs) { inputs[a].numbers[0] += sign * inputs[b].numbers[0]; }, false});
  }
}

/// The components of a vector on other axes.
void add_turned(std::vector<NamedChange>& changes, const ExerciseReference& exercise, std::size_t matrix,
                std::size_t vector) {
  const Argument &turn = exercise.arguments[matrix], &turned = exercise.arguments[vector];
  if (turn.kind != Kind::matrix3 || !(turn.unit == units::none) || turned.kind != Kind::vector3) return;
  for (const bool back : {false, true})
    changes.push_back({fmt::format("{}_times_{}{}", turned.name, turn.name, back ? "_transposed" : ""),
                       fmt::format("{0}{1}·{2} in place of {2}", turn.name, back ? "ᵀ" : "", turned.name),
                       [=](Values& inputs) {
                         Eigen::Matrix3d by = as_matrix(inputs[matrix]);
                         if (back) by.transposeInPlace();
                         inputs[vector] = to_value(by * as_matrix(inputs[vector]));
                       }});
}

std::vector<NamedChange> changes_of(const ExerciseReference& exercise) {
  std::vector<NamedChange> changes;
  // Of a few possible results another one is soon the same by chance.
  const bool has_few_results = exercise.result_kind == Kind::integer;
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    if (exercise.arguments[a].kind != Kind::integer) add_changes_of(changes, exercise.arguments[a], a, has_few_results);
    for (std::size_t b = 0; b < exercise.arguments.size(); ++b) add_turned(changes, exercise, a, b);
    for (std::size_t b = a + 1; b < exercise.arguments.size(); ++b) {
      if (exercise.arguments[a].kind != exercise.arguments[b].kind) continue;
      if (has_few_results && !(exercise.arguments[a].unit == exercise.arguments[b].unit)) continue;
      const std::string names = exercise.arguments[a].name + " and " + exercise.arguments[b].name;
      changes.push_back({exercise.arguments[a].name + "_" + exercise.arguments[b].name + "_exchanged",
                         names + " exchanged", [a, b](Values& inputs) { std::swap(inputs[a], inputs[b]); }});
      changes.push_back({exercise.arguments[b].name + "_is_" + exercise.arguments[a].name,
                         exercise.arguments[a].name + " in place of " + exercise.arguments[b].name,
                         [a, b](Values& inputs) { inputs[b] = inputs[a]; }});
      if (exercise.arguments[a].kind != Kind::number || !(exercise.arguments[a].unit == exercise.arguments[b].unit))
        continue;
      add_sums_of(changes, exercise, a, b);
      add_sums_of(changes, exercise, b, a);
    }
  }
  return changes;
}

bool same_outputs(const Subject& subject, const std::vector<Value>& one, const std::vector<Value>& other) {
  const ExerciseReference& exercise = subject.described;
  return std::ranges::all_of(deciding_cases(exercise),
                             [&](std::size_t i) { return is_same_answer(exercise, i, one[i], other[i]); });
}

// --- bug templates

std::function<Value(const Values&)> with_changed_input(const Subject& subject, Change change) {
  return [right = subject.right, change = std::move(change)](const Values& inputs) {
    Values changed = inputs;
    change(changed);
    return right(changed);
  };
}

std::function<Value(const Values&)> with_changed_output(const Subject& subject, std::function<double(double)> change) {
  return [right = subject.right, change = each(std::move(change))](const Values& inputs) {
    Value value = right(inputs);
    change(value);
    return value;
  };
}

void add_threshold_templates(std::vector<BugTemplate>& templates, const Subject& subject, const Handle& handle) {
  const auto on_entry = [&](const std::string& name, const std::function<double(double)>& f) {
    templates.push_back({name, with_changed_input(subject, [handle, f](Values& inputs) {
                           if (handle.is_in(inputs)) handle.set(inputs, f(handle.get(inputs)));
                         })});
  };
  for (const double threshold : {1e-3, 1e-6, 1e-9})
    on_entry(fmt::format("|{}| below {} taken for zero", handle.name, threshold),
             [threshold](double x) { return std::abs(x) < threshold ? 0.0 : x; });
  on_entry(fmt::format("|{}| in place of {}", handle.name, handle.name), [](double x) { return std::abs(x); });
  for (const double limit : {10.0, 1000.0})
    on_entry(fmt::format("{} limited to {}", handle.name, limit),
             [limit](double x) { return std::clamp(x, -limit, limit); });
  if (!(handle.unit == units::radian)) return;
  on_entry(handle.name + " limited to 0 … π", [](double x) { return std::clamp(x, 0.0, pi); });
  on_entry(handle.name + " limited to −π … π", [](double x) { return std::clamp(x, -pi, pi); });
  on_entry(handle.name + " taken modulo π", [](double x) { return std::fmod(x, pi); });
  on_entry(handle.name + " taken modulo 2π", [](double x) { return std::fmod(x, 2 * pi); });
}

}  // namespace

double condition_of(const Case& one, const ExerciseReference& exercise,
                    const std::function<Value(const Values&)>& right) {
  const bool has_integers =
      std::ranges::any_of(exercise.arguments, [](const Argument& argument) { return argument.kind == Kind::integer; });
  if (has_integers || exercise.result_kind == Kind::integer) return 0;
  const ExerciseReference alone = without_outputs(exercise, one);
  double worst = 0;
  for (const unsigned pattern : {1U, 2U}) {
    const std::optional<Value> moved = attempt(right, rounded_otherwise(one.inputs, pattern));
    if (!moved || !moved->has_shape_of(one.expected)) continue;  // at the edge of the domain
    for (const Deviation& deviation : deviations(alone, 0, *moved))
      worst = std::max(worst, deviation.relative_size() / one.tolerance);
  }
  return std::stod(fmt::format("{:.1e}", worst));  // two digits are enough to keep
}

bool make_answerable(Case& one, const ExerciseReference& exercise, const std::function<Value(const Values&)>& right) {
  constexpr double largest_part = 1. / 16, most = 256;
  one.condition = condition_of(one, exercise, right);
  if (one.condition > largest_part * most) return false;
  // In powers of four, so that the same tolerance comes out on machines that round otherwise.
  for (; one.condition > largest_part; one.condition /= 4) one.tolerance *= 4;
  return true;
}

std::vector<Case> ladder(const Subject& subject) {
  std::vector<Case> found;
  const std::vector<Argument>& arguments = subject.described.arguments;
  for (std::size_t rung = 0; rung < rungs && found.size() < most_rungs; ++rung) {
    Case candidate;
    candidate.name = fmt::format("small whole numbers {}", found.size() + 1);
    for (std::size_t a = 0; a < arguments.size(); ++a) {
      Eigen::MatrixXd input = small_input(arguments[a], a, rung);
      if (arguments[a].kind == Kind::matrix3 && a > 0 && arguments[a].unit == units::none / units::second)
        input = skew(small_vector(rung, 2)) * as_matrix(candidate.inputs[a - 1]);  // a rate of the rotation before it
      candidate.inputs.push_back(to_value(input));
    }
    if (const auto one = case_at(subject, candidate)) found.push_back(*one);
  }
  return found;
}

std::vector<Case> corner_cases(const Subject& subject) {
  std::vector<Case> candidates;
  for (const std::size_t base : bases_of(subject.described)) {
    Neighbours neighbours(subject.described, base);
    std::ranges::move(candidates.empty() ? neighbours.all() : neighbours.probes(), std::back_inserter(candidates));
  }
  std::vector<Case> cases;
  std::set<std::vector<double>> seen;
  for (const Case& candidate : candidates) {
    std::vector<double> key;
    for (const Value& value : candidate.inputs) key.insert(key.end(), value.numbers.begin(), value.numbers.end());
    if (!seen.insert(key).second) continue;
    if (std::optional<Case> one = case_at(subject, candidate)) cases.push_back(std::move(*one));
  }
  return cases;
}

namespace {

bool takes_lists(const ExerciseReference& exercise) {
  return std::ranges::any_of(exercise.arguments, [](const Argument& argument) {
    return argument.kind == Kind::vector || argument.kind == Kind::points || argument.kind == Kind::matrices;
  });
}

/// Adds the results of a function at all cases, if it has one at each that decides and they are new.
void add_transform(std::vector<InputTransform>& transforms, const Subject& subject, InputTransform transform,
                   const std::function<std::optional<Value>(const Values&)>& function) {
  const std::vector<Case>& cases = subject.described.cases;
  std::vector<Value> expected;
  for (const Case& one : cases) {
    const std::optional<Value> value = function(one.inputs);
    const bool fits = value && value->has_shape_of(one.expected);
    if (!fits && one.deciding) return;
    transform.outputs.push_back(fits ? *value : one.expected);
    expected.push_back(one.expected);
  }
  const auto is_known = [&](const std::vector<Value>& outputs) {
    return same_outputs(subject, transform.outputs, outputs);
  };
  if (!is_known(expected) && std::ranges::none_of(transforms, is_known, &InputTransform::outputs))
    transforms.push_back(std::move(transform));
}

}  // namespace

std::vector<InputTransform> input_transforms(const Subject& subject, const std::vector<Subject>& others) {
  const ExerciseReference& exercise = subject.described;
  std::vector<InputTransform> transforms;
  const bool has_lists = takes_lists(exercise);
  for (const NamedChange& each : changes_of(exercise)) {
    add_transform(transforms, subject, {each.name, each.words, {}}, [&](Values changed) -> std::optional<Value> {
      each.change(changed);
      // Outside the domain, where a slip leads, the formula may well have a value; lists of different lengths have
      // none.
      return (!has_lists && each.may_leave_domain) || subject.legal(changed) ? attempt(subject.right, changed)
                                                                             : std::nullopt;
    });
  }
  for (const Subject& other : others) {
    const ExerciseReference& its = other.described;
    if (its.name == exercise.name || its.result_kind != exercise.result_kind ||
        its.result_units != exercise.result_units)
      continue;
    std::vector<std::size_t> given;  // which argument of this exercise stands for each of the other's
    for (const Argument& wanted : its.arguments) {
      const auto fits = [&](bool by_name) {
        for (std::size_t a = 0; a < exercise.arguments.size(); ++a)
          if (exercise.arguments[a].kind == wanted.kind && exercise.arguments[a].unit == wanted.unit &&
              (!by_name || exercise.arguments[a].name == wanted.name) && std::ranges::count(given, a) == 0)
            return std::optional(a);
        return std::optional<std::size_t>();
      };
      const auto found = fits(true) ? fits(true) : fits(false);
      if (!found) break;
      given.push_back(*found);
    }
    if (given.size() != its.arguments.size()) continue;
    add_transform(transforms, subject, {"of_" + its.name, "`" + its.name + "`", {}},
                  [&](const Values& inputs) -> std::optional<Value> {
                    Values passed;
                    for (const std::size_t a : given) passed.push_back(inputs[a]);
                    return other.legal(passed) ? attempt(other.right, passed) : std::nullopt;
                  });
  }
  return transforms;
}

std::vector<BugTemplate> bug_templates(const Subject& subject) {
  std::vector<BugTemplate> templates;
  const auto bases = bases_of(subject.described);
  if (bases.empty()) return templates;
  const Values& generic = subject.described.cases[bases.front()].inputs;
  const std::vector<Handle> handles = handles_of(subject.described, generic);
  for (const Handle& handle : handles) add_threshold_templates(templates, subject, handle);
  for (std::size_t a = 0; a < generic.size(); ++a) {
    const Argument& argument = subject.described.arguments[a];
    if (argument.kind == Kind::integer || generic[a].numbers.size() == 1) continue;
    for (const double threshold : {1e-3, 1e-6, 1e-9})
      templates.push_back({fmt::format("the length of {} below {} taken for zero", argument.name, threshold),
                           with_changed_input(subject, [a, threshold](Values& inputs) {
                             if (norm(inputs[a]) < threshold) scale(inputs[a], 0);
                           })});
  }
  for (std::size_t i = 0; i < handles.size(); ++i) {
    for (std::size_t k = i + 1; k < handles.size(); ++k) {
      const Handle &one = handles[i], &other = handles[k];
      if (!(one.unit == other.unit) || one.unit == units::none) continue;
      for (const double threshold : {1e-2, 1e-4})
        templates.push_back({fmt::format("{} within {} of {} taken for equal", other.name, threshold, one.name),
                             with_changed_input(subject, [one, other, threshold](Values& inputs) {
                               if (!one.is_in(inputs) || !other.is_in(inputs)) return;
                               const double x = one.get(inputs), y = other.get(inputs);
                               if (std::abs(x - y) < threshold * std::max(std::abs(x), std::abs(y)))
                                 other.set(inputs, x);
                             })});
    }
  }
  for (const double threshold : {1e-3, 1e-6, 1e-9, 1e-12})
    templates.push_back(
        {fmt::format("results below {} replaced by zero", threshold),
         with_changed_output(subject, [threshold](double x) { return std::abs(x) < threshold ? 0.0 : x; })});
  templates.push_back({"results in float", with_changed_output(subject, [](double x) { return double(float(x)); })});
  templates.push_back(
      {"absolute value of the result", with_changed_output(subject, [](double x) { return std::abs(x); })});
  templates.push_back({"inputs in float", with_changed_input(subject, [](Values& inputs) {
                         for (Value& value : inputs)
                           for (double& number : value.numbers) number = static_cast<float>(number);
                       })});
  const auto first = std::make_shared<std::optional<Value>>();
  templates.push_back({"the value of the first call kept", [first, right = subject.right](const Values& inputs) {
                         if (!*first) *first = right(inputs);
                         return **first;
                       }});
  return templates;
}

Adequacy prove_adequacy(const Subject& subject, std::vector<Case> cases) {
  struct Point {
    Case candidate;
    std::optional<Value> right;
    bool is_tried = false;  // as a case
    std::optional<Case> one = {};
  };
  std::vector<Point> sample;
  for (Case& candidate : dense_sample(subject)) {
    if (!subject.legal(candidate.inputs)) continue;
    const std::optional<Value> right = attempt(subject.right, candidate.inputs);
    if (right) sample.push_back({std::move(candidate), right});
  }

  Adequacy adequacy;
  for (const BugTemplate& bug : bug_templates(subject)) {
    ++adequacy.made;
    const auto fails_at = [&](const Case& one) { return !passes_at(subject, one, attempt(bug.buggy, one.inputs)); };
    if (std::ranges::any_of(subject.described.cases, fails_at) || std::ranges::any_of(cases, fails_at)) {
      ++adequacy.killed;
      continue;
    }
    bool differs = false;
    const auto shows_at = [&](Point& point) {
      const auto buggy = attempt(bug.buggy, point.candidate.inputs);
      if (buggy && buggy->numbers == point.right->numbers) return false;
      if (!point.is_tried) point.one = case_at(subject, point.candidate);
      point.is_tried = true;
      const std::optional<Case> one = point.one ? point.one : unchecked_case_at(subject, point.candidate);
      if (!one || passes_at(subject, *one, buggy)) return false;
      differs = true;
      return point.one.has_value();
    };
    if (const auto point = std::ranges::find_if(sample, shows_at); point != sample.end()) {
      cases.push_back(*point->one);
      adequacy.neighbours.push_back(point->candidate.name);
      ++adequacy.killed;
    } else if (differs) {
      adequacy.survivors.push_back(bug.name);
    } else {
      ++adequacy.equal;
    }
  }
  return adequacy;
}

std::vector<Case> neighbour_cases(const Subject& subject, const std::vector<std::string>& names) {
  std::vector<Case> cases;
  const std::vector<Case> sample = names.empty() ? std::vector<Case>() : dense_sample(subject);
  for (const std::string& name : names) {
    const auto candidate = std::ranges::find(sample, name, &Case::name);
    if (candidate == sample.end()) continue;
    if (std::optional<Case> one = case_at(subject, *candidate)) cases.push_back(std::move(*one));
  }
  return cases;
}

std::string fingerprint_of(const Subject& subject, const Adequacy& record) {
  const ExerciseReference& exercise = subject.described;
  std::string text = fmt::format("{} {} {} {}\n{}\n{}\n", exercise.signature, record.made, record.killed, record.equal,
                                 fmt::join(record.survivors, "\n"), fmt::join(record.neighbours, "\n"));
  for (const BugTemplate& bug : bug_templates(subject)) text += bug.name + "\n";
  // Rounding differs between machines: results are counted in units in which no exact result lies half-way.
  constexpr double units_per_scale = 9973.1;
  for (const Case& one : exercise.cases) {
    text += fmt::format("{} {:.6g}", one.name, one.tolerance);
    for (const Value& input : one.inputs) text += fmt::format(" {:.6g}", fmt::join(input.numbers, " "));
    for (std::size_t i = 0; i < one.expected.numbers.size(); ++i) {
      const double scale = one.scale[one.scale.size() == 1 ? 0 : i];
      text += fmt::format(" {}", std::llround(one.expected.numbers[i] / scale * units_per_scale));
    }
    text += "\n";
  }
  return fingerprint(text);
}

}  // namespace workbook::judging
