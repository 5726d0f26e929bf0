#include "checker/compile/compile.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>

namespace workbook {
namespace {

// `auto x = a + b;` keeps an expression of Eigen, not its value. The compiler is asked where that happens: in a copy of
// the file every `auto` demands a type that holds its own value. An expression is kept if it computes later, from
// operands that it only refers to. Zero(), Identity() and the like refer to nothing. A transpose or a block is a view,
// and harmless unless it looks at such an expression.
constexpr const char* demand_of_values = R"(namespace workbook_values {
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
#define auto ::workbook_values::PlainValue auto
)";

/// The text with `-> auto` at every lambda that says no type, so that the demand is made of its result too.
std::string with_types_of_lambdas(const SourceText& source) {
  const std::vector<Token>& tokens = source.tokens();
  std::string text;
  std::size_t copied = 0;
  for (std::size_t brace = 3; brace < tokens.size(); ++brace) {
    const std::size_t open = source.partner_of(brace - 1);
    if (tokens[brace].text != "{" || tokens[brace - 1].text != ")" || open == 0 || tokens[open - 1].text != "]")
      continue;
    text.append(source.text(), copied, tokens[brace].offset - copied) += "-> auto ";
    copied = tokens[brace].offset;
  }
  return text.append(source.text(), copied);
}

std::vector<Reason> kept_expressions(const SourceText& source, const Compiler& compiler) {
  const std::vector<Token>& tokens = source.tokens();
  compiler.write(with_types_of_lambdas(source), demand_of_values);
  // Other errors may be many: the demand does not fit everywhere.
  const FinishedProgram asked = compiler.run(compiler.arguments({"-fsyntax-only", "-w", "-fmax-errors=0", unit_name}));
  std::vector<Reason> findings;
  for (const Diagnostic& error : compiler.read(asked.output, "").diagnostics) {
    const bool of_result = error.text.starts_with("deduced return type does not satisfy");
    const bool is_kept = of_result || error.text.starts_with("deduced initializer does not satisfy");
    // The last `auto` before the error is meant, and the name after it.
    auto at = std::ranges::lower_bound(tokens, source.offset_of(error.place), {}, &Token::offset);
    while (is_kept && at != tokens.begin() && (at == tokens.end() || at->text != "auto")) --at;
    const auto name = std::find_if(at, tokens.end(), [](const Token& token) {
      return token.text != "auto" && token.text != "const" && token.text != "&" && token.text != "&&";
    });
    if (!is_kept || !error.header.empty() || name == tokens.end() || at->text != "auto") continue;
    const bool of_lambda = of_result && std::next(name) != tokens.end() && std::next(name)->text == "=";
    findings.push_back(source.reason(
        source.place_of(at->offset), "kept_expression",
        (of_lambda ? "`" : "With auto, `") + std::string(name->text) + (of_result ? "` returns" : "` holds") +
            " no result but a formula that is computed later, at every use, from operands that may have changed or "
            "gone by then: " +
            (of_lambda ? "write its type after the parameters, as in -> Vector3d."
                       : "write the type in place of auto."),
        Weight::possible, Fix::as_value));
  }
  return findings;
}

}  // namespace

std::vector<Reason> source_findings(const CompileTask& task, const Compilation& compilation, const Toolchain& toolchain,
                                    const std::filesystem::path& cache_directory, const CompileLimits& limits) {
  constexpr std::size_t most = 4;
  std::vector<Reason> all;
  const auto add = [&](std::vector<Reason> more) { std::ranges::move(more, std::back_inserter(all)); };
  const SourceText source(task.submission.text);
  try {
    const Workspace workspace(BuildCache(std::filesystem::absolute(cache_directory)).directory());
    const Compiler compiler(toolchain, limits, workspace.directory());
    if (std::ranges::count(source.tokens(), "auto", &Token::text) > 0) add(kept_expressions(source, compiler));
    add(text_mistakes(source));
    add(warned_mistakes(compiler.read(compilation.compiler_output, "").diagnostics, source));
  } catch (const std::exception&) {  // it is a help only; what matters has been judged
  }
  std::stable_partition(all.begin(), all.end(), std::not_fn(&Reason::is_remark));
  std::vector<Reason> found;
  for (Reason& finding : all) {
    const bool is_known = std::ranges::any_of(
        found, [&](const Reason& other) { return other.name == finding.name && other.line == finding.line; });
    if (!is_known && found.size() < most) found.push_back(std::move(finding));
  }
  std::ranges::stable_sort(found, {}, &Reason::line);
  return found;
}

}  // namespace workbook
