/// @file
/// Text for terminals, pages and JSON, and the library that formats it. All of it is UTF-8.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// Text from a student's process or file, safe to show: what is no valid UTF-8, control and bidirectional characters
/// become "?"; line ends and tabs stay.
std::string printable(std::string_view text);

/// The beginning of a text, at most that many bytes, never cut inside a character.
std::string cut(std::string_view text, std::size_t bytes);

/// How many columns of a terminal a text takes; none of our characters is wide.
std::size_t display_width(std::string_view text);

/// The text if it fits into `width` columns, else its beginning and "…".
std::string shortened(const std::string& text, std::size_t width);

/// Filled up with spaces to `width` columns, after the text or before it.
std::string padded(const std::string& text, std::size_t width);
std::string padded_left(const std::string& text, std::size_t width);

/// The lines of a text, without their ends ("\n" or "\r\n").
std::vector<std::string> lines_of(std::string_view text);

/// Whole words in lines of at most `width` columns, each beginning with `indent` spaces. Line ends in the text are
/// kept.
std::vector<std::string> wrapped_lines(std::string_view text, std::size_t width, std::size_t indent = 0);

/// "1 case", "3 cases"; `nouns` for words that take no s: plural(2, "matrix", "matrices").
std::string plural(std::size_t count, const std::string& noun, const std::string& nouns = "");

/// "a, b and c"
std::string listed(const std::vector<std::string>& words);

/// "Entry (1,2) …" for "entry (1,2) …".
std::string capitalized(std::string sentence);

std::string without_full_stop(std::string sentence);

/// "²" for 2, "⁻¹⁰" for −10: exponents of units and powers of ten.
std::string superscript(int exponent);

/// What a pattern found in a text.
struct Match {
  std::vector<std::string> groups;   ///< the whole, then what each of its groups stands for; empty: nothing was found
  std::vector<std::size_t> offsets;  ///< where these begin in the text

  explicit operator bool() const { return !groups.empty(); }
  /// "" for a group that took no part.
  std::string operator[](std::size_t group) const { return group < groups.size() ? groups[group] : ""; }
  /// A sentence in which the groups stand for "$1", "$2", … or these with another mark.
  std::string fill(std::string sentence, char mark = '$') const;
};

/// The first place that a regular expression (of Perl's syntax, with "[^]" for any sign) fits. Compiled patterns are
/// cached. By Boost.Regex: std::regex recurses over the length of the text, and a long line of a compiler's output
/// overflows the stack.
Match search(std::string_view text, std::string_view pattern);
/// All of them, which do not overlap.
std::vector<Match> search_all(std::string_view text, std::string_view pattern);
/// All of them replaced, by a text in which "$1" is the first group.
std::string replaced(std::string_view text, std::string_view pattern, const std::string& replacement);

/// Base64 with its closing "=" signs and without line breaks.
std::string base64(std::string_view bytes);
/// The bytes of such a text. @throws std::exception if it is none
std::string from_base64(std::string_view text);

/// Bytes as a 64-bit FNV-1a hash in 16 hexadecimal digits: tells contents apart, guards against damage, not forgery.
std::string fingerprint(std::string_view bytes);

/// A word as a POSIX shell reads it back: in single quotes where it needs them.
std::string shell_quoted(const std::string& word);

/// The known name with the fewest letters to change; empty if none is near enough to be meant.
std::string did_you_mean(const std::string& typed, const std::vector<std::string>& known);

/// A variable of the environment; where it is not set or empty, `otherwise`.
std::string environment(const char* variable, const char* otherwise = "");

/// What to type for a command of the checker: "./checker/run check NAME".
std::string command(const std::string& arguments);

}  // namespace workbook
