/// @file
/// The bodies of lecture.hpp's templates.
#pragma once

#include "solutions/judging/lecture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace workbook::judging {

namespace detail {

template <class T>
Value to_value(const T& typed) {
  Value value{KindOf<T>::rows(typed), KindOf<T>::cols(typed), {}};
  value.numbers.resize(static_cast<std::size_t>(value.rows) * value.cols);
  KindOf<T>::write(typed, value.numbers.data());
  return value;
}

template <class... T>
std::vector<Value> to_values(const std::tuple<T...>& typed) {
  return std::apply([](const auto&... each) { return std::vector<Value>{to_value(each)...}; }, typed);
}

/// The same angle with its number taken for degrees.
template <class T>
T as_if_degrees(const T& angle) {
  if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::vector<Eigen::Matrix3d>>) {
    return angle;
  } else {
    return T(angle * (std::numbers::pi / 180));
  }
}

/// Largest magnitude among the numbers.
double largest(const Value& value);

/// "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)".
std::string signature(const ExerciseReference& exercise);

/// A seed of its own for every batch of random cases, so that adding one leaves the others as they were.
std::uint64_t batch_seed(std::uint64_t seed, const std::string& exercise, const std::string& batch);

/// What the cases of a batch have in common; inputs and expected result come with evaluation.
Case prototype(std::string name, Group group);

/// @throws std::logic_error if an expected number is not finite or the scale is not a positive number.
void require_usable(const std::string& exercise, const Case& judged);

}  // namespace detail

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::argument(std::string name, Unit unit) -> Exercise& {
  const std::vector<std::string> kinds{KindOfParameter<Parameters>::name...};
  if (result_.arguments.size() == kinds.size())
    throw std::logic_error(result_.name + ": more arguments named than the contract has");
  result_.arguments.push_back({std::move(name), kind_from_string(kinds[result_.arguments.size()]), unit});
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::result(std::string name, std::vector<Unit> unit_of_each) -> Exercise& {
  result_.result_name = std::move(name);
  result_.result_kind = kind_from_string(KindOf<Result>::name);
  result_.result_units = std::move(unit_of_each);
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::compare(Comparison comparison) -> Exercise& {
  result_.comparison = comparison;
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::tolerance(double relative, const std::string& reason) -> Exercise& {
  for (Batch& batch : batches_) batch.prototype.tolerance = relative;
  result_.tolerance_reason += (result_.tolerance_reason.empty() ? "" : " ") + reason;
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::tolerance_of_last_case(double relative, const std::string& reason) -> Exercise& {
  batches_.back().prototype.tolerance = relative;
  result_.tolerance_reason += (result_.tolerance_reason.empty() ? "" : " ") + reason;
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::scale(Scale scale) -> Exercise& {
  scales_ = [scale](const std::remove_cvref_t<Parameters>&... inputs) { return std::vector<double>{scale(inputs...)}; };
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::scales(Scales scales) -> Exercise& {
  scales_ = std::move(scales);
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::worked(std::string name, std::remove_cvref_t<Parameters>... inputs) -> Exercise& {
  Inputs fixed{std::move(inputs)...};
  batches_.push_back({detail::prototype(std::move(name), Group::worked), 1, [fixed](Random&) { return fixed; }});
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::special(std::string name, std::remove_cvref_t<Parameters>... inputs)
    -> Exercise& {
  worked(std::move(name), std::move(inputs)...);
  batches_.back().prototype.group = Group::special;
  return blind();
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::random(std::string name, int count, std::function<Inputs(Random&)> draw)
    -> Exercise& {
  batches_.push_back({detail::prototype(std::move(name), Group::random), count, std::move(draw)});
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::blind() -> Exercise& {
  batches_.back().prototype.deciding = false;
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::misconception(std::string name, std::string message, std::string notes,
                                                    Function wrong) -> Exercise& {
  result_.misconceptions.push_back({std::move(name), std::move(message), std::move(notes), {}, {}});
  misconceptions_.push_back(std::move(wrong));
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::angles_read_as_degrees(std::string notes) -> Exercise& {
  std::vector<bool> is_angle;
  for (const Argument& argument : result_.arguments) is_angle.push_back(argument.unit == units::radian);
  return misconception("degrees", "You convert the angles from degrees, but they already come in radians.",
                       std::move(notes),
                       [reference = reference_, is_angle](const std::remove_cvref_t<Parameters>&... inputs) {
                         const auto scaled = [&]<std::size_t... index>(std::index_sequence<index...>) {
                           return Inputs{(is_angle[index] ? detail::as_if_degrees(inputs) : inputs)...};
                         };
                         return std::apply(reference, scaled(std::index_sequence_for<Parameters...>{}));
                       });
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::term(std::string name, double coefficient, Function summand) -> Exercise& {
  result_.terms.push_back({std::move(name), coefficient, {}});
  terms_.push_back(std::move(summand));
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::property(PropertyKind kind, std::string message, std::string notes) -> Exercise& {
  result_.properties.push_back({kind, std::move(message), std::move(notes), -1, {}});
  weights_.emplace_back();
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::perpendicular_to(int argument, std::string message, std::string notes)
    -> Exercise& {
  property(PropertyKind::orthogonal_to_argument, std::move(message), std::move(notes));
  result_.properties.back().argument = argument;
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::conserves(std::string message, std::string notes, Scales weights) -> Exercise& {
  property(PropertyKind::constant_weighted_square, std::move(message), std::move(notes));
  weights_.back() = std::move(weights);
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::route(std::string name, Function other) -> Exercise& {
  result_.routes.push_back({std::move(name), {}});
  routes_.push_back(std::move(other));
  return *this;
}

template <class Result, class... Parameters>
auto Exercise<Result, Parameters...>::sweep(SweepLabels labels, SweepRange range,
                                            std::function<Inputs(double)> inputs_at,
                                            std::vector<PlotComponent> components) -> Exercise& {
  result_.sweep.title = std::move(labels.title);
  result_.sweep.x_label = std::move(labels.x);
  result_.sweep.y_label = std::move(labels.y);
  result_.sweep.components = std::move(components);
  sweep_range_ = range;
  sweep_inputs_ = std::move(inputs_at);
  return *this;
}

template <class Result, class... Parameters>
ExerciseReference Exercise<Result, Parameters...>::evaluate(std::uint64_t seed) const {
  if (result_.arguments.size() != sizeof...(Parameters) || result_.result_units.empty()) {
    throw std::logic_error(result_.name + ": every argument and the result need a name and a unit");
  }
  ExerciseReference out = result_;
  out.signature = detail::signature(out);
  const auto value_of = [](const Function& function, const Inputs& inputs) {
    return detail::to_value<Result>(std::apply(function, inputs));
  };

  for (const Batch& batch : batches_) {
    Random random(detail::batch_seed(seed, out.name, batch.prototype.name));
    for (int i = 0; i < batch.count; ++i) {
      const Inputs inputs = batch.draw(random);
      Case judged = batch.prototype;
      if (batch.count > 1) judged.name = fmt::format("{} {}", judged.name, i + 1);
      judged.inputs = detail::to_values(inputs);
      judged.expected = value_of(reference_, inputs);
      for (std::size_t k = 0; k < terms_.size(); ++k) out.terms[k].outputs.push_back(value_of(terms_[k], inputs));
      for (std::size_t k = 0; k < misconceptions_.size(); ++k) {
        out.misconceptions[k].outputs.push_back(value_of(misconceptions_[k], inputs));
      }
      for (std::size_t k = 0; k < routes_.size(); ++k) out.routes[k].outputs.push_back(value_of(routes_[k], inputs));
      for (std::size_t k = 0; k < weights_.size(); ++k) {
        if (weights_[k]) out.properties[k].weights.push_back(std::apply(weights_[k], inputs));
      }
      if (scales_) {
        judged.scale = std::apply(scales_, inputs);
      } else {
        double natural = detail::largest(judged.expected);
        for (const Term& term : out.terms) {
          natural = std::max(natural, std::abs(term.coefficient) * detail::largest(term.outputs.back()));
        }
        judged.scale = {natural};
      }
      detail::require_usable(out.name, judged);
      out.cases.push_back(std::move(judged));
    }
  }

  if (sweep_inputs_) {
    for (int i = 0; i < sweep_range_.points; ++i) {
      const double x = sweep_range_.from + (sweep_range_.to - sweep_range_.from) * i / (sweep_range_.points - 1);
      const Inputs inputs = sweep_inputs_(x);
      out.sweep.x.push_back(x);
      out.sweep.inputs.push_back(detail::to_values(inputs));
      out.sweep.expected.push_back(value_of(reference_, inputs));
      for (std::size_t k = 0; k < misconceptions_.size(); ++k) {
        out.misconceptions[k].sweep_outputs.push_back(value_of(misconceptions_[k], inputs));
      }
    }
  }
  return out;
}

}  // namespace workbook::judging
