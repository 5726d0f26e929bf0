#include "checker/base/formulas.hpp"

#include "checker/base/text.hpp"

#include <array>
#include <cctype>
#include <map>
#include <utility>

namespace workbook {

namespace {

/// What a command without arguments is; all others are functions, which are called as they are: "cos".
constexpr std::string_view signs =
    "alpha=α;beta=β;gamma=γ;delta=δ;epsilon=ε;varepsilon=ε;zeta=ζ;eta=η;theta=θ;vartheta=θ;kappa=κ;lambda=λ;mu=μ;nu=ν;"
    "xi=ξ;pi=π;rho=ρ;sigma=σ;tau=τ;phi=φ;chi=χ;psi=ψ;omega=ω;Gamma=Γ;Delta=Δ;Theta=Θ;Lambda=Λ;Pi=Π;Phi=Φ;Psi=Ψ;Omega=Ω;"
    "ell=ℓ;partial=∂;times= × ;cdot=·;pm=±;mp=∓;le= ≤ ;ge= ≥ ;ne= ≠ ;ll= ≪ ;gg= ≫ ;approx= ≈ ;propto= ∝ ;to= → ;"
    "mapsto= ↦ ;iff= ⇔ ;Longrightarrow= ⇒ ;perp=⊥;parallel=∥;angle=∠;sum=Σ;int=∫ ;oint=∮ ;langle=⟨;rangle=⟩;infty=∞;"
    "dots=…;cdots=…;degree=°;T=ᵀ;Inertia=I;One=1;dd=d;CM=CM;bodyframe=body;inertialframe=inertial;quad=\t;qquad=\t;"
    "left=;right=;bigl=;bigr=;Bigl=;Bigr=;";

/// Marks over a letter, which Unicode has as characters that follow it.
const std::map<std::string, std::string> accents = {{"dot", "\u0307"}, {"ddot", "\u0308"}, {"tilde", "\u0303"},
                                                    {"hat", "\u0302"}, {"unit", "\u0302"}, {"bar", "\u0304"}};

std::string in_parentheses_if_long(const std::string& text) {
  return text.find_first_of(" +/=<>,") != std::string::npos || text.find("−") != std::string::npos ? "(" + text + ")"
                                                                                                   : text;
}

/// Small digits where they are all digits, else with a mark in front.
std::string raised_or_lowered(const std::string& group, char mark) {
  const std::string text = replaced(group, "^ +| +$", "");
  constexpr std::array raised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  constexpr std::array lowered = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  const std::string digits = replaced(text, mark == '^' ? "^−" : "^$", "");
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
    return text == "ᵀ" || text == "°" || text == "′" ? text : mark + in_parentheses_if_long(text);
  std::string small = digits.size() < text.size() ? "⁻" : "";
  for (const char digit : digits) small += (mark == '^' ? raised : lowered)[static_cast<std::size_t>(digit - '0')];
  return small;
}

class Formula {
 public:
  explicit Formula(std::string_view tex) : tex_(tex) {}

  /// All up to the closing brace or the end.
  std::string group() {
    std::string text;
    while (at_ < tex_.size() && tex_[at_] != '}') text += next();
    ++at_;
    return text;
  }

 private:
  /// A group in braces, a command with all that belongs to it, or one character.
  std::string argument() {
    while (at_ < tex_.size() && std::isspace(static_cast<unsigned char>(tex_[at_])) != 0) ++at_;
    if (at_ == tex_.size() || tex_[at_] != '{') return next();
    ++at_;
    return group();
  }

  std::string next() {
    if (at_ == tex_.size()) return "";
    const char here = tex_[at_++];
    if (here == '\\') return command();
    if (here == '{') return group();
    if (here == '^' || here == '_') return raised_or_lowered(argument(), here);
    if (here == '-') return "−";
    if (here == '\'') return "′";
    if (here == '&') return is_matrix_ ? ", " : "";
    return here == '~' || std::isspace(static_cast<unsigned char>(here)) != 0 ? " " : std::string(1, here);
  }

  std::string command() {
    const Match name = search(tex_.substr(at_), "^([A-Za-z]+|[^])");
    at_ += name[1].size();
    if (name[1] == "\\") {
      at_ += search(tex_.substr(at_), R"(^(\[\w+\])?)")[0].size();
      return is_matrix_ ? "; " : "\n";
    }
    if (name[1] == "begin" || name[1] == "end") {
      is_matrix_ = argument().ends_with("matrix") && name[1] == "begin";
      was_matrix_ = was_matrix_ || is_matrix_;
      if (is_matrix_) return "(";
      return name[1] == "end" && std::exchange(was_matrix_, false) ? ")" : "";
    }
    if (std::isalpha(static_cast<unsigned char>(name[1][0])) == 0)  // a brace, a negative space, a space
      return name[1] == "{" || name[1] == "}" ? name[1] : name[1] == "!" ? "" : " ";
    if (const Match sign = search(signs, "(?:^|;)" + name[1] + "=([^;]*);")) return sign[1];
    if (const auto accent = accents.find(name[1]); accent != accents.end()) return argument() + accent->second;
    if (name[1] == "frac" || name[1] == "tfrac") {
      const std::string above = in_parentheses_if_long(argument()), below = in_parentheses_if_long(argument());
      const bool is_factor = !search(tex_.substr(at_), R"(^(\\[,;] ?|\s)*([\w({]|\\[A-Za-z]))").groups.empty();
      return is_factor ? "(" + above + "/" + below + ") " : above + "/" + below;
    }
    if (name[1] == "sqrt") return "√" + in_parentheses_if_long(argument());
    if (name[1] == "ratein") {
      const std::string of = argument();
      return fmt::format("(d{}/dt)_{}", of, argument());
    }
    for (const char* as_it_is : {"vec", "mat", "mathrm", "text", "operatorname"})
      if (name[1] == as_it_is) return argument();
    return name[1] + (search(tex_.substr(at_), R"(^\s*[\w\\])") ? " " : "");
  }

  std::string_view tex_;
  std::size_t at_ = 0;
  bool is_matrix_ = false, was_matrix_ = false;
};

}  // namespace

std::string with_readable_formulas(const std::string& markdown) {
  std::string text;
  for (const std::string& line : lines_of(markdown)) {
    const bool is_continued = !text.empty() && text.back() != '\n' && !line.empty() && !search(line, "^(#|- )");
    text += line.empty() ? "\n\n" : (is_continued ? " " : text.empty() || text.back() == '\n' ? "" : "\n") + line;
  }
  std::string readable;
  std::size_t at = 0;
  for (const Match& found : search_all(text, R"(\\f\$([^]*?)\\f\$|\s*\\f\[([^]*?)\\f\]\s*)")) {
    readable += text.substr(at, found.offsets[0] - at);
    at = found.offsets[0] + found[0].size();
    const bool is_display = found[1].empty();
    std::string formula = replaced(Formula(is_display ? found[2] : found[1]).group(), " {2,}", " ");
    formula = replaced(replaced(replaced(formula, " *\t *", "   "), "^\\s+|\\s+$", ""), " +([.,;])( |\n|$)", "$1$2");
    readable += is_display ? "\n\n    " + replaced(formula, "\\s*\n\\s*", "\n    ") + "\n\n" : formula;
  }
  readable += text.substr(at);
  readable = replaced(readable, R"re(\\ref \w+ "([^"]*)")re", "$1");
  return replaced(replaced(readable, R"(\\ref (\w+))", "$1"), "\n{3,}", "\n\n") + "\n";
}

}  // namespace workbook
