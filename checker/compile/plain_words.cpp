#include "checker/compile/plain_words.hpp"

#include "checker/compile/eigen_type.hpp"
#include "checker/messages/compiling.hpp"

#include <cctype>
#include <charconv>
#include <optional>
#include <regex>

namespace workbook {
namespace {

constexpr std::size_t longest_arguments = 30;  // of a template, in letters; longer ones are folded
constexpr std::size_t none = std::string::npos;

bool is_letter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_'; }

/// Where the bracket that is open at `open` is closed.
std::size_t closing(std::string_view text, std::size_t open, char opens, char closes) {
  int level = 0;
  for (std::size_t at = open; at < text.size(); ++at) {
    if (text[at] == opens) ++level;
    if (text[at] == closes && --level == 0) return at;
  }
  return none;
}

/// Without " [with T = …; …]".
void drop_template_arguments(std::string& text) {
  for (std::size_t at = 0; (at = text.find(" [with ", at)) != none;) {
    const std::size_t end = closing(text, at + 1, '[', ']');
    text.erase(at, end == none ? none : end + 1 - at);
  }
}

/// 'A' {aka 'B'} becomes 'A' if A is a short name, else 'B'; inside quotes 'A {aka B}' becomes 'B'.
void choose_one_name(std::string& text) {
  for (std::size_t at = 0; (at = text.find(" {aka ", at)) != none;) {
    const std::size_t end = text.find('}', at);
    if (end == none || at == 0) break;
    std::string other = text.substr(at + 6, end - at - 6);
    const bool quoted = text[at - 1] == '\'';
    const std::size_t begin = quoted ? (at < 2 ? none : text.rfind('\'', at - 2)) : text.rfind('\'', at - 1);
    if (begin == none) break;
    const std::string name = quoted ? text.substr(begin + 1, at - begin - 2) : text.substr(begin + 1, at - begin - 1);
    if (!short_name(read_type(name)).empty()) {
      text.erase(at, end + 1 - at);
      continue;
    }
    const std::string better = quoted ? other : "'" + other;
    text.replace(begin, end + 1 - begin, better);
    at = begin + better.size();
  }
}

bool is_part(const std::string& name) {
  return name == "Block" || name == "VectorBlock" || name == "Transpose" || name == "Diagonal" || name == "Map" ||
         name == "Ref";
}

/// The short form of a template type of Eigen.
std::optional<std::string> shortened_type(std::string_view text) {
  const TypeName type = read_type(text);
  if (const std::string name = short_name(type); !name.empty()) return name;
  const std::optional<Shape> shape = shape_of(type);
  if (!shape || type.name == "MatrixBase" || type.name == "DenseBase") return std::nullopt;
  const auto size = [](int count) { return count < 0 ? std::string("n") : std::to_string(count); };
  return size(shape->rows) + "×" + size(shape->columns) + " " +
         (is_part(type.name) ? messages::part_noun() : messages::expression_noun());
}

/// Every template type in its short form.
std::string with_short_types(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const bool begins_word = is_letter(text[at]) && (at == 0 || (!is_letter(text[at - 1]) && text[at - 1] != ':'));
    if (!begins_word) {
      result += text[at++];
      continue;
    }
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || text[end] == ':')) ++end;
    // "operator<" and "operator<<" are no templates; nor is a comparison, before which stands a space.
    const bool is_template = end < text.size() && text[end] == '<' && !text.substr(at, end - at).ends_with("operator");
    const std::size_t close = is_template ? closing(text, end, '<', '>') : none;
    if (close == none) {
      result += text.substr(at, end - at);
      at = end;
      continue;
    }
    const std::string_view whole = text.substr(at, close + 1 - at);
    if (const auto shorter = shortened_type(whole)) {
      result += *shorter;
    } else {
      std::string arguments = with_short_types(text.substr(end + 1, close - end - 1));
      if (whole.starts_with("std::vector<")) arguments = arguments.substr(0, arguments.find(", std::allocator<"));
      result += text.substr(at, end - at);
      result += arguments.size() > longest_arguments ? "<…>" : "<" + arguments + ">";
    }
    at = close + 1;
  }
  return result;
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != none; at += to.size()) text.replace(at, from.size(), to);
}

/// Letters that GCC writes as "\U000003c9".
void decode_letters(std::string& text) {
  for (std::size_t at = 0; (at = text.find("\\U", at)) != none; ++at) {
    unsigned long point = 0;
    const char* const begin = text.data() + at + 2;
    if (text.size() < at + 10) return;
    const auto [stop, error] = std::from_chars(begin, begin + 8, point, 16);
    if (error != std::errc() || stop != begin + 8 || point < 0xa0 || point > 0x10ffff) continue;
    std::string letter;
    const auto tail = [&](int shift) { letter += static_cast<char>(0x80 | ((point >> shift) & 0x3f)); };
    if (point < 0x800) {
      letter += static_cast<char>(0xc0 | (point >> 6));
    } else if (point < 0x10000) {
      letter += static_cast<char>(0xe0 | (point >> 12));
      tail(6);
    } else {
      letter += static_cast<char>(0xf0 | (point >> 18));
      tail(12);
      tail(6);
    }
    tail(0);
    text.replace(at, 10, letter);
  }
}

}  // namespace

std::string in_contract_words(std::string signature) {
  signature = with_short_types(signature);
  static const std::regex constant("([\\w:]+(?:<\\w+>)?) const&");
  if (signature.size() > 2000) return signature;  // std::regex recurses over the length of its text
  return std::regex_replace(signature, constant, "const $1&");
}

std::string in_plain_words(std::string_view message) {
  std::string text(message);
  drop_template_arguments(text);
  choose_one_name(text);
  text = with_short_types(text);
  for (const std::string_view noise : {"Eigen::", " [-fpermissive]"}) replace_all(text, noise, "");
  replace_all(text, "'class ", "'");
  decode_letters(text);
  return text;
}

}  // namespace workbook
