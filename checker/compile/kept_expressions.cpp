#include "checker/compile/kept_expressions.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/code_text.hpp"
#include "checker/compile/tokens.hpp"
#include "checker/messages/compiling.hpp"

#include <algorithm>

namespace workbook {
namespace {

constexpr std::string_view demand = "::workbook_values::PlainValue ";

// An expression is kept if it computes later, from operands that it only refers to. Zero(), Identity() and the like
// refer to nothing. A transpose or a block is a view, and harmless unless it looks at such an expression.
constexpr const char* concept_of_plain_values = R"(#line 1 "values"
namespace workbook_values {
template <class T> struct Refers { static constexpr bool value = true; };
template <class T> struct Refers<const T> : Refers<T> {};
template <class F, class P> struct Refers<Eigen::CwiseNullaryOp<F, P>> { static constexpr bool value = false; };
template <class F, class X> struct Refers<Eigen::CwiseUnaryOp<F, X>> : Refers<X> {};
template <class F, class L, class R> struct Refers<Eigen::CwiseBinaryOp<F, L, R>> {
  static constexpr bool value = Refers<L>::value || Refers<R>::value;
};
template <class T> struct Kept { static constexpr bool value = std::is_base_of_v<Eigen::ReturnByValue<T>, T>; };
template <class T> struct Kept<const T> : Kept<T> {};
template <class F, class X> struct Kept<Eigen::CwiseUnaryOp<F, X>> : Refers<X> {};
template <class F, class L, class R> struct Kept<Eigen::CwiseBinaryOp<F, L, R>>
    : Refers<Eigen::CwiseBinaryOp<F, L, R>> {};
template <class L, class R, int o> struct Kept<Eigen::Product<L, R, o>> { static constexpr bool value = true; };
template <class X> struct Kept<Eigen::Inverse<X>> { static constexpr bool value = true; };
template <class D, class R> struct Kept<Eigen::Solve<D, R>> { static constexpr bool value = true; };
template <class X> struct Kept<Eigen::Transpose<X>> : Kept<X> {};
template <class X, int r, int c, bool p> struct Kept<Eigen::Block<X, r, c, p>> : Kept<X> {};
template <class X, int n> struct Kept<Eigen::VectorBlock<X, n>> : Kept<X> {};
template <class X, int n> struct Kept<Eigen::Diagonal<X, n>> : Kept<X> {};
template <class X> struct Kept<Eigen::ArrayWrapper<X>> : Kept<X> {};
template <class X> struct Kept<Eigen::MatrixWrapper<X>> : Kept<X> {};
template <class T> concept PlainValue = !Kept<std::remove_cvref_t<T>>::value;
}
)";

/// True if an `auto` can demand something: of a variable or of the result of a function.
bool can_demand(const std::vector<Token>& tokens, std::size_t i) {
  if (!tokens[i].is("auto") || i + 2 >= tokens.size() || tokens[i + 1].kind != TokenKind::word) return false;
  if (tokens[i + 2].is("=") || tokens[i + 2].is("{")) return true;
  if (!tokens[i + 2].is("(")) return false;
  const auto close = closing_bracket(tokens, i + 2);
  if (!close) return false;
  for (std::size_t k = *close + 1; k < tokens.size() && !tokens[k].is("{") && !tokens[k].is(";"); ++k)
    if (tokens[k].is("->")) return false;  // auto f() -> Vector3d says its type
  return true;
}

/// The name behind an `auto`.
std::string name_behind(const std::string& source, std::size_t offset) {
  const std::vector<Token> tokens = tokens_of(std::string_view(source).substr(offset, 200));
  return tokens.size() > 1 ? std::string(tokens[1].text) : std::string();
}

}  // namespace

DemandingCopy demanding_copy(const std::string& source) {
  DemandingCopy copy;
  const std::string code = code_only(source);
  const std::vector<Token> tokens = tokens_of(code);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (can_demand(tokens, i)) copy.offsets.push_back(tokens[i].offset);
  if (copy.offsets.empty()) return copy;
  copy.before = concept_of_plain_values;
  std::size_t done = 0;
  for (const std::size_t offset : copy.offsets) {
    copy.source += source.substr(done, offset - done);
    copy.source += demand;
    done = offset;
  }
  copy.source += source.substr(done);
  return copy;
}

std::vector<Finding> kept_expressions(const std::vector<Diagnostic>& found, const DemandingCopy& copy,
                                      const std::string& source) {
  const std::vector<std::string> lines = lines_of(source);
  const std::vector<std::string> copied = lines_of(copy.source);
  std::vector<Finding> findings;
  const auto say = [&](std::size_t offset, std::string (*sentence)(messages::Operand)) {
    const int line = line_of(source, offset);
    const std::size_t begin = offset == 0 ? 0 : source.rfind('\n', offset - 1) + 1;
    const std::string& shown = lines[static_cast<std::size_t>(line - 1)];
    findings.push_back(
        {line, excerpt(shown, column_of(shown, offset - begin)), printable(sentence(name_behind(source, offset)))});
  };
  for (const Diagnostic& error : found) {
    const bool of_variable = error.text.find("deduced initializer does not satisfy") != std::string::npos;
    const bool of_result = error.text.find("deduced return type does not satisfy") != std::string::npos;
    const auto index = static_cast<std::size_t>(error.place.line - 1);
    if ((!of_variable && !of_result) || error.place.line <= 0 || index >= copied.size()) continue;
    // Where the error is in the copy; the last `auto` before it is meant.
    std::size_t at = byte_at_column(copied[index], error.place.column);
    for (std::size_t line = 0, begin = 0; line < index; ++line) {
      begin = copy.source.find('\n', begin) + 1;
      if (line + 1 == index) at += begin;
    }
    std::size_t added = 0;
    const std::size_t* last = nullptr;
    for (const std::size_t& offset : copy.offsets) {
      added += demand.size();
      if (offset + added <= at) last = &offset;
    }
    if (last != nullptr) say(*last, of_variable ? messages::keeps_expression : messages::returns_expression);
  }
  return findings;
}

}  // namespace workbook
