/// @file
/// What the checker sends, as a process on the other end of the channel reads it. Shared by the worker and by the
/// witness of a second look; for programs that a student's function is linked into.
#pragma once

#include "checker/data/kinds.hpp"
#include "checker/worker/protocol.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <vector>

namespace workbook {

/// False at the end of input.
inline bool read_exactly(void* to, std::size_t size) {
  char* next = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t got = ::read(protocol::channel, next, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    next += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// The arguments of one request, and the views of them that a call needs.
struct Arguments {
  std::vector<double> numbers;
  std::vector<NumbersView> views;

  /// Reads so many shapes, and then their numbers. False at the end of input.
  bool read(std::size_t count) {
    std::vector<protocol::Shape> shapes(count);
    if (!read_exactly(shapes.data(), count * sizeof(protocol::Shape))) return false;
    std::size_t total = 0;
    for (const protocol::Shape& shape : shapes) total += size(shape);
    numbers.resize(total);
    if (!read_exactly(numbers.data(), total * sizeof(double))) return false;
    const double* first = numbers.data();
    views.clear();
    for (const protocol::Shape& shape : shapes) {
      views.push_back({shape.rows, shape.cols, first});
      first += size(shape);
    }
    return true;
  }

 private:
  static std::size_t size(const protocol::Shape& shape) {
    return static_cast<std::size_t>(shape.rows) * static_cast<std::size_t>(shape.cols);
  }
};

}  // namespace workbook
