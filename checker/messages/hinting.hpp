/// @file
/// The words around a hint.
#pragma once

#include <cstddef>
#include <string>

namespace workbook::messages {

/// The heading of a hint; `number` is counted from 1.
std::string hint_heading(std::size_t number, std::size_t total);
std::string hint_goes_on();
std::string hint_was_the_last(const std::string& notes, const std::string& anchor);

}  // namespace workbook::messages
