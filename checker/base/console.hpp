/// @file
/// What the terminal can show: colour and width, text that fits it, and how far a long piece of work has come.
#pragma once

#include <string>

namespace workbook {

enum class Style { plain, strong, quiet, good, bad, warning };

/// Renders text for one terminal. Colour never carries meaning alone: every coloured word also says what it means.
class Console {
 public:
  explicit Console(std::size_t width = 80, bool color = false, bool plain = false, bool has_links = false)
      : width_(width), color_(color && !plain), plain_(plain), has_links_(has_links && !plain) {}

  /// What standard output is: colour only on a terminal that is not dumb, without NO_COLOR, or where CLICOLOR_FORCE
  /// asks for it; links on such a terminal; its width, else the variable COLUMNS, else 80; plain if WORKBOOK_PLAIN is
  /// set.
  static Console of_standard_output();
  static Console of_standard_error();

  std::size_t width() const { return width_; }
  bool color() const { return color_; }

  /// True for screen readers: no colour, no drawings made of letters, nothing written over, and words for marks.
  bool plain() const { return plain_; }

  /// A mark in front of a line that says the same in words: "✓ ", or nothing in the plain mode.
  std::string mark(const std::string& mark, Style style) const;

  std::string styled(const std::string& text, Style style) const;

  /// A text to click on, on one line; where nobody clicks, the address itself, in one piece so that it can be copied.
  std::string linked(const std::string& text, const std::string& address) const;

  /// Text broken between words, every line beginning with `indent` spaces. Line breaks in the text are kept.
  std::string wrapped(const std::string& text, std::size_t indent = 0) const;

  /// A bar like "#####....." that says how much is done, `width` wide; nothing in the plain mode.
  std::string bar(std::size_t done, std::size_t total, std::size_t width) const;

 private:
  std::size_t width_;
  bool color_;
  bool plain_;
  bool has_links_;
};

/// One line on standard error that is written over and over, and gone at the end. It shows on a terminal only, and not
/// in the plain mode: a screen reader would read every state of it aloud.
class ProgressBar {
 public:
  /// @param wanted  false: nothing is ever shown
  explicit ProgressBar(bool wanted = true);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `done` of `total` pieces are done, and `what` is being done now.
  void show(std::size_t done, std::size_t total, const std::string& what);

  /// Takes the line away, so that something else can be printed.
  void clear();

 private:
  bool wanted_;
  bool shown_ = false;
};

}  // namespace workbook
