#include "solutions/judging/lecture.hpp"

#include <fmt/format.h>

#include <utility>

namespace workbook::judging {

namespace detail {

double largest(const Value& value) {
  double result = 0.0;
  for (const double number : value.numbers) result = std::max(result, std::abs(number));
  return result;
}

namespace {

std::string type_name(Kind kind) {
  switch (kind) {
    case Kind::number:
      return "double";
    case Kind::integer:
      return "int";
    case Kind::vector2:
      return "Vector2d";
    case Kind::vector3:
      return "Vector3d";
    case Kind::vector:
      return "VectorXd";
    case Kind::matrix3:
      return "Matrix3d";
    case Kind::points:
      return "Matrix3Xd";
    case Kind::matrices:
      return "std::vector<Matrix3d>";
  }
  throw std::logic_error("a kind without a C++ type");
}

bool passed_by_value(Kind kind) { return kind == Kind::number || kind == Kind::integer; }

}  // namespace

std::string signature(const ExerciseReference& exercise) {
  std::string parameters;
  for (const Argument& argument : exercise.arguments) {
    if (!parameters.empty()) parameters += ", ";
    const std::string type = type_name(argument.kind);
    parameters += passed_by_value(argument.kind) ? fmt::format("{} {}", type, argument.name)
                                                 : fmt::format("const {}& {}", type, argument.name);
  }
  return fmt::format("{} {}({})", type_name(exercise.result_kind), exercise.name, parameters);
}

std::uint64_t batch_seed(std::uint64_t seed, const std::string& exercise, const std::string& batch) {
  // FNV-1a: a hash that is the same on every machine, unlike std::hash.
  std::uint64_t hash = 0xcbf29ce484222325ULL ^ seed;
  for (const char letter : fmt::format("{}/{}", exercise, batch)) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  return hash;
}

Case prototype(std::string name, Group group) {
  Case one;
  one.name = std::move(name);
  one.group = group;
  return one;
}

void require_usable(const std::string& exercise, const Case& judged) {
  const std::string place = fmt::format("{}, case '{}'", exercise, judged.name);
  if (!is_finite(judged.expected))
    throw std::logic_error(place + ": the reference solution gives a number that is not finite");
  if (judged.scale.size() != 1 && judged.scale.size() != judged.expected.numbers.size()) {
    throw std::logic_error(place + ": give one scale, or one for each number of the result");
  }
  for (const double scale : judged.scale) {
    if (!(scale > 0) || !std::isfinite(scale)) {
      throw std::logic_error(place + ": the expected result is zero, so say its natural scale with .scale(...)");
    }
  }
}

}  // namespace detail

LectureReference Lecture::evaluate(std::string name, std::uint64_t seed) const {
  LectureReference result;
  result.seed = seed;
  result.lecture = std::move(name);
  for (const auto& exercise : exercises_) result.exercises.push_back(exercise->evaluate(seed));
  return result;
}

}  // namespace workbook::judging
