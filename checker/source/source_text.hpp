/// @file
/// A student's file as text: its lines and its tokens.
#pragma once

#include "checker/data/reason.hpp"

#include <initializer_list>
#include <string_view>
#include <vector>

namespace workbook {

inline constexpr std::string_view byte_order_mark = "\ufeff";

/// A word, a number, an operator (one of several letters is one token), or a text in quotation marks.
struct Token {
  std::string_view text;
  std::size_t offset = 0;
  bool in_directive = false;  ///< of the preprocessor

  bool is_literal() const { return (text[0] < '0' || text[0] > '9') && text.find_first_of("\"'") < 4; }
};

/// A place in the file. Columns count bytes from 1; 0: the whole line.
struct Place {
  int line = 0;
  int column = 0;
};

class SourceText {
 public:
  explicit SourceText(std::string_view text);  ///< the text must outlive it

  std::string_view text() const { return text_; }
  const std::vector<Token>& tokens() const { return tokens_; }

  /// The number of the token that closes the bracket with this number, or opens it; of a bracket without partner the
  /// last token, or the first; of any other token its own.
  std::size_t partner_of(std::size_t token) const { return partners_[token]; }
  /// The bracket around a token: the last one before it that is still open; 0 where there is none.
  std::size_t opening_around(std::size_t token) const;

  Place place_of(std::size_t offset) const;
  std::size_t offset_of(Place place) const;

  /// The line with @ at the place, and with every comment and all inside quotation marks turned into spaces; of a long
  /// line the part around the place.
  std::string marked_code(Place place) const;

  /// What is to be said of a place, with the line and a caret below it.
  Reason reason(Place place, std::string name, const std::string& sentence, Weight weight = Weight::cause,
                Fix fix = Fix::none) const;

 private:
  std::string_view line(int number) const;

  std::string_view text_;
  std::vector<Token> tokens_;
  std::vector<std::size_t> partners_;  ///< of each token
  std::vector<std::size_t> line_starts_{0};
};

/// One of the three kinds of brackets.
bool opens(std::string_view token);
bool closes(std::string_view token);
bool is_one_of(std::string_view token, std::initializer_list<std::string_view> tokens);

/// Does the file define a function of that name, in whatever namespace?
bool defines_function(const SourceText& source, std::string_view name);

/// A line with a caret below that byte column (none if it is 0): tabs as spaces, safe to print, and only the part
/// around the caret where the line is long.
std::string excerpt(std::string_view line, int column);

}  // namespace workbook
