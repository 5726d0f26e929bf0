#include "tests/messages/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>
#include <string_view>

namespace workbook::testing {

namespace {

bool is_letter(char character) { return std::isalpha(static_cast<unsigned char>(character)) != 0; }

bool is_part_of_name(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
}

/// Walks through a source and gathers its literals.
class Reader {
 public:
  explicit Reader(std::string_view source) : source_(source) {}

  std::vector<Literal> literals() {
    while (at_ < source_.size()) {
      if (starts_with("//")) {
        at_ = end_of("\n", at_);
      } else if (starts_with("/*")) {
        at_ = end_of("*/", at_ + 2);
      } else if (source_[at_] == '"') {
        read_string();
      } else if (source_[at_] == '\'' && !is_digit_separator()) {
        skip_quoted('\'');
      } else {
        ++at_;
      }
    }
    return std::move(found_);
  }

 private:
  bool starts_with(std::string_view start) const { return source_.substr(at_).starts_with(start); }

  bool is_digit_separator() const {  // 1'000'000
    return at_ > 0 && is_part_of_name(source_[at_ - 1]);
  }

  /// Behind the next `mark`, or at the end.
  std::size_t end_of(std::string_view mark, std::size_t from) const {
    const std::size_t start = source_.find(mark, from);
    return start == std::string_view::npos ? source_.size() : start + mark.size();
  }

  /// Goes behind the closing quote, and returns its place.
  std::size_t skip_quoted(char quote) {
    for (++at_; at_ < source_.size() && source_[at_] != quote; ++at_) {
      if (source_[at_] == '\\') ++at_;
    }
    const std::size_t end = std::min(at_, source_.size());
    at_ = std::min(end + 1, source_.size());
    return end;
  }

  void keep(std::size_t first, std::size_t last) {
    const auto line = 1 + std::count(source_.begin(), source_.begin() + static_cast<std::ptrdiff_t>(first), '\n');
    found_.push_back({static_cast<std::size_t>(line), std::string(source_.substr(first, last - first))});
  }

  void read_string() {
    const std::size_t first = at_ + 1;
    if (at_ > 0 && source_[at_ - 1] == 'R') {
      const std::size_t bracket = std::min(source_.find('(', first), source_.size());
      const std::string end = ")" + std::string(source_.substr(first, bracket - first)) + "\"";
      at_ = end_of(end, bracket);
      keep(std::min(bracket + 1, at_), at_ - std::min(end.size(), at_));
    } else {
      keep(first, skip_quoted('"'));
    }
  }

  std::string_view source_;
  std::size_t at_ = 0;
  std::vector<Literal> found_;
};

/// Letters, perhaps with an apostrophe or a hyphen among them; punctuation around them does not count.
bool is_word(std::string_view text) {
  while (!text.empty() && !is_letter(text.front())) text.remove_prefix(1);
  while (!text.empty() && !is_letter(text.back())) text.remove_suffix(1);
  return text.size() >= 2 && std::ranges::all_of(text, [](char character) {
           return is_letter(character) || character == '\'' || character == '-' || (character & 0x80) != 0;
         });
}

}  // namespace

std::vector<Literal> string_literals(const std::string& source) { return Reader(source).literals(); }

bool is_speech(const std::string& text) {
  static const std::regex line_ends(R"(\\[nt])");
  static const std::regex placeholders(R"(\{[^{} ]*\})");
  std::istringstream parts(std::regex_replace(std::regex_replace(text, line_ends, " "), placeholders, ""));
  std::size_t words = 0;
  for (std::string part; parts >> part;) words += is_word(part) ? 1 : 0;
  return words >= 2;
}

}  // namespace workbook::testing
