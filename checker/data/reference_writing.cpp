#include "checker/data/reference_json.hpp"
#include "checker/data/reference_names.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>

namespace workbook {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t line_width = 120;

template <class Items, class Function>
ordered_json list_of(const Items& items, Function&& to_item) {
  ordered_json list = ordered_json::array();
  for (const auto& item : items) list.push_back(ordered_json(std::invoke(to_item, item)));
  return list;
}

ordered_json values_to_json(const std::vector<Value>& values, Kind kind) {
  return list_of(values, [kind](const Value& value) { return to_json(value, kind); });
}

ordered_json inputs_to_json(const std::vector<Value>& inputs, const std::vector<Argument>& arguments) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < inputs.size(); ++i)
    list.push_back(ordered_json(to_json(inputs[i], arguments.at(i).kind)));
  return list;
}

ordered_json unit_to_json(const Unit& unit) {
  ordered_json exponents = ordered_json::object();
  if (unit.kilogram != 0) exponents["kg"] = unit.kilogram;
  if (unit.metre != 0) exponents["m"] = unit.metre;
  if (unit.second != 0) exponents["s"] = unit.second;
  if (unit.radian != 0) exponents["rad"] = unit.radian;
  return exponents;
}

ordered_json argument_to_json(const Argument& argument) {
  return {{"name", argument.name}, {"kind", to_string(argument.kind)}, {"unit", unit_to_json(argument.unit)}};
}

ordered_json property_to_json(const Property& property) {
  ordered_json json = {{"kind", to_string(property.kind)}, {"message", property.message}, {"notes", property.notes}};
  if (property.kind == PropertyKind::orthogonal_to_argument) json["argument"] = property.argument;
  if (property.kind == PropertyKind::constant_weighted_square) json["weights"] = property.weights;
  return json;
}

ordered_json sweep_to_json(const Sweep& sweep, const ExerciseReference& exercise) {
  return {
      {"title", sweep.title},
      {"x_label", sweep.x_label},
      {"y_label", sweep.y_label},
      {"components",
       list_of(sweep.components,
               [](const PlotComponent& component) {
                 return ordered_json{{"name", component.name}, {"row", component.row}, {"col", component.col}};
               })},
      {"x", sweep.x},
      {"inputs", list_of(sweep.inputs,
                         [&](const std::vector<Value>& inputs) { return inputs_to_json(inputs, exercise.arguments); })},
      {"expected", values_to_json(sweep.expected, exercise.result_kind)}};
}

ordered_json exercise_to_json(const ExerciseReference& exercise) {
  const Kind kind = exercise.result_kind;
  const auto case_to_json = [&](const Case& one) {
    return ordered_json{{"name", one.name},
                        {"group", name_of(one.group, group_names)},
                        {"deciding", one.deciding},
                        {"inputs", inputs_to_json(one.inputs, exercise.arguments)},
                        {"expected", to_json(one.expected, kind)},
                        {"scale", one.scale},
                        {"tolerance", one.tolerance}};
  };
  const auto misconception_to_json = [&](const Misconception& misconception) {
    return ordered_json{{"name", misconception.name},
                        {"message", misconception.message},
                        {"notes", misconception.notes},
                        {"outputs", values_to_json(misconception.outputs, kind)},
                        {"sweep_outputs", values_to_json(misconception.sweep_outputs, kind)}};
  };
  const auto term_to_json = [&](const Term& term) {
    return ordered_json{
        {"name", term.name}, {"coefficient", term.coefficient}, {"outputs", values_to_json(term.outputs, kind)}};
  };
  const auto route_to_json = [&](const Route& route) {
    return ordered_json{{"name", route.name}, {"outputs", values_to_json(route.outputs, kind)}};
  };

  ordered_json json = {{"name", exercise.name},
                       {"signature", exercise.signature},
                       {"arguments", list_of(exercise.arguments, argument_to_json)},
                       {"result",
                        {{"name", exercise.result_name},
                         {"kind", to_string(kind)},
                         {"units", list_of(exercise.result_units, unit_to_json)}}},
                       {"comparison", name_of(exercise.comparison, comparison_names)},
                       {"tolerance_reason", exercise.tolerance_reason},
                       {"cases", list_of(exercise.cases, case_to_json)},
                       {"misconceptions", list_of(exercise.misconceptions, misconception_to_json)},
                       {"terms", list_of(exercise.terms, term_to_json)},
                       {"properties", list_of(exercise.properties, property_to_json)},
                       {"routes", list_of(exercise.routes, route_to_json)}};
  if (!exercise.sweep.x.empty()) json["sweep"] = sweep_to_json(exercise.sweep, exercise);
  return json;
}

// --- text

std::string on_one_line(const ordered_json& json) {
  if (json.is_primitive() || json.empty()) return json.dump();
  const bool is_object = json.is_object();
  std::string line;
  for (const auto& [key, item] : json.items()) {
    line += line.empty() ? (is_object ? "{" : "[") : ", ";
    if (is_object) line += ordered_json(key).dump() + ": ";
    line += on_one_line(item);
  }
  return line + (is_object ? "}" : "]");
}

bool is_list_of_plain_numbers(const ordered_json& json) {
  return json.is_array() &&
         std::ranges::all_of(json, [](const ordered_json& item) { return item.is_number() || item.is_null(); });
}

void append_text(std::string& text, const ordered_json& json, std::size_t indent) {
  const std::string line = on_one_line(json);
  if (json.is_primitive() || json.empty() || is_list_of_plain_numbers(json) || indent + line.size() <= line_width) {
    text += line;
    return;
  }
  const bool is_object = json.is_object();
  const char* separator = is_object ? "{" : "[";
  for (const auto& [key, item] : json.items()) {
    text += separator;
    text += '\n' + std::string(indent + 2, ' ');
    if (is_object) text += ordered_json(key).dump() + ": ";
    append_text(text, item, indent + 2);
    separator = ",";
  }
  text += '\n' + std::string(indent, ' ') + (is_object ? "}" : "]");
}

}  // namespace

ordered_json lecture_to_json(const LectureReference& lecture) {
  return {{"format", lecture.format},
          {"seed", lecture.seed},
          {"lecture", lecture.lecture},
          {"exercises", list_of(lecture.exercises, exercise_to_json)}};
}

std::string readable_text(const ordered_json& document) {
  std::string text;
  append_text(text, document, 0);
  return text + '\n';
}

}  // namespace workbook
