/// @file
/// What rounding does to the results of a lecture: expected values and routes beside the same functions in extended
/// precision. Prints a line for each: part of the tolerance, tab, exercise, tab, where.
#include "checker/data/reference_results.hpp"
#include "checker/judging/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>

namespace workbook::judging {
std::map<std::string, std::function<Value(const std::vector<Value>&)>> extended_functions();
}

namespace {

using namespace workbook;

void print(const ExerciseReference& exercise, std::size_t i, const Value& result, const std::string& of) {
  double part = 0;
  for (const Deviation& deviation : deviations(exercise, i, result))
    part = std::max(part, deviation.relative_size() / deviation.tolerance);
  fmt::print("{:.2g}\t{}\t{}, {}\n", part, exercise.name, exercise.cases[i].name, of);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} REFERENCE_RESULTS\n", argv[0]);
    return 2;
  }
  const auto functions = judging::extended_functions();
  for (ExerciseReference& exercise : read_reference_results(argv[1]).exercises) {
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      Value& expected = exercise.cases[i].expected;
      const Value in_double = std::exchange(expected, functions.at(exercise.name)(exercise.cases[i].inputs));
      print(exercise, i, in_double, "the solution");
      for (const Route& route : exercise.routes)
        if (i < route.outputs.size()) print(exercise, i, route.outputs[i], route.name);
    }
  }
} catch (const std::exception& problem) {
  fmt::print(stderr, "{}\n", problem.what());
  return 3;
}
