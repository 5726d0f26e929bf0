#include "checker/data/reference_results.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

namespace workbook {

using nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(Group, {{Group::worked, "worked"},
                                     {Group::special, "special"},
                                     {Group::random, "random"},
                                     {Group::generated, "generated"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Comparison, {{Comparison::plain, "plain"},
                                          {Comparison::up_to_sign, "up_to_sign"},
                                          {Comparison::eigenvectors, "eigenvectors"},
                                          {Comparison::attitude_by_angles, "attitude_by_angles"},
                                          {Comparison::attitude_by_yaw_pitch_roll, "attitude_by_yaw_pitch_roll"},
                                          {Comparison::rotation_by_vector, "rotation_by_vector"}})
NLOHMANN_JSON_SERIALIZE_ENUM(PropertyKind, {{PropertyKind::symmetric, "symmetric"},
                                            {PropertyKind::antisymmetric, "antisymmetric"},
                                            {PropertyKind::positive_semidefinite, "positive_semidefinite"},
                                            {PropertyKind::rotation_matrix, "rotation_matrix"},
                                            {PropertyKind::unit_norm, "unit_norm"},
                                            {PropertyKind::ascending, "ascending"},
                                            {PropertyKind::nonnegative, "nonnegative"},
                                            {PropertyKind::orthogonal_to_argument, "orthogonal_to_argument"},
                                            {PropertyKind::constant_weighted_square, "constant_weighted_square"}})

static void to_json(json& part, Kind kind) { part = to_string(kind); }
static void from_json(const json& part, Kind& kind) { kind = kind_from_string(part.get<std::string>()); }

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Unit, kilogram, metre, second, radian, is_torque)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Argument, name, kind, unit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Case, name, group, deciding, inputs, expected, scale, tolerance, condition, base,
                                   argument, entry)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Misconception, name, message, notes, outputs, sweep_outputs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InputTransform, name, message, outputs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Term, name, coefficient, outputs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Property, kind, message, notes, argument, weights)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Route, name, outputs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PlotComponent, name, row, col)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sweep, title, x_label, y_label, x, inputs, expected, components, y_unit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Limit, case_index, reason)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Region, words, holds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measured, name, inputs, errors)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Adequacy, made, killed, equal, survivors, neighbours, fingerprint)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ExerciseReference, name, signature, arguments, result_kind, result_name,
                                   result_units, comparison, tolerance_reason, cases, misconceptions, input_transforms,
                                   terms, properties, routes, sweep, limits, regions, measured, adequacy,
                                   has_current_adequacy, survivor_reasons)

namespace {

/// Throws unless the condition holds: what the judge takes for granted of an exercise.
struct Require {
  const ExerciseReference& exercise;

  void operator()(bool condition, const std::string& reason) const {
    if (!condition) throw std::invalid_argument(fmt::format("{}: {}", exercise.name, reason));
  }

  /// One value per case (or point of the sweep), each of the shape of the right one.
  void same_shapes(const std::string& owner, const std::vector<Value>& values, const std::vector<Value>& like) const {
    const auto has_shape = [](const Value& one, const Value& other) {
      return one.has_shape_of(other) && one.is_complete();
    };
    (*this)(std::ranges::equal(values, like, has_shape), owner + " has not one value of the right shape per case");
  }

  template <class Named>
  void distinct_names(const std::vector<Named>& all) const {
    std::set<std::string> names;
    for (const Named& each : all)
      (*this)(!each.name.empty() && names.insert(each.name).second,
              fmt::format("the name '{}' is empty or used twice", each.name));
  }
};

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
      return is_vector(result);
    default:
      return true;
  }
}

void require_sound_case(const Require& require, const ExerciseReference& exercise, const Case& one) {
  const std::size_t numbers = one.expected.numbers.size();
  const auto is_usable = [](const Value& value) { return value.is_complete() && value.is_finite(); };
  require(one.inputs.size() == exercise.arguments.size(), one.name + " has not one input per argument");
  require(std::ranges::all_of(one.inputs, is_usable) && is_usable(one.expected),
          one.name + " has a number that is not finite");
  const auto is_positive = [](double size) { return size > 0 && std::isfinite(size); };
  require(one.scale.size() == 1 || (numbers > 0 && one.scale.size() == numbers),
          one.name + " needs one scale, or one per number");
  require(std::ranges::all_of(one.scale, is_positive) && is_positive(one.tolerance),
          one.name + " needs a positive scale and tolerance");
  require(one.base < static_cast<int>(exercise.described_cases()) &&
              one.argument < static_cast<int>(exercise.arguments.size()) &&
              !(one.deciding && one.group == Group::generated),
          one.name + " decides although it is generated, or differs from no described case");
  require(exercise.result_units.size() == 1 || exercise.result_units.size() == numbers,
          one.name + ": the result needs one unit, or one per number");
  const bool is_attitude = exercise.comparison == Comparison::attitude_by_angles ||
                           exercise.comparison == Comparison::attitude_by_yaw_pitch_roll ||
                           exercise.comparison == Comparison::rotation_by_vector;
  require(!is_attitude || numbers == 3, "an attitude has three numbers");
  require(exercise.comparison != Comparison::eigenvectors ||
              (exercise.result_kind == Kind::matrix3 && one.inputs.at(0).has_shape_of(one.expected)),
          "eigenvectors have the shape of their matrix");
}

void require_sound(const ExerciseReference& exercise) {
  const Require require{exercise};
  require(!exercise.cases.empty() && !exercise.result_units.empty(), "it has no case or no unit");
  std::vector<Value> expected;
  for (const Case& one : exercise.cases) {
    require_sound_case(require, exercise, one);
    if (one.group != Group::generated) expected.push_back(one.expected);
  }
  require(expected.size() == exercise.described_cases(), "its generated cases do not come last");
  require.distinct_names(exercise.cases);
  require.distinct_names(exercise.arguments);
  require.distinct_names(exercise.misconceptions);
  for (const Misconception& each : exercise.misconceptions) {
    require.same_shapes(each.name, each.outputs, expected);
    require.same_shapes(each.name, each.sweep_outputs, exercise.sweep.expected);
  }
  for (const InputTransform& each : exercise.input_transforms) require.same_shapes(each.name, each.outputs, expected);
  for (const Term& each : exercise.terms) require.same_shapes(each.name, each.outputs, expected);
  for (const Route& each : exercise.routes) require.same_shapes(each.name, each.outputs, expected);
  for (const Property& each : exercise.properties) {
    require(suits(each.kind, exercise.result_kind), "a result of this kind cannot be " + to_string(each.kind));
    if (each.kind == PropertyKind::orthogonal_to_argument) {
      const auto argument = static_cast<std::size_t>(each.argument);
      require(argument < exercise.arguments.size() && exercise.arguments[argument].kind == exercise.result_kind,
              "the result is orthogonal to no argument, or to one of another kind");
    }
    if (each.kind == PropertyKind::constant_weighted_square)
      require(each.weights.size() == exercise.cases.size() &&
                  std::ranges::equal(each.weights, exercise.cases,
                                     [](auto& weights, auto& one) {
                                       return weights.size() == static_cast<std::size_t>(one.expected.rows);
                                     }),
              "the weights do not fit the rows");
  }
  for (const Limit& each : exercise.limits)
    require(each.case_index < expected.size() && !each.reason.empty(), "a limit has no case or no reason");
  for (const Region& each : exercise.regions)
    require(each.holds.size() == exercise.cases.size() + exercise.sweep.x.size(),
            "the region where " + each.words + " is not told of each case and each point of the sweep");
  for (const Measured& each : exercise.measured)
    require(each.inputs.size() == exercise.arguments.size() &&
                (each.errors.empty() || each.errors.size() == expected.front().numbers.size()),
            each.name + " has not one input per argument, or not one error per number");
  const Sweep& sweep = exercise.sweep;
  require(sweep.inputs.size() == sweep.x.size() && sweep.expected.size() == sweep.x.size(), "the sweep is incomplete");
  for (const PlotComponent& each : sweep.components)
    for (const Value& value : sweep.expected)
      require(each.row >= 0 && each.col >= 0 && each.row < value.rows && each.col < value.cols,
              "the plot has no " + each.name);
}

LectureReference parsed(const std::string& content, const std::string& only) {
  const std::size_t end = content.find('\n');
  if (end == std::string::npos) throw std::runtime_error("it ends too early");
  const json header = json::parse(content.substr(0, end));
  if (const int format = header.at("format"); format != LectureReference::format)
    throw std::runtime_error(fmt::format("it has format {}, this checker reads {}", format, LectureReference::format));
  const auto lines = lines_of(std::string_view(content).substr(end + 1));
  const auto require_intact = [](const json& checksum, const std::string& line) {
    if (checksum != fingerprint(line)) throw std::runtime_error("its checksum does not match its content");
  };
  require_intact(header.at("checksum"), lines.at(0));
  const json about = json::parse(lines.at(0));
  LectureReference lecture{about.at("seed"), about.at("lecture"), {}};
  const std::vector<std::string> names = about.at("exercises");
  if (lines.size() != names.size() + 1 || !content.ends_with('\n'))
    throw std::runtime_error("it has not one line per exercise");
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (!only.empty() && names[k] != only) continue;
    require_intact(about.at("checksums").at(k), lines[k + 1]);
    lecture.exercises.push_back(json::parse(lines[k + 1]));
    require_sound(lecture.exercises.back());
  }
  return lecture;
}

}  // namespace

std::string to_string(PropertyKind kind) { return json(kind).get<std::string>(); }

std::string ExerciseReference::survivor_reason(const std::string& bug) const {
  const auto found = std::ranges::find_if(survivor_reasons,
                                          [&](const auto& each) { return bug.find(each.first) != std::string::npos; });
  return found == survivor_reasons.end() ? "" : found->second;
}

std::size_t ExerciseReference::described_cases() const {
  const auto generated = std::ranges::find(cases, Group::generated, &Case::group);
  return static_cast<std::size_t>(generated - cases.begin());
}

const ExerciseReference& LectureReference::exercise(const std::string& name) const {
  const auto found = std::ranges::find(exercises, name, &ExerciseReference::name);
  if (found == exercises.end())
    throw ReferenceError(
        fmt::format("The reference results of {} hold no exercise {}: make them again.", lecture, name));
  return *found;
}

LectureReference read_reference_results(const std::filesystem::path& file, const std::string& only) {
  const auto content = read_file(file);
  if (!content) throw ReferenceError(fmt::format("The reference results {} cannot be read.", shown_path(file)));
  try {
    return parsed(*content, only);
  } catch (const std::exception& problem) {
    throw ReferenceError(
        fmt::format("The reference results {} are damaged: {}. Delete the file, and it is made again; in "
                    "a handed-out copy, take it from your instructor's once more.",
                    shown_path(file), without_full_stop(printable(problem.what()))));
  }
}

std::uint64_t seed_of_reference_results(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::getline(stream, line);
  const json about = json::parse(line, nullptr, false);
  const bool says = about.is_object() && about.contains("seed") && about["seed"].is_number_unsigned();
  return says ? about["seed"].get<std::uint64_t>() : 1;
}

void write_reference_results(const LectureReference& results, const std::filesystem::path& file) {
  try {
    for (const ExerciseReference& exercise : results.exercises) require_sound(exercise);
  } catch (const std::exception& problem) {
    throw ReferenceError(
        fmt::format("The reference results of {} are inconsistent: {}.", results.lecture, problem.what()));
  }
  json about = {
      {"lecture", results.lecture}, {"seed", results.seed}, {"exercises", json::array()}, {"checksums", json::array()}};
  std::string lines;
  for (const ExerciseReference& exercise : results.exercises) {
    const std::string line = json(exercise).dump();
    about["exercises"].push_back(exercise.name);
    about["checksums"].push_back(fingerprint(line));
    lines += line + "\n";
  }
  const json header = {{"format", LectureReference::format}, {"checksum", fingerprint(about.dump())}};
  const std::string content = fmt::format("{}\n{}\n{}", header.dump(), about.dump(), lines);
  if (const std::string reason = write_file(file, content); !reason.empty())
    throw ReferenceError(fmt::format("The reference results {} cannot be written: {}.", shown_path(file), reason));
}

std::map<std::string, Adequacy> read_adequacy(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  try {
    return json::parse(read_file(file).value()).get<std::map<std::string, Adequacy>>();
  } catch (const std::exception& problem) {
    throw ReferenceError(fmt::format("{} cannot be read: {}.", shown_path(file), without_full_stop(problem.what())));
  }
}

void write_adequacy(const std::map<std::string, Adequacy>& record, const std::filesystem::path& file) {
  if (const std::string reason = write_file(file, json(record).dump(1) + "\n"); !reason.empty())
    throw ReferenceError(fmt::format("{} cannot be written: {}.", shown_path(file), reason));
}

}  // namespace workbook
