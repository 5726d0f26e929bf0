// What live.js sees of a student's functions: their names, and a place for numbers.
#include "lectures/live/functions.hpp"

#include <string>

namespace {

workbook::live::Numbers arguments, result;

}  // namespace

extern "C" {

/// The names in the order of their numbers, with spaces between.
const char* live_names() {
  static std::string names;
  if (names.empty())
    for (const auto& function : workbook::live::functions)
      names += (names.empty() ? "" : " ") + std::string(function.name);
  return names.c_str();
}

/// A place for `count` numbers, the arguments of the next call.
double* live_arguments(int count) {
  arguments.resize(static_cast<std::size_t>(count));
  return arguments.data();
}

/// The result of the function with this number.
const double* live_call(int number) {
  result = workbook::live::functions[static_cast<std::size_t>(number)].call(arguments.data());
  return result.data();
}
}
