/// @file
/// The worker's main loop. All that it must know of an exercise it reads off the type of the contract's function.
#pragma once

#include "checker/data/kinds.hpp"

#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace workbook {

/// The result of one call, with the numbers only if the shape is the expected one.
struct CallResult {
  int expected_rows = 0;
  int expected_cols = 0;
  int rows = 0;
  int cols = 0;
  std::vector<double> numbers;

  bool has_expected_shape() const { return rows == expected_rows && cols == expected_cols; }

  template <class T>
  void keep(const T& value) {
    rows = KindOf<T>::rows(value);
    cols = KindOf<T>::cols(value);
    if (!has_expected_shape()) return;
    numbers.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
    KindOf<T>::write(value, numbers.data());
  }
};

using Call = std::function<void(const std::vector<NumbersView>& arguments, CallResult& result)>;

/// Answers requests until the checker hangs up. Returns the exit status of the worker.
int serve_calls(std::size_t argument_count, const Call& call);

/// Makes the student's function answer requests.
template <class Result, class... Parameters>
int serve(Result (*function)(Parameters...)) {
  return serve_calls(sizeof...(Parameters), [function](const std::vector<NumbersView>& arguments, CallResult& result) {
    [&]<std::size_t... Index>(std::index_sequence<Index...>) {
      result.keep<std::remove_cvref_t<Result>>(function(KindOfParameter<Parameters>::read(arguments[Index])...));
    }
    (std::index_sequence_for<Parameters...>{});
  });
}

}  // namespace workbook
