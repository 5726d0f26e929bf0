/// @file
/// Functions of a student by their names, for the live figures, which call them as WebAssembly and have nothing but
/// numbers.
#pragma once

#include "checker/data/kinds.hpp"

#include <cstddef>
#include <tuple>
#include <vector>

namespace workbook::live {

/// Values one after the other, each as its rows, its columns, and its numbers column by column.
using Numbers = std::vector<double>;

/// A function; from the values of its arguments it makes that of its result.
struct Function {
  const char* name;
  Numbers (*call)(const double* arguments);
};

/// All of them. `checker live` writes this list.
extern const std::vector<Function> functions;

template <class Result, class... Parameters>
Numbers call(Result (*function)(Parameters...), const double* next) {
  const auto take = [&next] {
    const NumbersView view{static_cast<int>(next[0]), static_cast<int>(next[1]), next + 2};
    next += 2 + view.rows * view.cols;
    return view;
  };
  // Braces: from the first to the last.
  const std::tuple<std::remove_cvref_t<Parameters>...> arguments{KindOfParameter<Parameters>::read(take())...};
  // Not auto: a function that returns an expression of Eigen would leave dangling references.
  const std::remove_cvref_t<Result> result = std::apply(function, arguments);
  using Kind = KindOfParameter<Result>;
  const int rows = Kind::rows(result), cols = Kind::cols(result);
  Numbers numbers(2 + static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
  numbers[0] = rows;
  numbers[1] = cols;
  Kind::write(result, numbers.data() + 2);
  return numbers;
}

}  // namespace workbook::live
