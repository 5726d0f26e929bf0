/// @file
/// Fills the memory that a function is given with known bytes. What it computes from memory that it never set then
/// differs from paint to paint.
#pragma once

#include <cstddef>
#include <cstdint>

namespace workbook {

void paint(void* first, std::size_t bytes, std::uint64_t color);

/// Paints the stack below the caller. Whatever the caller calls next finds it there.
void paint_stack(std::uint64_t color);

/// From now on malloc, and with it new and Eigen, hands out painted memory.
void paint_new_memory(std::uint64_t color);

}  // namespace workbook
