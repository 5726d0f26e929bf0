/// @file
/// What the terminal can show: colour and width, and text that fits it.
#pragma once

#include "checker/judging/value_text.hpp"

#include <cstddef>
#include <string>

namespace workbook {

enum class Style { plain, strong, quiet, good, bad, warning };

/// Renders text for one terminal. Colour never carries meaning alone: every coloured word also says what it means.
class Console {
 public:
  /// Text of the given width.
  explicit Console(std::size_t width = 80, bool color = false, bool plain = false)
      : width_(width), color_(color && !plain), plain_(plain) {}

  /// What standard output is: colour only on a terminal that is not dumb, without NO_COLOR, or where CLICOLOR_FORCE
  /// asks for it; the terminal's width, else the variable COLUMNS, else 80; plain if WORKBOOK_PLAIN is set.
  static Console of_standard_output();
  static Console of_standard_error();

  std::size_t width() const { return width_; }
  bool color() const { return color_; }

  /// True for screen readers: no colour, no drawings made of letters, nothing written over, and words for marks.
  bool plain() const { return plain_; }

  /// A mark in front of a line that says the same in words: "✓ ", or nothing in the plain mode.
  std::string mark(const std::string& mark, Style style) const;

  std::string styled(const std::string& text, Style style) const;

  /// Text broken between words, every line beginning with `indent` spaces. Line breaks in the text are kept.
  std::string wrapped(const std::string& text, std::size_t indent = 0) const;

  /// A bar like "#####....." that says how much is done, `width` wide; nothing in the plain mode.
  std::string bar(std::size_t done, std::size_t total, std::size_t width) const;

 private:
  std::size_t width_;
  bool color_;
  bool plain_;
};

}  // namespace workbook
