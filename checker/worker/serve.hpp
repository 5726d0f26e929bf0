/// @file
/// The worker's main loop. All that it must know of an exercise it reads off the type of the contract's function.
#pragma once

#include "checker/data/kinds.hpp"

#include <cstddef>
#include <cstdint>
#include <new>
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
    if (double* const place = place_for(KindOf<T>::rows(value), KindOf<T>::cols(value))) KindOf<T>::write(value, place);
  }

 private:
  /// Where the numbers of a result of this shape go; null if another one is expected.
  double* place_for(int rows_of_result, int cols_of_result);
};

/// Calls a student's function, whose type it knows.
using Call = void (*)(void (*function)(), const NumbersView* arguments, CallResult& result);

/// Answers requests until the checker closes its side. Returns the exit status of the worker.
int serve_calls(std::size_t argument_count, Call call, void (*function)());

void flush_streams();  ///< where a file uses streams: streams.cpp is linked then

// What is done around a call: in judging only the place of the result is filled.
void before_call(std::int32_t mode);
void fill_memory(void* result, std::size_t size);  ///< the place of the result, and the stack
void after_call();

/// Makes the student's function answer requests. One such source is compiled for each exercise, so it names few
/// templates.
template <class Result, class... Parameters>
int serve(Result (*function)(Parameters...)) {
  const Call call = [](void (*typeless)(), const NumbersView* views, CallResult& seen) {
    const auto function_of_the_student = reinterpret_cast<Result (*)(Parameters...)>(typeless);
    using Plain = std::remove_cvref_t<Result>;
    alignas(Plain) unsigned char place[sizeof(Plain)];
    // Nothing may be called in between, for it would leave its own numbers where memory was filled.
    const auto call_with = [&](auto&&... argument) {
      return new (place) Plain((fill_memory(place, sizeof place), function_of_the_student(argument...)));
    };
    Plain* const result = [&]<std::size_t... Index>(std::index_sequence<Index...>) {
      return call_with(KindOfParameter<Parameters>::read(views[Index])...);
    }
    (std::index_sequence_for<Parameters...>{});
    after_call();
    seen.keep(*result);
    result->~Plain();
  };
  return serve_calls(sizeof...(Parameters), call, reinterpret_cast<void (*)()>(function));
}

}  // namespace workbook
