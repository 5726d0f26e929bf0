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
  /// Plain text of the given width.
  explicit Console(std::size_t width = 80, bool color = false) : width_(width), color_(color) {}

  /// What standard output is: colour only on a terminal that is not dumb and without NO_COLOR; the terminal's width,
  /// else the variable COLUMNS, else 80.
  static Console of_standard_output();

  std::size_t width() const { return width_; }
  bool color() const { return color_; }

  std::string styled(const std::string& text, Style style) const;

  /// Text broken between words, every line beginning with `indent` spaces. Line breaks in the text are kept.
  std::string wrapped(const std::string& text, std::size_t indent = 0) const;

  /// A bar like "#####....." that says how much is done, at most `width` wide.
  std::string bar(std::size_t done, std::size_t total, std::size_t width) const;

 private:
  std::size_t width_;
  bool color_;
};

/// The text, filled up with spaces to `width` columns.
std::string padded(const std::string& text, std::size_t width);

}  // namespace workbook
