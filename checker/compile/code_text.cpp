#include "checker/compile/code_text.hpp"

#include "checker/base/printable.hpp"

#include <boost/locale/utf.hpp>

#include <algorithm>
#include <cctype>

namespace workbook {
namespace {

constexpr int widest_excerpt = 72;      // fits a terminal of 80 columns with some margin
constexpr int shown_behind_caret = 24;  // at least, in a line that is cut

/// One letter of a line, and the columns that it takes.
struct Letter {
  std::size_t begin = 0;
  std::size_t end = 0;
  int column = 1;
  int width = 1;
};

int width_of(boost::locale::utf::code_point point) {
  const auto within = [point](unsigned from, unsigned to) { return point >= from && point <= to; };
  if (within(0x0300, 0x036f) || within(0x200b, 0x200f) || within(0xfe00, 0xfe0f)) return 0;
  const bool wide = within(0x1100, 0x115f) || within(0x2e80, 0xa4cf) || within(0xac00, 0xd7a3) ||
                    within(0xf900, 0xfaff) || within(0xfe30, 0xfe6f) || within(0xff00, 0xff60) ||
                    within(0xffe0, 0xffe6) || within(0x1f300, 0x1faff) || within(0x20000, 0x3fffd);
  return wide ? 2 : 1;
}

std::vector<Letter> letters_of(std::string_view line) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::vector<Letter> letters;
  int column = 1;
  for (const char* next = line.data(); next != line.data() + line.size();) {
    const char* const begin = next;
    const boost::locale::utf::code_point point = Utf8::decode(next, line.data() + line.size());
    const bool valid = point != boost::locale::utf::illegal && point != boost::locale::utf::incomplete;
    if (!valid) next = begin + 1;
    int width = valid ? width_of(point) : 1;
    if (*begin == '\t') width = tab_stop - (column - 1) % tab_stop;
    letters.push_back(
        {static_cast<std::size_t>(begin - line.data()), static_cast<std::size_t>(next - line.data()), column, width});
    column += width;
  }
  return letters;
}

bool is_letter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_'; }

/// Walks through a source text and knows what is code.
class Blanking {
 public:
  explicit Blanking(std::string_view source) : text_(source) {}

  std::string result() {
    while (at_ < text_.size()) {
      if (starts("//")) {
        blank_line_comment();
      } else if (starts("/*")) {
        blank_until("*/");
      } else if (text_[at_] == '"' && is_raw()) {
        blank_raw();
      } else if (text_[at_] == '"' || (text_[at_] == '\'' && !is_digit_separator())) {
        blank_quoted(text_[at_]);
      } else {
        ++at_;
      }
    }
    return text_;
  }

 private:
  bool starts(std::string_view part) const { return std::string_view(text_).substr(at_).starts_with(part); }

  void blank() {
    if (text_[at_] != '\n' && text_[at_] != '\r') text_[at_] = ' ';
    ++at_;
  }

  void blank_line_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') {
      const bool goes_on = starts("\\\n") || starts("\\\r\n");
      blank();
      if (goes_on)
        while (at_ < text_.size() && (text_[at_] == '\n' || text_[at_] == '\r')) ++at_;
    }
  }

  void blank_until(std::string_view end) {
    std::size_t stop = text_.find(end, at_ + 2);
    stop = stop == std::string::npos ? text_.size() : stop + end.size();
    while (at_ < stop) blank();
  }

  bool is_raw() const {
    return at_ > 0 && text_[at_ - 1] == 'R' &&
           (at_ < 2 || !is_letter(text_[at_ - 2]) || text_[at_ - 2] == 'u' || text_[at_ - 2] == 'U' ||
            text_[at_ - 2] == 'L' || text_[at_ - 2] == '8');
  }

  void blank_raw() {
    const std::size_t open = text_.find('(', at_);
    if (open == std::string::npos || open - at_ > 17) return blank_quoted('"');
    const std::string end = ")" + text_.substr(at_ + 1, open - at_ - 1) + "\"";
    ++at_;
    std::size_t stop = text_.find(end, open);
    stop = stop == std::string::npos ? text_.size() : stop + end.size() - 1;
    while (at_ < stop) blank();
    if (at_ < text_.size()) ++at_;
  }

  /// 1'000'000
  bool is_digit_separator() const {
    return at_ > 0 && at_ + 1 < text_.size() && std::isxdigit(static_cast<unsigned char>(text_[at_ - 1])) != 0 &&
           std::isxdigit(static_cast<unsigned char>(text_[at_ + 1])) != 0 && begins_with_digit();
  }

  bool begins_with_digit() const {
    std::size_t begin = at_;
    while (begin > 0 && (is_letter(text_[begin - 1]) || text_[begin - 1] == '\'')) --begin;
    return std::isdigit(static_cast<unsigned char>(text_[begin])) != 0;
  }

  /// The marks stay, so that the code around them keeps its form.
  void blank_quoted(char mark) {
    ++at_;
    while (at_ < text_.size() && text_[at_] != mark && text_[at_] != '\n') {
      if (text_[at_] == '\\') blank();
      if (at_ < text_.size()) blank();
    }
    if (at_ < text_.size()) ++at_;
  }

  std::string text_;
  std::size_t at_ = 0;
};

}  // namespace

std::string code_only(std::string_view source) { return Blanking(source).result(); }

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.emplace_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

int line_of(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::ranges::count(text.substr(0, offset), '\n'));
}

std::size_t byte_at_column(std::string_view line, int column) {
  for (const Letter& letter : letters_of(line))
    if (column < letter.column + letter.width) return letter.begin;
  return line.size();
}

int column_of(std::string_view line, std::size_t offset) {
  int column = 1;
  for (const Letter& letter : letters_of(line)) {
    if (letter.end > offset) return letter.column;
    column = letter.column + letter.width;
  }
  return column;
}

std::string excerpt(std::string_view line, int column) {
  const std::vector<Letter> letters = letters_of(line);
  const int width = letters.empty() ? 0 : letters.back().column + letters.back().width - 1;
  int first = 1;
  int last = width;
  if (width > widest_excerpt) {
    // Two columns are kept for the marks where the line is cut.
    first = column > widest_excerpt - shown_behind_caret ? column - (widest_excerpt - shown_behind_caret) : 1;
    last = first + widest_excerpt - 2;
  }
  std::string text = first > 1 ? "…" : "";
  int caret = 0;  // how many columns stand before it
  int shown = first > 1 ? 1 : 0;
  for (const Letter& letter : letters) {
    if (letter.column < first || letter.column + letter.width - 1 > last) continue;
    if (letter.column <= column) caret = shown;
    const std::string_view bytes = line.substr(letter.begin, letter.end - letter.begin);
    text += bytes == "\t" ? std::string(static_cast<std::size_t>(letter.width), ' ') : printable(bytes);
    shown += letter.width;
  }
  if (last < width) text += "…";
  while (text.ends_with(' ')) text.pop_back();
  if (column <= 0) return text;
  if (column > width) caret = shown;
  return text + "\n" + std::string(static_cast<std::size_t>(caret), ' ') + "^";
}

}  // namespace workbook
