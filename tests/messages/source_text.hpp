/// @file
/// The string literals of a C++ source, read as text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace workbook::testing {

struct Literal {
  std::size_t line = 0;
  std::string text;  ///< as it is written, escapes and all
};

/// All string literals outside comments, raw ones too.
std::vector<Literal> string_literals(const std::string& source);

/// Does a literal speak to a person: has it two words or more? Placeholders, paths and options are no words.
bool is_speech(const std::string& text);

}  // namespace workbook::testing
