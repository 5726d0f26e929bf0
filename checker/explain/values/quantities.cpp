#include "checker/explain/values/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace {

bool is_symmetric_everywhere(const ExerciseReference& exercise, std::size_t argument) {
  return std::ranges::all_of(exercise.cases, [argument](const Case& one) {
    const auto matrix = as_matrix(one.inputs[argument]);
    return (matrix - matrix.transpose()).norm() <= 1e-12 * matrix.norm();
  });
}

}  // namespace

std::string entry_suffix(Kind kind, std::size_t entry) {
  if (is_vector(kind)) return fmt::format("[{}]", entry);
  if (kind == Kind::matrix3) return fmt::format("({},{})", entry % 3, entry / 3);
  return "";
}

std::vector<Quantity> quantities_of(const ExerciseReference& exercise) {
  std::vector<Quantity> quantities;
  for (std::size_t a = 0; a < exercise.arguments.size(); ++a) {
    const Argument& argument = exercise.arguments[a];
    if (argument.kind == Kind::vector || argument.kind == Kind::points || argument.kind == Kind::matrices) continue;
    const bool is_symmetric = argument.kind == Kind::matrix3 && is_symmetric_everywhere(exercise, a);
    for (std::size_t n = 0; n < exercise.cases.front().inputs[a].numbers.size(); ++n) {
      if (is_symmetric && n % 3 > n / 3) continue;
      Quantity quantity{argument.name + entry_suffix(argument.kind, n), argument.unit, a, n, {}};
      for (const Case& one : exercise.cases) quantity.values.push_back(one.inputs[a].numbers[n]);
      quantities.push_back(std::move(quantity));
    }
  }
  return quantities;
}

}  // namespace workbook
