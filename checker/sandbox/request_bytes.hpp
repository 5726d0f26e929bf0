/// @file
/// What the checker sends, byte by byte; requests.hpp is the other end. To the worker and to the witness of a second
/// look alike.
#pragma once

#include "checker/data/value.hpp"
#include "checker/worker/protocol.hpp"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace workbook {

template <class T>
void append_bytes(std::vector<char>& bytes, const T* first, std::size_t count = 1) {
  const char* begin = reinterpret_cast<const char*>(first);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

/// The shapes of all arguments, and then their numbers.
inline void append_arguments(std::vector<char>& bytes, const std::vector<Value>& inputs) {
  for (const Value& input : inputs) {
    const protocol::Shape shape{input.rows, input.cols};
    append_bytes(bytes, &shape);
  }
  for (const Value& input : inputs) append_bytes(bytes, input.numbers.data(), input.numbers.size());
}

/// Tells a request from all others. Never 0: what was not asked has that one.
inline std::uint64_t random_nonce() {
  std::random_device device;
  return (std::uint64_t{device()} << 32) | device() | 1;
}

}  // namespace workbook
