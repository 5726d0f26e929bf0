#include "checker/data/reference_json.hpp"
#include "checker/data/reference_names.hpp"
#include "checker/messages/reference_files.hpp"

#include <algorithm>
#include <set>

namespace workbook {

namespace {

using messages::OnePer;

template <class Choice, std::size_t count>
Choice choice_from(const JsonPlace& place, const Names<Choice, count>& names) {
  const std::string text = place.text();
  for (const auto& [choice, name] : names) {
    if (text == name) return choice;
  }
  place.refuse(messages::unknown_choice(text));
}

/// Reads a list of named things; no two may bear the same name.
template <class Function>
auto named_items(const JsonPlace& list, Function&& read) {
  std::vector<decltype(read(list))> things;
  std::set<std::string> names;
  for (const JsonPlace& item : list.items()) {
    things.push_back(read(item));
    if (!names.insert(things.back().name).second) {
      item.at("name").refuse(messages::name_stands_twice(things.back().name));
    }
  }
  return things;
}

Kind kind_from(const JsonPlace& place) {
  try {
    return kind_from_string(place.text());
  } catch (const std::invalid_argument& error) {
    place.refuse(error.what());
  }
}

Unit unit_from(const JsonPlace& place) {
  place.require_keys({}, {"kg", "m", "s", "rad"});
  const auto exponent = [&](const char* base) { return place.has(base) ? place.at(base).integer() : 0; };
  return {exponent("kg"), exponent("m"), exponent("s"), exponent("rad")};
}

Argument argument_from(const JsonPlace& place) {
  place.require_keys({"name", "kind", "unit"});
  return {place.at("name").name(), kind_from(place.at("kind")), unit_from(place.at("unit"))};
}

std::vector<Value> inputs_from(const JsonPlace& place, const ExerciseReference& exercise) {
  const auto items = place.items(exercise.arguments.size(), OnePer::argument);
  std::vector<Value> inputs;
  for (std::size_t i = 0; i < items.size(); ++i) inputs.push_back(items[i].finite_value(exercise.arguments[i].kind));
  return inputs;
}

Case case_from(const JsonPlace& place, const ExerciseReference& exercise) {
  place.require_keys({"name", "group", "deciding", "inputs", "expected", "scale", "tolerance"});
  Case one;
  one.name = place.at("name").name();
  one.group = choice_from(place.at("group"), group_names);
  one.deciding = place.at("deciding").truth();
  one.inputs = inputs_from(place.at("inputs"), exercise);
  one.expected = place.at("expected").finite_value(exercise.result_kind);
  for (const JsonPlace& item : place.at("scale").items()) one.scale.push_back(item.positive_number());
  one.tolerance = place.at("tolerance").positive_number();

  const std::size_t numbers = one.expected.numbers.size();
  if (one.scale.size() != 1 && one.scale.size() != numbers) {
    place.at("scale").refuse(messages::expected_scales(numbers, one.scale.size()));
  }
  if (exercise.result_units.size() != 1 && exercise.result_units.size() != numbers) {
    place.at("expected").refuse(messages::units_do_not_fit(exercise.result_units.size(), numbers));
  }
  if (exercise.comparison == Comparison::attitude_by_angles && numbers != 3) {
    place.at("expected").refuse(messages::attitude_needs_three_angles());
  }
  if (exercise.comparison == Comparison::eigenvectors && !(one.inputs.at(0).has_shape_of(one.expected))) {
    place.at("expected").refuse(messages::eigenvectors_need_shape_of_argument());
  }
  return one;
}

/// One value per given one, each of the same shape. Only wrong answers may hold NaN.
std::vector<Value> outputs_from(const JsonPlace& place, Kind kind, const std::vector<const Value*>& like, OnePer what,
                                bool must_be_finite) {
  const auto items = place.items(like.size(), what);
  std::vector<Value> outputs;
  for (std::size_t i = 0; i < items.size(); ++i) {
    outputs.push_back(must_be_finite ? items[i].finite_value(kind) : items[i].value(kind));
    if (!outputs.back().has_shape_of(*like[i])) {
      items[i].refuse(messages::expected_shape(like[i]->rows, like[i]->cols, outputs.back().rows, outputs.back().cols));
    }
  }
  return outputs;
}

std::vector<Value> outputs_per_case(const JsonPlace& place, const ExerciseReference& exercise, bool must_be_finite) {
  std::vector<const Value*> expected;
  for (const Case& one : exercise.cases) expected.push_back(&one.expected);
  return outputs_from(place, exercise.result_kind, expected, OnePer::case_of_exercise, must_be_finite);
}

Misconception misconception_from(const JsonPlace& place, const ExerciseReference& exercise) {
  place.require_keys({"name", "message", "notes", "outputs", "sweep_outputs"});
  std::vector<const Value*> expected_over_sweep;
  for (const Value& value : exercise.sweep.expected) expected_over_sweep.push_back(&value);
  return {place.at("name").name(), place.at("message").name(), place.at("notes").text(),
          outputs_per_case(place.at("outputs"), exercise, false),
          outputs_from(place.at("sweep_outputs"), exercise.result_kind, expected_over_sweep, OnePer::point_of_sweep,
                       false)};
}

Term term_from(const JsonPlace& place, const ExerciseReference& exercise) {
  place.require_keys({"name", "coefficient", "outputs"});
  return {place.at("name").name(), place.at("coefficient").finite_number(),
          outputs_per_case(place.at("outputs"), exercise, true)};
}

Route route_from(const JsonPlace& place, const ExerciseReference& exercise) {
  place.require_keys({"name", "outputs"});
  return {place.at("name").name(), outputs_per_case(place.at("outputs"), exercise, true)};
}

/// A property says something only of results of some kinds.
bool suits(PropertyKind property, Kind result) {
  switch (property) {
    case PropertyKind::symmetric:
    case PropertyKind::antisymmetric:
    case PropertyKind::positive_semidefinite:
    case PropertyKind::rotation_matrix:
      return result == Kind::matrix3;
    case PropertyKind::unit_norm:
    case PropertyKind::ascending:
    case PropertyKind::orthogonal_to_argument:
      return result == Kind::vector2 || result == Kind::vector3 || result == Kind::vector;
    case PropertyKind::nonnegative:
    case PropertyKind::constant_weighted_square:
      return true;
  }
  return false;
}

Property property_from(const JsonPlace& place, const ExerciseReference& exercise) {
  Property property;
  property.kind = choice_from(place.at("kind"), property_names);
  if (!suits(property.kind, exercise.result_kind)) {
    place.at("kind").refuse(messages::result_cannot_be(to_string(exercise.result_kind), to_string(property.kind)));
  }

  switch (property.kind) {
    case PropertyKind::orthogonal_to_argument: {
      place.require_keys({"kind", "message", "notes", "argument"});
      property.argument = place.at("argument").integer();
      const int arguments = static_cast<int>(exercise.arguments.size());
      if (property.argument < 0 || property.argument >= arguments)
        place.at("argument").refuse(messages::no_such_argument());
      if (exercise.arguments[static_cast<std::size_t>(property.argument)].kind != exercise.result_kind) {
        place.at("argument").refuse(messages::argument_of_another_kind());
      }
      break;
    }
    case PropertyKind::constant_weighted_square: {
      place.require_keys({"kind", "message", "notes", "weights"});
      const auto lists = place.at("weights").items(exercise.cases.size(), OnePer::case_of_exercise);
      for (std::size_t i = 0; i < lists.size(); ++i) {
        const auto rows = static_cast<std::size_t>(exercise.cases[i].expected.rows);
        std::vector<double> weights;
        for (const JsonPlace& item : lists[i].items(rows, OnePer::row)) weights.push_back(item.finite_number());
        property.weights.push_back(std::move(weights));
      }
      break;
    }
    default:
      place.require_keys({"kind", "message", "notes"});
  }
  property.message = place.at("message").name();
  property.notes = place.at("notes").text();
  return property;
}

PlotComponent plot_component_from(const JsonPlace& place, const std::vector<Value>& expected) {
  place.require_keys({"name", "row", "col"});
  PlotComponent component{place.at("name").name(), place.at("row").integer(), place.at("col").integer()};
  const auto lacks_it = [&](const Value& value) {
    return component.row < 0 || component.col < 0 || component.row >= value.rows || component.col >= value.cols;
  };
  if (std::ranges::any_of(expected, lacks_it)) place.refuse(messages::no_such_entry());
  return component;
}

Sweep sweep_from(const JsonPlace& place, const ExerciseReference& exercise) {
  place.require_keys({"title", "x_label", "y_label", "components", "x", "inputs", "expected"});
  Sweep sweep;
  sweep.title = place.at("title").text();
  sweep.x_label = place.at("x_label").text();
  sweep.y_label = place.at("y_label").text();
  for (const JsonPlace& item : place.at("x").items()) sweep.x.push_back(item.finite_number());
  if (sweep.x.empty()) place.at("x").refuse(messages::sweep_needs_points());
  for (const JsonPlace& item : place.at("inputs").items(sweep.x.size(), OnePer::point_of_sweep)) {
    sweep.inputs.push_back(inputs_from(item, exercise));
  }
  for (const JsonPlace& item : place.at("expected").items(sweep.x.size(), OnePer::point_of_sweep)) {
    sweep.expected.push_back(item.finite_value(exercise.result_kind));
  }
  sweep.components = named_items(place.at("components"),
                                 [&](const JsonPlace& item) { return plot_component_from(item, sweep.expected); });
  return sweep;
}

ExerciseReference exercise_from(const JsonPlace& place) {
  place.require_keys({"name", "signature", "arguments", "result", "comparison", "tolerance_reason", "cases",
                      "misconceptions", "terms", "properties", "routes"},
                     {"sweep"});
  ExerciseReference exercise;
  exercise.name = place.at("name").name();
  exercise.signature = place.at("signature").name();
  exercise.arguments = named_items(place.at("arguments"), argument_from);

  const JsonPlace result = place.at("result");
  result.require_keys({"name", "kind", "units"});
  exercise.result_name = result.at("name").name();
  exercise.result_kind = kind_from(result.at("kind"));
  for (const JsonPlace& unit : result.at("units").items()) exercise.result_units.push_back(unit_from(unit));
  if (exercise.result_units.empty()) result.at("units").refuse(messages::expected_unit());

  exercise.comparison = choice_from(place.at("comparison"), comparison_names);
  if (exercise.comparison == Comparison::eigenvectors &&
      (exercise.result_kind != Kind::matrix3 || exercise.arguments.empty() ||
       exercise.arguments.front().kind != Kind::matrix3)) {
    place.at("comparison").refuse(messages::eigenvectors_need_matrices());
  }
  exercise.tolerance_reason = place.at("tolerance_reason").text();

  // Outputs are counted against cases and sweep, so these come first.
  exercise.cases = named_items(place.at("cases"), [&](const JsonPlace& item) { return case_from(item, exercise); });
  if (exercise.cases.empty()) place.at("cases").refuse(messages::exercise_needs_cases());
  if (place.has("sweep")) exercise.sweep = sweep_from(place.at("sweep"), exercise);

  exercise.misconceptions = named_items(place.at("misconceptions"),
                                        [&](const JsonPlace& item) { return misconception_from(item, exercise); });
  exercise.terms = named_items(place.at("terms"), [&](const JsonPlace& item) { return term_from(item, exercise); });
  for (const JsonPlace& item : place.at("properties").items()) {
    exercise.properties.push_back(property_from(item, exercise));
  }
  exercise.routes = named_items(place.at("routes"), [&](const JsonPlace& item) { return route_from(item, exercise); });
  return exercise;
}

}  // namespace

LectureReference lecture_from_json(const JsonPlace& document) {
  // The format comes first: of another one, nothing else can be said.
  LectureReference lecture;
  lecture.format = document.at("format").integer();
  if (lecture.format != LectureReference::current_format) {
    document.at("format").refuse(messages::other_format(lecture.format, LectureReference::current_format));
  }
  document.require_keys({"format", "seed", "lecture", "exercises"});
  lecture.seed = document.at("seed").natural_number();
  lecture.lecture = document.at("lecture").name();
  lecture.exercises = named_items(document.at("exercises"), exercise_from);
  return lecture;
}

}  // namespace workbook
