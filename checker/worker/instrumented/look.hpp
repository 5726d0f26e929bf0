/// @file
/// The main program of a witness: one question, one call of the student's function, and what was seen of it.
#pragma once

#include "checker/data/kinds.hpp"
#include "checker/worker/instrumented/memory.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <tuple>
#include <type_traits>
#include <vector>

namespace workbook {

/// The result of the call, as numbers.
struct WitnessedResult {
  int rows = 0;
  int cols = 0;
  std::vector<double> numbers;
};

/// Called before the student's function with the place of the result. Returns the paint for the stack.
using Ready = std::uint64_t (*)(void* result, std::size_t size);

/// Called after it.
using Done = void (*)();
using WitnessedCall = std::function<WitnessedResult(const std::vector<NumbersView>& arguments, Ready ready, Done done)>;

/// Answers the checker's question. Returns the exit status.
int witness(std::size_t argument_count, const WitnessedCall& call);

template <class Result, class... Parameters>
int look(Result (*function)(Parameters...)) {
  using Plain = std::remove_cvref_t<Result>;
  return witness(sizeof...(Parameters), [function](const std::vector<NumbersView>& arguments, Ready ready, Done done) {
    return [&]<std::size_t... Index>(std::index_sequence<Index...>) {
      std::tuple<std::remove_cvref_t<Parameters>...> values{KindOfParameter<Parameters>::read(arguments[Index])...};
      alignas(Plain) static unsigned char place[sizeof(Plain)];
      const Plain* const result = std::apply(
          [&](auto&... value) {
            const std::uint64_t color = ready(place, sizeof place);
            // Nothing may be called in between, for it would leave its own numbers on the painted stack.
            return new (place) Plain((paint_stack(color), function(value...)));
          },
          values);
      done();
      WitnessedResult seen;
      seen.rows = KindOf<Plain>::rows(*result);
      seen.cols = KindOf<Plain>::cols(*result);
      seen.numbers.resize(static_cast<std::size_t>(seen.rows) * static_cast<std::size_t>(seen.cols));
      KindOf<Plain>::write(*result, seen.numbers.data());
      return seen;
    }
    (std::index_sequence_for<Parameters...>{});
  });
}

}  // namespace workbook
