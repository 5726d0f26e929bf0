#include "checker/compile/tokens.hpp"

#include <cctype>

namespace workbook {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_word_letter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' ||
         static_cast<unsigned char>(letter) > 127;
}

/// The length of a number as the preprocessor sees it: 1.5e-3, 1'000u.
std::size_t number_length(std::string_view text) {
  std::size_t at = 1;
  while (at < text.size()) {
    const char before = text[at - 1];
    const bool exponent_sign = (text[at] == '+' || text[at] == '-') && (before == 'e' || before == 'E');
    if (!is_word_letter(text[at]) && text[at] != '.' && text[at] != '\'' && !exponent_sign) break;
    ++at;
  }
  return at;
}

std::size_t sign_length(std::string_view text) {
  for (const std::string_view sign : {"<<=", ">>=", "<=>", "...", "->*"})
    if (text.starts_with(sign)) return sign.size();
  for (const std::string_view sign : {"::", "->", "++", "--", "<<", "==", "!=", "<=", ">=", "&&", "||",
                                      "+=", "-=", "*=", "/=", "%=", "^=", "&=", "|="})
    if (text.starts_with(sign)) return sign.size();
  return 1;
}

}  // namespace

std::vector<Token> tokens_of(std::string_view code) {
  std::vector<Token> tokens;
  bool line_begins = true;
  for (std::size_t at = 0; at < code.size();) {
    const char letter = code[at];
    if (letter == '\n') line_begins = true;
    if (std::isspace(static_cast<unsigned char>(letter)) != 0) {
      ++at;
      continue;
    }
    if (letter == '#' && line_begins) {
      while (at < code.size() && code[at] != '\n') at += code.substr(at).starts_with("\\\n") ? 2 : 1;
      continue;
    }
    line_begins = false;
    const std::string_view rest = code.substr(at);
    Token token;
    std::size_t length = 1;
    if (is_digit(letter) || (letter == '.' && rest.size() > 1 && is_digit(rest[1]))) {
      token.kind = TokenKind::number;
      length = number_length(rest);
    } else if (is_word_letter(letter)) {
      token.kind = TokenKind::word;
      while (length < rest.size() && is_word_letter(rest[length])) ++length;
    } else {
      length = sign_length(rest);
    }
    token.text = rest.substr(0, length);
    token.offset = at;
    tokens.push_back(token);
    at += length;
  }
  return tokens;
}

std::optional<std::size_t> closing_bracket(const std::vector<Token>& tokens, std::size_t open) {
  int level = 0;
  for (std::size_t i = open; i < tokens.size(); ++i) {
    const std::string_view text = tokens[i].text;
    if (text == "(" || text == "[" || text == "{") ++level;
    if (text == ")" || text == "]" || text == "}")
      if (--level == 0) return i;
  }
  return std::nullopt;
}

}  // namespace workbook
