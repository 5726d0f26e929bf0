#include "checker/source/source_text.hpp"

#include "checker/base/text.hpp"

#include <algorithm>
#include <cctype>

namespace workbook {
namespace {

bool is_letter(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || (letter & 0x80) != 0;
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Up to the end of what is looked for, or of the text.
std::size_t length_up_to(std::string_view rest, std::string_view end, std::size_t from) {
  const std::size_t found = rest.find(end, from);
  return found == std::string_view::npos ? rest.size() : found + end.size();
}

/// Of what is no token: a space, a comment, the end of a line that goes on. 0: a token is next.
std::size_t length_of_blank(std::string_view rest) {
  if (rest.starts_with("\\\n") || rest.starts_with("\\\r\n")) return length_up_to(rest, "\n", 0);
  if (rest.starts_with(byte_order_mark)) return byte_order_mark.size();
  if (rest.starts_with("/*")) return length_up_to(rest, "*/", 2);
  if (!rest.starts_with("//")) return std::isspace(static_cast<unsigned char>(rest[0])) != 0 ? 1 : 0;
  std::size_t end = std::min(rest.find('\n'), rest.size());
  while (end < rest.size() && rest.substr(0, end - (rest[end - 1] == '\r' ? 1 : 0)).ends_with('\\'))
    end = std::min(rest.find('\n', end + 1), rest.size());
  return end;
}

/// @param mark  where the opening quotation mark is; before it may stand a prefix
std::size_t length_of_literal(std::string_view rest, std::size_t mark) {
  if (mark > 0 && rest[mark - 1] == 'R')
    if (const std::size_t open = rest.substr(0, mark + 18).find('('); open != std::string_view::npos)
      return length_up_to(rest, ")" + std::string(rest.substr(mark + 1, open - mark - 1)) + "\"", open);
  std::size_t end = mark + 1;
  while (end < rest.size() && rest[end] != rest[mark] && rest[end] != '\n') end += rest[end] == '\\' ? 2 : 1;
  if (end < rest.size() && rest[end] == rest[mark]) ++end;
  return std::min(end, rest.size());
}

std::size_t length_of_token(std::string_view rest) {
  std::size_t end = 1;
  if (rest[0] == '"' || rest[0] == '\'') return length_of_literal(rest, 0);
  if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
    for (; end < rest.size(); ++end) {
      const bool has_sign = (rest[end] == '+' || rest[end] == '-') && (rest[end - 1] == 'e' || rest[end - 1] == 'E');
      const bool separates = rest[end] == '\'' && end + 1 < rest.size() && is_letter(rest[end + 1]);
      if (!is_letter(rest[end]) && rest[end] != '.' && !separates && !has_sign) break;
    }
    return end;
  }
  if (is_letter(rest[0])) {
    while (end < rest.size() && is_letter(rest[end])) ++end;
    return end <= 3 && rest[end - 1] == 'R' && rest.substr(end).starts_with('"') ? length_of_literal(rest, end) : end;
  }
  for (const std::string_view sign : {"<<=", ">>=", "<=>", "->*", "::", "->", "++", "--", "<<", "==", "!=", "<=",
                                      ">=",  "&&",  "||",  "+=",  "-=", "*=", "/=", "%=", "^=", "&=", "|="})
    if (rest.starts_with(sign)) return sign.size();
  return 1;
}

}  // namespace

SourceText::SourceText(std::string_view text) : text_(text) {
  bool in_directive = false;
  bool line_begins = true;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '\n') {
      line_begins = true;
      in_directive = false;
    }
    const std::string_view rest = text.substr(at);
    const std::size_t blank = length_of_blank(rest);
    const std::size_t length = blank > 0 ? blank : length_of_token(rest);
    if (blank == 0) {
      in_directive |= line_begins && text[at] == '#';
      line_begins = false;
      tokens_.push_back({rest.substr(0, length), at, in_directive});
    }
    for (const std::size_t end = at + length; at < end; ++at)
      if (text[at] == '\n') line_starts_.push_back(at + 1);
  }
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < tokens_.size(); ++k) {
    const std::string_view token = tokens_[k].text;
    partners_.push_back(opens(token) ? tokens_.size() - 1 : closes(token) ? 0 : k);
    if (opens(token)) open.push_back(k);
    if (!closes(token) || open.empty()) continue;
    partners_[k] = open.back();
    partners_[open.back()] = k;
    open.pop_back();
  }
}

std::size_t SourceText::opening_around(std::size_t token) const {
  while (token > 0) {
    if (opens(tokens_[--token].text)) return token;
    token = partners_[token];
  }
  return 0;
}

std::string_view SourceText::line(int number) const {
  const auto index = static_cast<std::size_t>(number - 1);
  if (number < 1 || index >= line_starts_.size()) return {};
  const std::size_t end = index + 1 < line_starts_.size() ? line_starts_[index + 1] - 1 : text_.size();
  const std::string_view line = text_.substr(line_starts_[index], end - line_starts_[index]);
  return line.substr(0, line.size() - (line.ends_with('\r') ? 1 : 0));
}

Place SourceText::place_of(std::size_t offset) const {
  const auto next = std::ranges::upper_bound(line_starts_, offset);
  return {static_cast<int>(next - line_starts_.begin()), static_cast<int>(offset - *(next - 1)) + 1};
}

std::size_t SourceText::offset_of(Place place) const {
  if (place.line < 1 || static_cast<std::size_t>(place.line) > line_starts_.size()) return text_.size();
  return line_starts_[static_cast<std::size_t>(place.line - 1)] +
         std::min(static_cast<std::size_t>(std::max(place.column, 1) - 1), line(place.line).size());
}

std::string SourceText::marked_code(Place place) const {
  constexpr std::size_t reach = 700;
  const std::size_t at = offset_of(place);
  const std::string_view line = this->line(place.line);
  const std::size_t line_begin = at - std::min<std::size_t>(at - offset_of({place.line, 1}), reach);
  const std::size_t line_end = std::min(offset_of({place.line, 1}) + line.size(), at + reach);
  std::string code(line_end - line_begin, ' ');
  for (auto token = std::ranges::lower_bound(tokens_, line_begin, {}, &Token::offset);
       token != tokens_.end() && token->offset < line_end; ++token) {
    for (std::size_t i = 0; i < token->text.size() && token->offset + i < line_end; ++i)
      if (!token->is_literal() || token->text[i] == '"' || token->text[i] == '\'')
        code[token->offset + i - line_begin] = token->text[i];
  }
  return code.insert(at - line_begin, "@");
}

Reason SourceText::reason(Place place, std::string name, const std::string& sentence, Weight weight, Fix fix) const {
  const std::string_view shown = line(place.line);
  const bool is_there = shown.data() != nullptr;  // a #line can name any
  return {.kind = ReasonKind::code,
          .name = std::move(name),
          .sentence = printable(sentence),
          .weight = weight,
          .line = is_there ? place.line : 0,
          .column = place.column,
          .excerpt = is_there ? excerpt(shown, place.column) : "",
          .fix = fix};
}

bool opens(std::string_view token) { return token == "(" || token == "[" || token == "{"; }
bool closes(std::string_view token) { return token == ")" || token == "]" || token == "}"; }
bool is_one_of(std::string_view token, std::initializer_list<std::string_view> tokens) {
  return std::ranges::find(tokens, token) != tokens.end();
}

bool defines_function(const SourceText& source, std::string_view name) {
  const std::vector<Token>& tokens = source.tokens();
  for (std::size_t k = 1; k + 1 < tokens.size(); ++k) {
    // "Matrix3d NAME(…) {", and no call: nothing like a type or "rigid::" stands before that, or no { after it.
    const char before = tokens[k - 1].text.back();
    const bool has_type = std::isalnum(static_cast<unsigned char>(before)) != 0 ||
                          std::string_view("_>&*:").find(before) != std::string_view::npos;
    if (tokens[k].text != name || tokens[k + 1].text != "(" || !has_type || tokens[k].in_directive) continue;
    const std::size_t after = source.partner_of(k + 1) + 1;
    if (after < tokens.size() && (tokens[after].text == "{" || tokens[after].text == "noexcept")) return true;
  }
  return false;
}

std::string excerpt(std::string_view line, int column) {
  constexpr std::size_t widest = 72;  // fits a terminal of 80 columns with some margin
  constexpr std::size_t before_caret = 48;
  const std::size_t caret = std::min(static_cast<std::size_t>(std::max(column, 1)) - 1, line.size());
  std::size_t first = line.size() > widest && caret > before_caret ? caret - before_caret : 0;
  while (first > 0 && (line[first] & 0xC0) == 0x80) --first;  // not inside a character
  std::string before = printable(line.substr(first, caret - first));
  std::string text = before + printable(line.substr(caret, widest - (caret - first)));
  for (std::string* part : {&before, &text}) std::ranges::replace(*part, '\t', ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  if (first > 0) text.insert(0, "…");
  if (line.size() > first + widest) text += "…";
  const std::size_t width = display_width(before) + (first > 0 ? 1 : 0);
  return column <= 0 ? text : text + "\n" + std::string(width, ' ') + "^";
}

}  // namespace workbook
