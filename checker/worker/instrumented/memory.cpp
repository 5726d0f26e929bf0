#include "checker/worker/instrumented/memory.hpp"

#include <cstring>

namespace {

bool paints = false;
std::uint64_t new_color = 0;

}  // namespace

// The linker sends every call of malloc here (--wrap=malloc).
extern "C" void* __real_malloc(std::size_t bytes);
extern "C" void* __wrap_malloc(std::size_t bytes);

void* __wrap_malloc(std::size_t bytes) {
  void* const memory = __real_malloc(bytes);
  if (paints && memory != nullptr) workbook::paint(memory, bytes, new_color);
  return memory;
}

namespace workbook {

void paint(void* first, std::size_t bytes, std::uint64_t color) {
  char* next = static_cast<char*>(first);
  for (; bytes >= sizeof color; bytes -= sizeof color, next += sizeof color) std::memcpy(next, &color, sizeof color);
  std::memcpy(next, &color, bytes);
}

// Optimised, so that it keeps nothing on the stack that it paints.
[[gnu::noinline, gnu::optimize("O2")]] void paint_stack(std::uint64_t color) {
  constexpr std::size_t depth = std::size_t{128} * 1024;
  auto* next = reinterpret_cast<volatile std::uint64_t*>(__builtin_frame_address(0));
  for (std::size_t n = 0; n < depth / sizeof color; ++n) *--next = color;
}

void paint_new_memory(std::uint64_t color) {
  new_color = color;
  paints = true;
}

}  // namespace workbook
