#include "checker/compile/text_mistakes.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/code_text.hpp"
#include "checker/compile/tokens.hpp"
#include "checker/messages/compiling.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

namespace workbook {
namespace {

bool one_of(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// The value of a decimal whole number such as 2, 2u or 1'000; nothing for other literals.
std::optional<long> whole_number(const Token& token) {
  if (token.kind != TokenKind::number) return std::nullopt;
  std::string digits;
  for (const char letter : token.text)
    if (letter != '\'') digits += letter;
  const std::size_t end = digits.find_last_not_of("uUlL") + 1;
  if (digits.size() > 1 && digits[0] == '0') return std::nullopt;  // octal, hexadecimal, binary
  long value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + end, value);
  if (error != std::errc() || stop != digits.data() + end) return std::nullopt;
  return value;
}

std::optional<double> decimal_number(const Token& token) {
  if (token.kind != TokenKind::number) return std::nullopt;
  const std::string text(token.text);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end == text.c_str() ? std::nullopt : std::optional(value);
}

/// Reads one source and collects what is wrong in it.
class Reading {
 public:
  explicit Reading(const std::string& source)
      : code_(code_only(source)), lines_(lines_of(source)), tokens_(tokens_of(code_)) {
    has_own_types_ = std::ranges::any_of(
        tokens_, [](const Token& token) { return token.is("struct") || token.is("class") || token.is("union"); });
  }

  std::vector<Finding> result() {
    int brackets = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (text(i) == "[") ++brackets;
      if (text(i) == "]") --brackets;
      if (brackets == 0) look_for_whole_number_division(i);
      look_for_degrees(i);
      look_for_power(i);
      look_for_thrown_away_result(i);
      look_for_empty_body(i);
      look_for_sum_without_start(i);
      look_for_rounded_pi(i);
      if (text(i) == "float") add(i, messages::kept_in_float());
    }
    return std::move(found_);
  }

 private:
  std::string_view text(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string_view(); }
  std::string_view before(std::size_t i) const { return i > 0 ? text(i - 1) : std::string_view(); }
  std::string word(std::size_t i) const { return std::string(text(i)); }
  bool is_word(std::size_t i) const { return i < tokens_.size() && tokens_[i].kind == TokenKind::word; }

  void add(std::size_t i, const std::string& sentence) {
    const std::size_t offset = tokens_[i].offset;
    const int line = line_of(code_, offset);
    const std::size_t begin = offset == 0 ? 0 : code_.rfind('\n', offset - 1) + 1;
    const std::string& shown = lines_[static_cast<std::size_t>(line - 1)];
    found_.push_back({line, excerpt(shown, column_of(shown, offset - begin)), printable(sentence)});
  }

  /// 1/2, but not 4/2, x*1/2 or (double)1/2
  void look_for_whole_number_division(std::size_t i) {
    if (text(i + 1) != "/" || i + 2 >= tokens_.size()) return;
    const auto dividend = whole_number(tokens_[i]);
    const auto divisor = whole_number(tokens_[i + 2]);
    if (!dividend || !divisor || *divisor == 0 || *dividend % *divisor == 0) return;
    if (one_of(before(i), {"*", "/", "%", ")", ".", "->"})) return;
    add(i + 1, messages::whole_number_division(word(i) + "/" + word(i + 2), *dividend / *divisor));
  }

  /// sin(30) and sin(x * 180 / pi)
  void look_for_degrees(std::size_t i) {
    if (!one_of(text(i), {"sin", "cos", "tan"}) || text(i + 1) != "(" || one_of(before(i), {".", "->"})) return;
    const auto close = closing_bracket(tokens_, i + 1);
    if (!close) return;
    const std::size_t angle = text(i + 2) == "-" ? i + 3 : i + 2;
    if (angle + 1 == *close) {
      static constexpr std::array<double, 12> usual = {15, 30, 45, 60, 75, 90, 120, 135, 150, 180, 270, 360};
      const auto value = decimal_number(tokens_[angle]);
      if (value && std::ranges::find(usual, *value) != usual.end())
        add(i, messages::degrees_in(word(i), (angle > i + 2 ? "-" : "") + word(angle)));
      return;
    }
    bool to_degrees = false;
    for (std::size_t k = i + 2; k < *close; ++k) {
      if (decimal_number(tokens_[k]) != 180.0) continue;
      if (before(k) == "/") return;  // pi / 180 in the same argument turns degrees into radians
      std::size_t divisor = k + 2;
      while (text(divisor + 1) == "::") divisor += 2;
      const std::string_view name = text(divisor);
      if (text(k + 1) == "/" && one_of(name, {"pi", "PI", "M_PI", "Pi"})) to_degrees = true;
    }
    if (to_degrees) add(i, messages::turned_into_degrees(word(i)));
  }

  /// n ^ 2
  void look_for_power(std::size_t i) {
    if (text(i) != "^" || i == 0 || i + 1 >= tokens_.size()) return;
    const auto exponent = whole_number(tokens_[i + 1]);
    if (!exponent || *exponent < 2 || *exponent > 9) return;
    const std::string base = before(i) == ")" ? "(…)" : word(i - 1);
    add(i, messages::bitwise_for_power(base + " ^ " + word(i + 1)));
  }

  /// True for the methods of Eigen that change nothing.
  static bool is_pure(std::string_view method) {
    return one_of(method, {"transpose", "normalized", "inverse", "adjoint", "conjugate", "cross", "dot", "cwiseProduct",
                           "cwiseAbs", "cwiseInverse", "norm", "squaredNorm", "sum", "trace", "determinant", "eval"});
  }

  /// A.transpose(); as a statement
  void look_for_thrown_away_result(std::size_t i) {
    if (has_own_types_ || !is_word(i) || !(i == 0 || one_of(before(i), {";", "{", "}"}))) return;
    std::size_t at = i + 1;
    std::string method;
    while (text(at) == "." && is_word(at + 1) && text(at + 2) == "(") {
      const auto close = closing_bracket(tokens_, at + 2);
      if (!close) return;
      method = word(at + 1);
      at = *close + 1;
    }
    if (text(at) != ";") return;
    if (is_pure(method)) add(i, messages::result_thrown_away(method));
  }

  /// for (...);
  void look_for_empty_body(std::size_t i) {
    if (!one_of(text(i), {"for", "if"}) || text(i + 1) != "(") return;
    const auto close = closing_bracket(tokens_, i + 1);
    if (close && text(*close + 1) == ";") add(*close + 1, messages::empty_loop_body(word(i)));
  }

  /// Matrix3d I; for (...) I += ...;
  void look_for_sum_without_start(std::size_t i) {
    if (has_own_types_ || !is_word(i + 1) || text(i + 2) != ";" || before(i) == "static") return;
    if (!one_of(text(i), {"Matrix2d", "Matrix3d", "Matrix4d", "Vector2d", "Vector3d", "Vector4d"})) return;
    const std::string_view name = text(i + 1);
    std::optional<std::size_t> sum;
    for (std::size_t k = i + 3; k < tokens_.size(); ++k) {
      if (text(k) != name) continue;
      const std::string_view next = text(k + 1);
      if (!sum) {
        if (next != "+=" && next != "-=") return;
        sum = k;
      }
      if (next == "." && is_pure(text(k + 2))) continue;
      // Anything that may give it a value, on whatever way through the function.
      if (one_of(next, {"=", "<<", ".", "(", "[", "->"}) || one_of(before(k), {"&", "=", "["})) return;
      if (one_of(before(k), {"(", ","}) && one_of(next, {")", ","})) return;
    }
    if (sum) add(*sum, messages::sum_without_start(std::string(name), word(i)));
  }

  /// 3.1416
  void look_for_rounded_pi(std::size_t i) {
    const auto value = decimal_number(tokens_[i]);
    if (!value || !text(i).starts_with("3.14")) return;
    const double distance = std::abs(*value - std::numbers::pi);
    if (distance > 1e-15 && distance < 2e-3) add(i, messages::rounded_pi(word(i)));
  }

  std::string code_;
  std::vector<std::string> lines_;
  std::vector<Token> tokens_;
  bool has_own_types_ = false;  // whose methods may do anything
  std::vector<Finding> found_;
};

}  // namespace

std::vector<Finding> text_mistakes(const std::string& source) { return Reading(source).result(); }

}  // namespace workbook
