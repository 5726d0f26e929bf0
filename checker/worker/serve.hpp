/// @file
/// The worker's main loop. All that it must know of an exercise it reads off the type of the contract's function.
#pragma once

#include "checker/data/kinds.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <tuple>
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

/// Answers requests until the checker closes its side. Returns the exit status of the worker.
int serve_calls(std::size_t argument_count, const Call& call);

void flush_streams();  ///< where a file uses streams: streams.cpp is linked then

// What a diagnostic run does around a call; it does nothing in judging.
void before_call(std::int32_t mode);
void fill_memory(void* result, std::size_t size);  ///< the place of the result, and the stack
void after_call();

/// Makes the student's function answer requests.
template <class Result, class... Parameters>
int serve(Result (*function)(Parameters...)) {
  using Plain = std::remove_cvref_t<Result>;
  return serve_calls(sizeof...(Parameters), [function](const std::vector<NumbersView>& views, CallResult& seen) {
    [&]<std::size_t... Index>(std::index_sequence<Index...>) {
      std::tuple<std::remove_cvref_t<Parameters>...> arguments{KindOfParameter<Parameters>::read(views[Index])...};
      alignas(Plain) unsigned char place[sizeof(Plain)];
      // Nothing may be called in between, for it would leave its own numbers where memory was filled.
      const auto call = [&](auto&... argument) {
        return new (place) Plain((fill_memory(place, sizeof place), function(argument...)));
      };
      Plain* const result = std::apply(call, arguments);
      after_call();
      seen.keep(*result);
      std::destroy_at(result);
    }
    (std::index_sequence_for<Parameters...>{});
  });
}

}  // namespace workbook
