/// @file
/// The words, numbers and signs of a source text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

enum class TokenKind { word, number, sign };

struct Token {
  TokenKind kind = TokenKind::sign;
  std::string_view text;   ///< a part of the code
  std::size_t offset = 0;  ///< in the code

  bool is(std::string_view other) const { return text == other; }
};

/// The tokens of a text without comments (see code_only), which must outlive them. Lines of the preprocessor are left
/// out. One sign is one operator: "+=", "::", "<<".
std::vector<Token> tokens_of(std::string_view code);

/// The token that closes the bracket at `open`, or nothing.
std::optional<std::size_t> closing_bracket(const std::vector<Token>& tokens, std::size_t open);

}  // namespace workbook
