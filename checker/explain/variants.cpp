#include "checker/explain/variants.hpp"

#include "checker/explain/values/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace workbook {

namespace {

constexpr std::size_t last_token_looked_at = 4000;
constexpr std::size_t most_variants = 20000, most_tried = 1900;

bool is_identifier(std::string_view text) {
  return !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_');
}

bool is_numeral(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0;
}

const std::initializer_list<std::string_view> whole_types = {"int", "Index", "size_t", "long", "unsigned", "bool"};

/// The conditions of a file, and the heads of its loops.
class Conditions {
 public:
  explicit Conditions(const SourceText& source)
      : source_(source),
        tokens_(source.tokens()),
        size_(std::min(tokens_.size(), last_token_looked_at)),
        decides_(size_, false),
        in_loop_(size_, false),
        in_template_(size_, false) {
    for (std::size_t k = 0; k < size_; ++k) {
      if (text(k) == "<" && k > 0) mark(in_template_, k, end_of_template(k));
      if (is_one_of(text(k), {"for", "while"}) && text(k + 1) == "(") mark(in_loop_, k + 1, source_.partner_of(k + 1));
    }
    for (std::size_t k = 0; k < size_; ++k) {
      // Between the parentheses of a lambda stand declarations.
      if (text(k) == "]" && text(k + 1) == "(") mark(decides_, k + 1, source_.partner_of(k + 1));
      const bool is_if = text(k) == "if" && text(k + 1) == "(";
      if (is_if) mark(decides_, k + 1, source_.partner_of(k + 1));
      // With the token before it: a sign after that one would be the condition's.
      if (text(k) == "?") mark(decides_, std::max(begin_of_operand(k), std::size_t{1}) - 1, k);
      if (text(k) == "bool") mark(decides_, k, end_of_operand(k));
      const bool compares = is_one_of(text(k), {"==", "!=", "<=", ">=", "&&", "||"}) ||
                            (is_one_of(text(k), {"<", ">"}) && !is_of_template(k) &&
                             (is_numeral(text(k + 1)) || is_numeral(text(k - 1))));
      if (compares && !in_loop_[k])
        mark(decides_, std::max(begin_of_operand(k), std::size_t{1}) - 1, end_of_operand(k));
    }
  }

  /// The < or > around whole numbers or a type, as in head<2>(), block<2, 1>(0, 2) and cast<double>().
  bool is_of_template(std::size_t index) const {
    const auto skips = [&](std::size_t k) {
      return is_one_of(text(k), {",", "double", "float", "int"}) || is_numeral(text(k));
    };
    std::size_t k = index;
    if (text(index) == "<") {
      while (skips(++k)) {
      }
      return text(k) == ">" && k > index + 1;
    }
    while (k > 0 && skips(--k)) {
    }
    return text(k) == "<" && k + 1 < index;
  }

  /// One past the > of `Matrix<double, 9, 12>` and the like; the place itself where no such list begins.
  std::size_t end_of_template(std::size_t index) const {
    static const std::initializer_list<std::string_view> templates = {
        "Matrix",   "Array",          "Map",       "Ref",         "array",
        "vector",   "pair",           "tuple",     "span",        "complex",
        "function", "numeric_limits", "optional",  "Quaternion",  "block",
        "segment",  "static_cast",    "JacobiSVD", "EigenSolver", "SelfAdjointEigenSolver"};
    if (!is_one_of(text(index - 1), templates)) return index;
    int depth = 0;
    for (std::size_t k = index; k < size_ && !is_one_of(text(k), {";", "{", "}"}); ++k) {
      if (text(k) == "<") ++depth;
      if (text(k).starts_with(">")) depth -= static_cast<int>(text(k).size());
      if (depth <= 0) return k + 1;
    }
    return index;
  }

  bool in_template(std::size_t index) const { return index < size_ && in_template_[index]; }
  bool decides(std::size_t index) const { return index < size_ && decides_[index]; }
  bool in_loop(std::size_t index) const { return index < size_ && in_loop_[index]; }

  std::size_t begin_of_operand(std::size_t index) const {
    int depth = 0;
    for (std::size_t k = index; k-- > 0;) {
      if (closes(text(k))) ++depth;
      if (opens(text(k)) && --depth < 0) return k + 1;
      if (depth == 0 && is_one_of(text(k), {";", ",", "=", "return", "?", ":", "+=", "-=", "*="})) return k + 1;
    }
    return 0;
  }

  /// One past the last token.
  std::size_t end_of_operand(std::size_t index) const {
    int depth = 0;
    for (std::size_t k = index + 1; k < size_; ++k) {
      if (opens(text(k))) ++depth;
      if (closes(text(k)) && --depth < 0) return k;
      if (depth == 0 && is_one_of(text(k), {";", ",", "?", ":"})) return k;
    }
    return size_;
  }

 private:
  std::string_view text(std::size_t index) const {
    return index < tokens_.size() ? tokens_[index].text : std::string_view();
  }
  void mark(std::vector<bool>& marks, std::size_t first, std::size_t last) const {
    for (std::size_t k = first; k < std::min(last, size_); ++k) marks[k] = true;
  }

  const SourceText& source_;
  const std::vector<Token>& tokens_;
  const std::size_t size_;
  std::vector<bool> decides_, in_loop_, in_template_;
};

/// Makes the variants of one file.
class SourceMutations {
 public:
  /// @param all_bugs  also what is hardly a slip
  SourceMutations(const SourceText& source, const ExerciseReference& exercise, bool all_bugs)
      : source_(source), conditions_(source), all_bugs_(all_bugs), most_(all_bugs ? std::string::npos : most_variants) {
    constexpr const char* types[] = {"double",   "int",      "Vector2d",  "Vector3d",  // in the order of Kind
                                     "VectorXd", "Matrix3d", "Matrix3Xd", "vector"};
    for (const Argument& argument : exercise.arguments) {
      types_[argument.name] = types[static_cast<int>(argument.kind)];
      units_[argument.name] = argument.unit;
      constants_.insert(argument.name);
    }
    find_functions(exercise.name);
    find_changed_arguments();
    find_locals();
    find_operands();
    for (const Argument& argument : exercise.arguments) {
      if (argument.kind != Kind::number && argument.kind != Kind::vector3) continue;
      const bool is_angle = argument.unit == units::radian;
      for (int n = 0; n < (argument.kind == Kind::number ? 1 : 3); ++n)
        if (is_angle) angles_.push_back({argument.name, argument.name + entry_suffix(argument.kind, n)});
    }
  }

  std::vector<Variant> all() {
    const std::vector<Token>& tokens = source_.tokens();
    find_body();
    for (at_ = first_; at_ < std::min(last_, last_token_looked_at) && found_.size() < most_; ++at_) {
      if (here() == "using" || here() == "typedef") at_ = end_of_statement(at_);
      if (at_ >= last_ || tokens[at_].in_directive || conditions_.in_template(at_)) continue;
      if (conditions_.decides(at_) && !all_bugs_) {
        numbers(VariantKind::guard);
        continue;
      }
      signs();
      numbers(VariantKind::number);
      names();
      functions();
      divisions();
      changes();
      changes_of_all();
      factors();
      terms();
      matrices();
      assignments();
      loops();
      turns();
      brackets();
      brackets_before_method();
      brackets_around_choice();
      order_of_matrices();
      overwritten();
      if (all_bugs_) bugs();
    }
    everywhere();
    if (found_.size() > most_tried && !all_bugs_) thin_out();
    return std::move(found_);
  }

 private:
  std::string_view token(std::size_t index) const {
    return index < source_.tokens().size() ? source_.tokens()[index].text : std::string_view();
  }
  std::string_view here() const { return token(at_); }
  std::string_view before() const { return token(at_ - 1); }
  std::string_view after() const { return token(at_ + 1); }

  using Scope = std::pair<std::size_t, std::size_t>;
  struct Lambda {
    std::size_t begin, end_of_captures, end;
  };
  /// `omega[j]`, `a.mass`, `v.norm()`: what may be a number, and the variables in it.
  struct Operand {
    std::string text;
    std::vector<std::string> names;
  };

  /// Leaves out some, all over the file, of those of which there are most and that are right least often.
  void thin_out() {
    const auto rank_of = [](const Variant& each) {
      return each.kind == VariantKind::term                                   ? 3
             : is_one_of(each.words, {"one factor more", "one divisor more"}) ? 2
                                                                              : each.kind == VariantKind::name;
    };
    std::ranges::stable_sort(found_, {}, rank_of);
    for (const int rank : {3, 2, 1}) {
      const auto all = static_cast<std::size_t>(std::ranges::count(found_, rank, rank_of));
      const std::size_t surplus = found_.size() - std::min(found_.size(), most_tried),
                        kept = all - std::min(all, surplus);
      std::size_t seen = 0;
      std::erase_if(found_, [&](const Variant& each) {
        if (rank_of(each) != rank) return false;
        ++seen;
        return seen * kept / all == (seen - 1) * kept / all;
      });
    }
    found_.resize(std::min(found_.size(), most_tried));
  }

  /// Only what stands between the first { of a function and the end is changed, not its head.
  void find_body() {
    const std::vector<Token>& tokens = source_.tokens();
    last_ = tokens.size();
    for (first_ = 0; first_ < tokens.size(); ++first_) {
      if (tokens[first_].text == ")" && token(first_ + 1) == "{") break;
    }
  }

  /// `Vector3d& w` of `void step(Vector3d& w, double h)` and `auto step = [&](Vector3d& w, double h)`
  void find_changed_arguments() {
    for (std::size_t k = 2; k < std::min(source_.tokens().size(), last_token_looked_at); ++k) {
      if (token(k) != "&" || !is_identifier(token(k + 1)) || !is_one_of(token(k + 2), {",", ")"})) continue;
      const std::size_t open = source_.opening_around(k);
      std::size_t type = k;
      while (type > open && !is_one_of(token(type), {",", "const"})) --type;
      if (token(open) != "(" || open < 3 || token(type) == "const") continue;
      const std::size_t captures = token(open - 1) == "]" ? source_.partner_of(open - 1) : 0;
      changed_arguments_[std::string(token(captures > 2 ? captures - 2 : open - 1))].insert(place_in_list(k));
    }
  }

  /// The body of the exercise's function, and the lambdas that see only some names of what is around them.
  void find_functions(const std::string& name) {
    for (std::size_t k = 1; k < std::min(source_.tokens().size(), last_token_looked_at); ++k) {
      if (token(k) == name && token(k + 1) == "(") {
        const std::size_t close = source_.partner_of(k + 1);
        if (token(close + 1) == "{") body_ = {close + 1, source_.partner_of(close + 1)};
      }
      if (token(k) != "[") continue;
      const std::size_t close = source_.partner_of(k);
      const bool takes_all = is_one_of(token(k + 1), {"=", "&"}) && is_one_of(token(k + 2), {"]", ","});
      if (token(close + 1) != "(" || takes_all) continue;
      std::size_t open = source_.partner_of(close + 1);
      while (open < last_token_looked_at && !is_one_of(token(open), {"{", ";", ""})) ++open;
      if (token(open) == "{") closed_.push_back({k, close, source_.partner_of(open)});
    }
  }

  /// Can the name be used here?
  bool is_visible(const std::string& name) const {
    const auto found = scopes_.find(name);
    return found == scopes_.end()
               ? is_visible(name, body_)
               : std::ranges::any_of(found->second, [&](const Scope& scope) { return is_visible(name, scope); });
  }
  bool is_visible(const std::string& name, const Scope& scope) const {
    return at_ > scope.first && at_ <= scope.second && std::ranges::none_of(closed_, [&](const Lambda& lambda) {
             if (at_ <= lambda.begin || at_ > lambda.end || scope.first >= lambda.begin) return false;
             for (std::size_t k = lambda.begin; k < lambda.end_of_captures; ++k)
               if (token(k) == name) return false;
             return true;
           });
  }
  bool is_declared_at(std::size_t index) const {
    const auto found = scopes_.find(std::string(token(index)));
    return found != scopes_.end() && std::ranges::find(found->second, index, &Scope::first) != found->second.end();
  }

  /// "double a = 1, b = 2;" and "int i = 0" in a loop: names of one type may have been mixed up.
  void find_locals() {
    std::string type;  // of the declaration that we are in
    bool is_constant = false;
    int depth = 0;  // of brackets in it
    for (std::size_t k = 1; k < std::min(source_.tokens().size(), last_token_looked_at); ++k) {
      const std::string_view left = token(k - 1), here = token(k), right = token(k + 1);
      const bool is_named = is_one_of(right, {"=", ";", ",", "(", ")", "{", ":"});
      const bool next_parameter = here == "," && is_identifier(right) && is_identifier(token(k + 2));
      const bool begins_lambda = left == "]" && here == "(";
      if (here == ";" || next_parameter || begins_lambda || depth < 0) type.clear();
      if (opens(here)) ++depth;
      if (closes(here)) --depth;
      if (!is_identifier(here) || !is_named || here == "operator") continue;
      if (right == "(" && token(source_.partner_of(k + 1) + 1) == "{") continue;  // a function
      const std::string_view word = left == "&" && k > 1 ? token(k - 2) : left;
      const bool is_type =
          is_identifier(word) && !is_one_of(word, {"return", "else", "new", "throw", "case", "goto", "namespace"});
      if (is_type && type.empty()) {
        type = word == "auto" ? fmt::format("auto {}", here) : std::string(word);  // nobody else's
        depth = 0;
        std::size_t word_at = left == "&" ? k - 2 : k - 1;
        while (word_at > 1 && token(word_at - 1) == "::") word_at -= 2;
        is_constant = word_at > 0 && token(word_at - 1) == "const";
      } else if (left != "," || depth != 0 || type.empty() || right == ";" || right == ",") {
        continue;
      }
      const auto [known, is_new] = types_.emplace(here, type);
      if (!is_new && known->second != type) known->second = fmt::format("auto {}", here);  // one of several functions
      const std::size_t from = right == "=" ? conditions_.end_of_operand(k + 1) : k;  // not in its own initial value
      scopes_[std::string(here)].emplace_back(from, end_of_block(k));
      if (is_constant) constants_.insert(std::string(here));
    }
  }

  void find_operands() {
    constexpr std::size_t most = 12, longest = 24;
    for (std::size_t k = 1; k < std::min(source_.tokens().size(), last_token_looked_at); ++k) {
      const bool is_declared = (is_identifier(token(k - 1)) && token(k - 1) != "return") || is_declared_at(k);
      if (!types_.contains(std::string(token(k))) || is_one_of(token(k - 1), {".", "::", "->"}) || is_declared)
        continue;
      const std::size_t last = end_of_factor(k);
      const auto type = types_.find(std::string(token(k)));
      const bool is_of_eigen = type->second.starts_with("Vector") || type->second.starts_with("Matrix");
      if (last == k || is_one_of(type->second, {"double", "int"}) || (is_of_eigen && !is_scalar(k, last))) continue;
      Operand operand{text_of(k, last), {}};
      for (std::size_t n = k; n <= last; ++n)
        if (types_.contains(std::string(token(n))) && !is_one_of(token(n - 1), {".", "->", "::"}))
          operand.names.emplace_back(token(n));
      const auto is_known = std::ranges::find(operands_, operand.text, &Operand::text) != operands_.end();
      if (!is_known && operand.text.size() <= longest && operands_.size() < most) operands_.push_back(operand);
    }
  }

  /// What can stand for a number here: names, and entries and the like that the file has elsewhere.
  std::vector<std::string> numbers_here() const {
    std::vector<std::string> texts;
    for (const auto& [name, type] : types_)
      if (type == "double" && is_visible(name)) texts.push_back(name);
    for (const Operand& each : operands_)
      if (std::ranges::all_of(each.names, [&](const std::string& name) { return is_visible(name); }))
        texts.push_back(each.text);
    return texts;
  }

  /// The token that closes the block around the one at the index; of what is declared in a head, that behind it.
  std::size_t end_of_block(std::size_t index) const {
    int depth = 0;
    for (std::size_t k = index; k < source_.tokens().size(); ++k) {
      if (opens(token(k))) ++depth;
      if (closes(token(k)) && --depth < 0 && token(k) == "}") return k;
      if (depth != -1 || token(k) != ")") continue;
      std::size_t begin = k + 1;  // of the block, or the end of the only statement
      while (begin < source_.tokens().size() && token(begin) != "{" && token(begin) != ";")
        begin = opens(token(begin)) ? source_.partner_of(begin) + 1 : begin + 1;
      return token(begin) == "{" ? source_.partner_of(begin) : begin;
    }
    return source_.tokens().size();
  }

  /// An edit that puts something in place of the tokens from the one index to the other.
  Edit replaced(std::size_t first, std::size_t last, std::string_view replacement) const {
    const Token& begin = source_.tokens()[first];
    const Token& end = source_.tokens()[last];
    return {begin.offset, end.offset + end.text.size() - begin.offset, std::string(replacement)};
  }

  void add(VariantKind kind, std::string words, std::size_t place, std::vector<Edit> edits) {
    found_.push_back({kind, std::move(words), source_.place_of(source_.tokens()[place].offset), std::move(edits)});
  }
  void add(VariantKind kind, const char* words, std::string_view replacement) {
    add(kind, words, at_, {replaced(at_, at_, replacement)});
  }
  void exchange(VariantKind kind, const char* words, std::size_t one, std::size_t other) {
    add(kind, words, one, {replaced(one, one, token(other)), replaced(other, other, token(one))});
  }
  void insert_after(VariantKind kind, const char* words, const std::string& text) {
    const Token& token = source_.tokens()[at_];
    add(kind, words, at_ + 1, {{token.offset + token.text.size(), 0, " " + text}});
  }

  bool follows_operand() const {
    return is_identifier(before()) ? before() != "return" : is_numeral(before()) || before() == ")" || before() == "]";
  }

  void signs() {
    if (here() == "+") add(VariantKind::sign, "another sign", "-");
    if (here() == "-") add(VariantKind::sign, "another sign", follows_operand() ? "+" : " ");
    if (here() == "+=") add(VariantKind::sign, "another sign", "-=");
    if (here() == "-=") add(VariantKind::sign, "another sign", "+=");
    const bool is_bracket = after() == "(";  // all that is in it
    if (begins_expression() && begins_operand(at_ + 1) && !(is_bracket && all_bugs_) && !is_index(at_ + 1) &&
        !is_zero(at_ + 1) && !is_even() && !is_bound())
      insert_after(VariantKind::sign, "another sign", "-");
  }

  bool begins_operand(std::size_t index) const {
    return is_identifier(token(index)) || is_numeral(token(index)) || token(index) == "(";
  }

  /// An argument of swap(a, b), std::tie(a, b), or of a function of the file that takes it by a reference to change it.
  bool is_changed_by_call(std::size_t index) const {
    const std::size_t open = source_.opening_around(index);
    if (token(open) != "(" || open == 0) return false;
    const auto changing = changed_arguments_.find(token(open - 1));
    return is_one_of(token(open - 1), {"swap", "tie"}) ||
           (changing != changed_arguments_.end() && changing->second.contains(place_in_list(index)));
  }
  /// 0 for the first between its brackets.
  std::ptrdiff_t place_in_list(std::size_t index) const {
    std::ptrdiff_t commas = 0;
    for (std::size_t k = source_.opening_around(index) + 1; k < index;
         k = opens(token(k)) ? source_.partner_of(k) + 1 : k + 1)
      commas += token(k) == "," ? 1 : 0;
    return commas;
  }
  /// The comma of `Matrix3d A, B;`
  bool is_between_names() const {
    if (token(source_.opening_around(at_)) != "{") return false;
    std::size_t first = at_;
    while (first > first_ && !is_one_of(token(first - 1), {";", "{", "}"})) --first;
    if (token(first) == "const") ++first;
    while (token(first + 1) == "::") first += 2;
    return is_identifier(token(first)) && is_identifier(token(first + 1)) && token(first) != "return";
  }
  /// Is what follows a value, and no declaration and no statement?
  bool begins_expression() const {
    std::size_t type = at_ + 1;
    while (token(type + 1) == "::") type += 2;
    const std::size_t behind_type = token(type + 1) == "<" ? conditions_.end_of_template(type + 1) : type + 1;
    const bool declares = is_identifier(after()) && (is_identifier(token(behind_type)) || token(behind_type) == "&") &&
                          after() != "return";
    const bool is_type =
        is_one_of(after(), whole_types) || is_one_of(after(), {"const", "auto", "double", "float", "void"});
    if (declares || is_declared_at(at_ + 1) || is_type || is_changed_by_call(at_ + 1)) return false;
    if (token(source_.opening_around(at_)) == "[") return false;  // `const auto& [one, other]`
    if (here() == "{") return is_one_of(before(), {"return", "=", "(", ",", "{"});
    if (here() == "(") return !is_one_of(before(), {"for", "if", "while", "switch", "catch", "]"});
    if (here() == ",") return token(at_ + 2) != "=" && !is_between_names();
    if (here() == "=" && token(end_of_target(at_ + 1)) == "=") return false;  // `A(0, 0) = A(1, 1) = c`
    return is_one_of(here(), {"return", "=", "<<"});
  }

  /// Do we open an even function of one variable, as in `cos(psi)` or `abs(angles[1])`?
  bool is_even() const {
    const bool ends = token(at_ + 2) == ")" || (token(at_ + 2) == "[" && token(at_ + 5) == ")");
    return here() == "(" && ends && is_one_of(before(), {"cos", "cosh", "abs"});
  }

  /// The `1` of `min(1.0, s)`, whose other sign would make all of s the bound.
  bool is_bound() const {
    if (!is_numeral(after())) return false;
    const std::size_t open = here() == "," ? source_.opening_around(at_) : at_;
    return open > 0 && token(open) == "(" && is_one_of(token(open - 1), {"min", "max", "clamp"});
  }

  /// Is the number an index, as in `I(0, 2)`, `r[1]` or `row(2)`?
  bool is_index(std::size_t index) const {
    if (!is_numeral(token(index)) || token(index).size() != 1) return false;
    const std::string_view left = token(index - 1), right = token(index + 1);
    if (!is_one_of(left, {"(", "[", ","}) || !is_one_of(right, {")", "]", ","})) return false;
    std::size_t open = index - 1;
    if (left == ",") open = index >= 3 ? index - 3 : 0;
    return token(open) == "[" || (token(open) == "(" && open > 0 && is_identifier(token(open - 1)));
  }

  /// `0`, `0.0` or `Matrix3d::Zero()`, which no sign and no factor changes.
  bool is_zero(std::size_t index) const {
    return token(index) == "0" || token(index) == "0.0" || (token(index + 1) == "::" && token(index + 2) == "Zero");
  }

  void numbers(VariantKind kind) {
    if (!is_numeral(here())) return;
    const bool is_guard = kind == VariantKind::guard;
    if (is_index(at_)) {
      if (is_guard) return;
      for (const char* other : {"0", "1", "2"})
        if (here() != other) add(VariantKind::index, "another index", other);
      for (const auto& [name, type] : types_)  // `m[0]` in a loop over k
        if (is_one_of(type, whole_types) && is_visible(name) && !all_bugs_)
          add(VariantKind::index, "another index", name);
      if (token(at_ + 1) == "," && is_index(at_ + 2) && here() != token(at_ + 2))
        exchange(VariantKind::index, "the two indices the other way round", at_, at_ + 2);
      // `I[1] * I[1]`
      if (before() == "[" && after() == "]" && token(at_ + 2) == "*" && token(at_ + 3) == token(at_ - 2) &&
          token(at_ + 4) == "[" && token(at_ + 5) == here())
        for (const char* other : {"0", "1", "2"})
          if (here() != other)
            add(VariantKind::index, "another index in both factors", at_,
                {replaced(at_, at_, other), replaced(at_ + 5, at_ + 5, other)});
      return;
    }
    double value = 0;
    const auto [end, problem] = std::from_chars(here().data(), here().data() + here().size(), value);
    if (problem != std::errc() || end != here().data() + here().size() || (before() == "<" && after() == ">")) return;
    const bool is_whole = here().find_first_of(".e") == std::string_view::npos;
    if (!is_guard && after() == "/" && is_numeral(token(at_ + 2)) && here() != token(at_ + 2))
      exchange(VariantKind::number, "this fraction the other way up", at_, at_ + 2);
    if (const std::size_t next = next_in_list(); next > 0 && !is_guard && !all_bugs_)
      exchange(VariantKind::number, "this number and the next one exchanged", at_, next);
    std::vector<double> others;
    if (value != 0)
      for (const double factor : {2.0, 0.5, 4.0, 0.25, 3.0, 1.0 / 3, 1.5, 2.0 / 3, -1.0, 10.0, 100.0, 0.1, 0.01, 1e-6})
        others.push_back(value * factor);
    if (is_whole) others.insert(others.end(), {value + 1, value - 1});
    for (const double other : others) {
      if (is_guard && other == -value) continue;
      if (is_whole && (other != std::trunc(other) || (other < 0 && conditions_.in_loop(at_)) || std::abs(other) > 1e9))
        continue;
      const char* words = is_guard                                                 ? "another bound in this condition"
                          : std::abs(other) >= 10 * std::abs(value) && value != 0  ? "a larger number"
                          : std::abs(other) <= 0.1 * std::abs(value) && value != 0 ? "a smaller number"
                                                                                   : "another number";
      add(kind, words, is_whole ? fmt::format("{:.0f}", other) : fmt::format("{:.17g}", other));
      if (!is_guard && other == 10 * value)
        places_[{std::string(here()), found_.back().edits.front().replacement}].push_back(found_.back().edits.front());
    }
  }

  /// The next number of that kind in a list, as in `{{0, 0.5}, {1, 0.5}}`, if it is another one; 0 if there is none.
  std::size_t next_in_list() const {
    const auto is_in_list = [&](std::size_t index) {
      const std::size_t open = source_.opening_around(index);
      return token(open) == "{" && open > 0 && !is_one_of(token(open - 1), {")", "]", ";", "}", "else", "do"});
    };
    if (!is_in_list(at_)) return 0;
    for (std::size_t k = at_ + 1; k < last_ && token(k) != ";"; ++k)
      if (is_numeral(token(k)) && is_whole(k) == is_whole(at_) && is_in_list(k)) return token(k) == here() ? 0 : k;
    return 0;
  }

  void names() {
    const auto type = types_.find(std::string(here()));
    // `A(k, i)` of two whole numbers
    if (type != types_.end() && is_whole(at_) && before() == "(" && after() == "," && token(at_ + 3) == ")" &&
        is_identifier(token(at_ + 2)) && is_whole(at_ + 2) && types_.contains(std::string(token(at_ - 2))))
      exchange(VariantKind::index, "the two indices the other way round", at_, at_ + 2);
    const bool is_square = after() == "*" && token(at_ + 2) == here() && before() != ".";
    if (type == types_.end() || is_one_of(before(), {".", "::", "->", "&"}) || before() == type->second) return;
    if (is_declared_at(at_)) return;
    if (is_changed_by_call(at_)) return;
    if (is_one_of(after(), {"=", "+=", "-=", "*=", "/=", "{", "++", "--"}) || is_one_of(before(), {"++", "--"})) return;
    const bool is_filled = is_target();
    for (const auto& [other, declared] : types_)
      if (other != here() && declared == type->second) {
        if (!is_visible(other) || (is_filled && constants_.contains(other)) || is_beside_other_unit(other)) continue;
        if (is_square)
          add(VariantKind::name, "another name in both factors", at_,
              {replaced(at_, at_, other), replaced(at_ + 2, at_ + 2, other)});
        add(VariantKind::name, "another name", other);
        places_[{std::string(here()), other}].push_back(found_.back().edits.front());
      }
    // A value in place of a variable that is filled here would leave that one empty.
    if (!all_bugs_ && !is_filled) derived(type->second);
    if (!all_bugs_ && !is_filled && type->second == "double") entries();
  }

  /// `m[k]` in a loop over k, in place of the sum of m.
  void entries() {
    for (const auto& [list, list_type] : types_)
      for (const auto& [index, index_type] : types_) {
        if (list_type != "VectorXd" || !is_one_of(index_type, whole_types) || !scopes_.contains(index) ||
            !is_visible(list) || !is_visible(index))
          continue;
        const std::string entry = fmt::format("{}[{}]", list, index);
        add(VariantKind::name, "an entry of a list", entry);
        places_[{std::string(here()), entry}].push_back(found_.back().edits.front());
      }
  }

  /// Would the argument be added to one of another unit, as `impulse` in `(r - impulse)`?
  bool is_beside_other_unit(const std::string& argument) const {
    const auto has_other_unit = [&](std::string_view partner) {
      const auto one = units_.find(partner), other = units_.find(argument);
      return one != units_.end() && other != units_.end() && !(one->second == other->second);
    };
    return (is_one_of(before(), {"+", "-"}) && is_one_of(token(at_ - 3), {"(", "=", "return", ","}) &&
            has_other_unit(token(at_ - 2))) ||
           (is_one_of(after(), {"+", "-"}) && is_one_of(token(at_ + 3), {")", ";", ","}) &&
            has_other_unit(token(at_ + 2)));
  }

  /// Is the variable here filled, as in `J(i, j) += x`, `(x < 0 ? low : high) = x` or `sort(s.data(), s.data() + 3)`?
  bool is_target() const {
    const auto assigns = [&](std::size_t index) {
      return is_one_of(token(index), {"=", "+=", "-=", "*=", "/=", "<<"});
    };
    const std::size_t open = source_.opening_around(at_);
    const bool is_chosen =
        token(open) == "(" && open > 0 && !is_identifier(token(open - 1)) && assigns(source_.partner_of(open) + 1);
    return assigns(end_of_target(at_)) || is_chosen ||
           (after() == "." && is_one_of(token(at_ + 2), {"data", "begin", "end"}));
  }

  /// Behind `x`, `x[0]`, `M.col(k)` or `v.head<2>()`, which may be assigned to.
  std::size_t end_of_target(std::size_t first) const {
    std::size_t end = first + 1;
    while (true) {
      if (is_one_of(token(end), {"[", "("}))
        end = source_.partner_of(end) + 1;
      else if (is_one_of(token(end), {".", "::"}) || is_identifier(token(end)))
        ++end;
      else if (token(end) == "<" && conditions_.is_of_template(end))
        while (token(end++) != ">") continue;
      else
        return end;
    }
  }

  /// What is easily left out of a name: the mass of the rest in that of the whole, a matrix before a vector.
  void derived(const std::string& type) {
    const std::string name(here());
    const auto put = [&](const std::string& words, const std::string& value) {
      add(VariantKind::name, "", value);
      found_.back().words = fmt::format(fmt::runtime(words), "`" + name + "`");
    };
    for (const auto& [other, other_type] : types_) {
      if (type != "double" || other_type != type || other == name || before() != "/" || !is_visible(other)) continue;
      put("a sum in place of {}", "(" + name + " + " + other + ")");
      put("a difference in place of {}", "(" + name + " - " + other + ")");
    }
    if (type != "Vector3d" || after() == "(") return;
    for (const auto& [matrix, other_type] : types_) {
      if (!is_visible(matrix)) continue;
      if (other_type == "Matrix3d") {
        for (const char* turned : {" * ", ".transpose() * "}) {
          const std::string product = "Vector3d(" + matrix + turned + name + ")";
          if (after() != "[") put("a matrix before {}", product);
          places_[{name, product}].push_back(replaced(at_, at_, product));
        }
      } else if (other_type == "Vector3d" && matrix == "I" && name != "I" && after() != "[") {
        put("the moments times {}", "Vector3d(" + matrix + ".cwiseProduct(" + name + "))");
      }
    }
  }

  /// One name, or a larger number, in place of another wherever that stands.
  void everywhere() {
    for (const auto& [texts, edits] : places_) {
      if (edits.size() < 2 || all_bugs_) continue;
      const bool is_number = is_numeral(texts.first), is_left_out = texts.second.empty();
      const char* words = is_number                     ? "a larger number wherever `{}` stands"
                          : is_left_out                 ? "`{}` left out wherever it stands"
                          : texts.second.ends_with(']') ? "an entry of a list in this loop wherever `{}` stands"
                          : texts.second.ends_with(')') ? "a matrix before `{}` wherever it stands"
                                                        : "another name wherever `{}` stands";
      found_.push_back({is_number     ? VariantKind::number
                        : is_left_out ? VariantKind::function
                                      : VariantKind::name,
                        fmt::format(fmt::runtime(words), texts.first), source_.place_of(edits.front().offset), edits});
    }
  }

  void functions() {
    using Others = std::map<std::string_view, std::vector<const char*>>;
    static const Others functions = {
        {"sin", {"cos", "std::tan"}}, {"cos", {"sin"}},   {"tan", {"sin", "std::atan", "std::cos"}},
        {"asin", {"acos", "atan"}},   {"acos", {"asin"}}, {"atan", {"tan"}},
        {"sqrt", {"std::abs"}},       {"cosh", {"sinh"}}, {"sinh", {"cosh"}},
        {"tanh", {"std::tan"}},       {"min", {"max"}},   {"max", {"min"}}};
    static const Others methods = {{"norm", {".squaredNorm"}},
                                   {"squaredNorm", {".norm"}},
                                   {"x", {".y", ".z"}},
                                   {"y", {".x", ".z"}},
                                   {"z", {".x", ".y"}},
                                   {"transpose", {"", ".inverse"}},
                                   {"inverse", {"", ".transpose"}},
                                   {"cwiseInverse", {".inverse"}},
                                   {"normalized", {""}},
                                   {"maxCoeff", {".minCoeff"}},
                                   {"minCoeff", {".maxCoeff"}}};
    const bool is_called = after() == "(";
    if (before() == "." && is_called) {
      const auto found = methods.find(here());
      const std::size_t last = token(at_ + 2) == ")" ? at_ + 2 : at_ + 1;
      const std::string_view behind = token(source_.partner_of(at_ + 1) + 1);
      if (found == methods.end() || at_ < 2 || is_one_of(behind, {"=", "+=", "-=", "*=", "/="})) return;
      if (here() == "transpose" && shape_of(operand_of(at_ - 1), at_ - 2) == 'v') return;
      for (const std::string_view other : found->second) {
        Edit edit =
            replaced(at_ - 1, last, other.empty() ? "" : fmt::format("{}{}", other, last == at_ + 2 ? "()" : "("));
        edit.operand = source_.tokens()[operand_of(at_ - 1)].offset;
        add(VariantKind::method, other.empty() ? "one call left out" : "another function", at_, {edit});
      }
      return;
    }
    if (const auto found = functions.find(here()); found != functions.end() && is_called)
      for (const char* other : found->second) add(VariantKind::function, "another function", other);
    if (is_called && !all_bugs_ && is_one_of(here(), {"sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"}))
      for (const char* factor : {"2", "0.5"}) {
        const std::string of_more = fmt::format("[](const auto& v) {{ return std::{}({} * v); }}", here(), factor);
        add(VariantKind::function, "another factor in the argument", of_more);
      }
    if (is_called && !all_bugs_ && here() == "atan2")
      add(VariantKind::function, "the two arguments exchanged",
          "[](const auto& one, const auto& other) { return std::atan2(other, one); }");
    if ((here() == "abs" || here() == "fabs") && is_called) {
      drop("the absolute value left out");
      places_[{"abs", ""}].push_back(found_.back().edits.front());
    }
    if (here() == "sqrt" && is_called) drop("the root left out");
  }

  /// The first token of what the dot at the index belongs to: `I` of `I.col(0).norm()`.
  std::size_t operand_of(std::size_t dot) const {
    std::size_t first = dot;
    while (first > 0) {
      --first;
      while (first > 0 && closes(token(first))) {
        first = source_.partner_of(first);
        if (first > 0 && token(first - 1) == ">" && conditions_.is_of_template(first - 1))
          while (token(--first) != "<") {
          }
        const std::string_view left = token(first - 1);
        if (first > 0 && (closes(left) || (is_identifier(left) && left != "return"))) --first;
      }
      if (first == 0 || !is_one_of(token(first - 1), {".", "->", "::"})) return first;
      --first;
    }
    return first;
  }

  /// The beginning and the end of a loop.
  void loops() {
    if (!conditions_.in_loop(at_) || !is_one_of(here(), {"=", "<", "<=", ">", ">=", "!="}) || all_bugs_) return;
    if (is_one_of(after(), whole_types) || is_one_of(after(), {"double", "std"})) return;  // `vector<double>`
    if (!is_identifier(after()) && !(is_numeral(after()) && is_whole(at_ + 1))) return;
    const std::size_t behind = source_.tokens()[at_].offset + here().size();
    if (here() == "=") {
      if (token(at_ + 2) != ";" || !is_numeral(after())) return;
      add(VariantKind::loop, "a later first step", at_, {{behind, 0, "1"}});
      if (after() != "0") add(VariantKind::loop, "an earlier first step", at_, {{behind, 0, "-1"}});
      return;
    }
    add(VariantKind::loop, "one step more", at_, {{behind, 0, "1"}});
    add(VariantKind::loop, "one step less", at_, {{behind, 0, "-1"}});
    add(VariantKind::steps, "more steps", at_, {{behind, 0, "10.0 *"}});
  }

  /// `++k` in the head of a loop as `k += 3`.
  void turns() {
    const bool is_before = here() == ";" && after() == "++" && token(at_ + 3) == ")";
    const bool is_behind = here() == ";" && token(at_ + 2) == "++" && token(at_ + 3) == ")";
    if (all_bugs_ || !(is_before || is_behind)) return;
    const std::string name(token(is_before ? at_ + 2 : at_ + 1));
    for (const char* step : {" += 2", " += 3"})
      add(VariantKind::brackets, "a larger step from turn to turn", at_ + 1, {replaced(at_ + 1, at_ + 2, name + step)});
  }

  /// A whole number by what it is written as or declared to be.
  bool is_whole(std::size_t index) const {
    const std::string_view text = token(index);
    const auto type = types_.find(std::string(text));
    return is_numeral(text) ? text.find_first_of(".eE") == std::string_view::npos
                            : type != types_.end() && is_one_of(type->second, whole_types);
  }

  /// `n`, `2`, `(n - 1)` and `r.cols()` before the token here.
  bool follows_whole() const {
    if (before() != ")") return is_whole(at_ - 1);
    const std::size_t open = source_.partner_of(at_ - 1);
    if (open > 0 && is_identifier(token(open - 1))) return is_one_of(token(open - 1), {"size", "cols", "rows"});
    for (std::size_t k = open + 1; k + 1 < at_; ++k)
      if (!is_whole(k) && !is_one_of(token(k), {"+", "-", "*", "(", ")"})) return false;
    return true;
  }

  /// Is it a number, as far as the names in it tell?
  bool is_scalar(std::size_t first, std::size_t last) const {
    const std::initializer_list<std::string_view> numbers = {"norm", "squaredNorm", "dot",  "x",    "y",
                                                             "z",    "sum",         "prod", "trace"};
    for (std::size_t k = first; k <= last; ++k) {
      const auto type = types_.find(std::string(token(k)));
      const bool is_entry =
          is_one_of(token(k + 1), {"[", "("}) || (token(k + 1) == "." && is_one_of(token(k + 2), numbers));
      if (token(k).starts_with("Vector") || token(k).starts_with("Matrix")) return false;
      if (type == types_.end() || type->second == "double" || is_one_of(type->second, whole_types)) continue;
      if (!is_entry) return false;
      k = end_of_factor(k);
    }
    return true;
  }

  /// v for a vector, m for a matrix, as far as a name alone tells; otherwise nothing.
  char shape_of(std::size_t first, std::size_t last) const {
    const auto type = types_.find(std::string(token(first)));
    const std::string_view text = type == types_.end() ? token(first) : std::string_view(type->second);
    if (type == types_.end() ? token(first + 1) != "::" : first != last) return '\0';
    return text.starts_with("Vector") ? 'v' : text.starts_with("Matrix") ? 'm' : '\0';
  }

  /// The last token of `x`, `v.norm()`, `M(0, 1)` or `(a + b)`.
  std::size_t end_of_factor(std::size_t last) const {
    while (is_one_of(token(last + 1), {".", "::"}) && is_identifier(token(last + 2))) last += 2;
    if (token(last) == "(") last = source_.partner_of(last);
    while (is_one_of(token(last + 1), {"(", "["})) last = source_.partner_of(last + 1);
    return last;
  }

  /// `a / b` or `a / b * c`, in which c is no part of the divisor, before the token here?
  bool follows_quotient() const {
    std::size_t sign = at_;
    while (token(sign) == "*") sign = std::max(operand_of(sign), std::size_t{1}) - 1;
    return token(sign) == "/";
  }

  /// A quotient of whole numbers: of variables, of a size. What follows a quotient as its factor.
  void divisions() {
    if (here() == "*" && !all_bugs_ && follows_quotient() && is_scalar(at_ + 1, end_of_factor(at_ + 1)))
      add(VariantKind::division, "divisor", "/");
    if (here() != "/" || all_bugs_ || !follows_whole()) return;
    const bool is_size = token(at_ + 2) == "." && is_one_of(token(at_ + 3), {"size", "cols", "rows"});
    if (is_whole(at_ + 1) || is_size) add(VariantKind::division, "", "* 1.0 /");
  }

  std::string text_of(std::size_t first, std::size_t last) const {
    const Token& end = source_.tokens()[last];
    const std::size_t begin = source_.tokens()[first].offset;
    return std::string(source_.text().substr(begin, end.offset + end.text.size() - begin));
  }

  /// What is easily wrong with one operand: it belongs to the other side of the fraction line; its square, its root,
  /// its transpose or a length of 1 is meant.
  void changes() {
    constexpr std::size_t short_text = 24;
    const bool is_factor = is_one_of(here(), {"*", "/"}), follows_sign = is_one_of(here(), {"+", "-", "+=", "-="});
    if (all_bugs_ || conditions_.in_loop(at_) || (!is_identifier(after()) && after() != "(")) return;
    if (!is_factor && !follows_sign && !begins_expression()) return;
    const std::size_t last = end_of_factor(at_ + 1);
    const bool is_number = is_scalar(at_ + 1, last), is_argument = here() == "(" && token(last + 1) == ")";
    if (is_whole(at_ + 1) || (here() == "=" && token(at_ - 2) == "&")) return;
    const std::string text = text_of(at_ + 1, last);
    const std::string shown = text.size() <= short_text && text[0] != '(' ? "`" + text + "`" : "this operand";
    const auto put = [&](const char* words, const char* number) {
      insert_after(VariantKind::power, "", number);
      found_.back().words = fmt::format(fmt::runtime(words), shown);
    };
    if (is_factor || (is_number && token(last + 1) == "*"))
      insert_after(VariantKind::inverse, here() == "/" ? "this divisor as a factor" : "this factor as a divisor", "1");
    if (is_number && !is_argument) put("the square of {}", "2");
    if (is_number && !is_one_of(before(), {"sqrt", "abs", "cos", "sin"})) put("the root of {}", "3");
    if (is_number && !is_argument) put("the absolute value of {}", "4");
    if (is_number && here() == "-" && before() == "1") put("1 − {} in place", "5");
    const auto type = types_.find(text);
    if (type != types_.end() && type->second == "double") put("√(1 − x²) in place of x = {}", "8");
    if (is_number && type != types_.end()) return;
    if (type == types_.end() || type->second == "Matrix3d") put("the transpose of {}", "6");
    if (type == types_.end() || type->second == "Vector3d") put("the unit vector of {}", "7");
  }

  /// `rate = g / l` as its root, its square or one over it.
  void changes_of_all() {
    constexpr std::ptrdiff_t most = 36;
    if (all_bugs_ || !is_one_of(here(), {"=", "return"}) || conditions_.in_loop(at_) || !begins_operand(at_ + 1) ||
        token(at_ - 2) == "&" || std::ranges::count(found_, VariantKind::whole, &Variant::kind) >= most)
      return;
    std::size_t end = at_ + 1;
    while (!is_one_of(token(end), {";", ",", ")", "}", "?", ""}))
      end = opens(token(end)) ? source_.partner_of(end) + 1 : end + 1;
    if (!is_one_of(token(end), {";", ","}) || end_of_factor(at_ + 1) + 1 >= end || !is_scalar(at_ + 1, end - 1)) return;
    const std::size_t first = source_.tokens()[at_].offset + here().size();
    for (const auto& [words, number] : {std::pair{"the root of all that follows", "3"},
                                        {"the square of all that follows", "2"},
                                        {"one over all that follows", "1"}})
      add(VariantKind::whole, words, at_ + 1, {{first, source_.tokens()[end].offset - first, number}});
  }

  /// The function's name in front of its bracket is left out, with a std:: before it.
  void drop(const char* words) {
    const bool has_prefix = before() == "::" && at_ >= 2 && token(at_ - 2) == "std";
    add(VariantKind::function, words, at_, {replaced(has_prefix ? at_ - 2 : at_, at_, "")});
  }

  /// A factor in front of a term: after return, =, + or -, and in a list.
  void factors() {
    const bool begins_sum = here() == "(" && is_one_of(before(), {"*", "/"}) && begins_operand(at_ + 1) &&
                            is_one_of(token(end_of_factor(at_ + 1) + 1), {"+", "-"});
    const bool begins_term = begins_sum || is_in_list() || is_one_of(here(), {"return", "=", "+", "-", "+=", "-="});
    if (!begins_term || is_zero(at_ + 1) || conditions_.in_loop(at_) || declares_whole_number()) return;
    if (!begins_operand(at_ + 1) || token(end_of_target(at_ + 1)) == "=") return;
    // In `n = axis` nobody forgot a number; another one may only move the inputs out of a wrong branch.
    if (here() == "=" && is_identifier(after()) && token(at_ + 2) == ";" && !all_bugs_) return;
    if (is_identifier(after()) && (after() == "std" || after() == "static_cast") && token(at_ + 2) != "::") return;
    for (const char* factor : {"2.0 *", "0.5 *", "3.0 *", "1.0/3 *", "4.0 *", "0.25 *", "1.5 *", "2.0/3 *"})
      insert_after(VariantKind::factor, "another factor", factor);
    insert_after(VariantKind::factor, "one term left out", "0.0 *");
    if (all_bugs_) return;
    for (const std::string& each : numbers_here()) {
      if (each == after()) continue;
      insert_after(VariantKind::factor, "one factor more", "workbook_number(" + each + ") *");
      insert_after(VariantKind::factor, "one divisor more", "1 / workbook_number(" + each + ") *");
    }
    for (const auto& [argument, angle] : angles_) {
      if (!is_visible(argument)) continue;
      for (const char* function : {"cos", "sin"})
        for (const auto& [words, before] : {std::pair{"one factor more", ""}, {"one divisor more", "1 / "}})
          insert_after(VariantKind::factor, words, fmt::format("{}std::{}({}) *", before, function, angle));
    }
  }

  /// Do we stand before an entry of `A << a, b` or `{a, b}`?
  bool is_in_list() const {
    if (here() == "<<" || (here() == "{" && begins_expression())) return true;
    if (here() != "," || !begins_expression()) return false;
    const std::string_view open = token(source_.opening_around(at_));
    return open == "{" || open.empty() || is_one_of(token(source_.opening_around(at_) - 1), {"Vector3d", "Vector2d"});
  }

  /// A term before a sum: the names of numbers and vectors, with either sign.
  void terms() {
    const bool is_group = here() == "(" && (!is_identifier(before()) || is_one_of(before(), {"return", "sqrt"}));
    if (all_bugs_ || conditions_.in_loop(at_) || is_index(at_ + 1) || declares_whole_number()) return;
    if (!is_group && !is_in_list() && !is_one_of(here(), {"return", "=", "+=", "-="})) return;
    const bool follows_sign = is_one_of(after(), {"-", "+"});
    if (!begins_operand(follows_sign ? at_ + 2 : at_ + 1) || (!follows_sign && !begins_expression() && !is_group) ||
        token(end_of_target(at_ + 1)) == "=" || (here() == "=" && token(at_ - 2) == "&"))
      return;
    std::vector<std::string> texts = numbers_here();
    for (const auto& [name, type] : types_)
      if (type == "Vector3d" && is_visible(name)) texts.push_back(name);
    for (const std::string& each : texts) {
      if (each == after()) continue;
      insert_after(VariantKind::term, "one term more", "WorkbookTerm(" + each + ")");
      insert_after(VariantKind::term, "one term more", "-WorkbookTerm(" + each + ")");
    }
  }

  /// Which leads from one set of axes to another, before a whole result.
  void matrices() {
    if (all_bugs_ || !is_one_of(here(), {"return", "="}) || !begins_expression() || !begins_operand(at_ + 1) ||
        (here() == "=" && token(at_ - 2) == "&"))
      return;
    const auto known = types_.find(std::string(after()));
    const bool has_type = known != types_.end() && !known->second.starts_with("auto ");
    if (after() == "std" || is_numeral(after()) || (has_type && is_scalar(at_ + 1, end_of_factor(at_ + 1)))) return;
    for (const auto& [name, type] : types_) {
      if (type != "Matrix3d" || name == after() || !is_visible(name)) continue;
      insert_after(VariantKind::matrix, "a matrix in front", "WorkbookMatrix{true, " + name + "}");
      insert_after(VariantKind::matrix, "a matrix in front", "WorkbookMatrix{true, " + name + ".transpose()}");
    }
  }

  /// `x = a` in a loop as `x += a`, and the other way round.
  void assignments() {
    constexpr std::ptrdiff_t most = 6;
    if (all_bugs_ || !is_one_of(here(), {";", "{", "}", ")"}) || !types_.contains(std::string(after())) ||
        is_declared_at(at_ + 1) || std::ranges::count(found_, VariantKind::assignment, &Variant::kind) >= most)
      return;
    const std::string& type = types_.at(std::string(after()));
    const std::size_t sign = end_of_target(at_ + 1);
    const std::string written(token(sign));
    const auto put = [&](const std::string& other) {
      add(VariantKind::assignment, "`" + other + "` in place of `" + written + "`", at_ + 1,
          {replaced(sign, sign, other)});
    };
    if (is_one_of(written, {"+=", "*="}) && !is_numeral(token(end_of_statement(sign) - 1))) put("=");
    if (written != "=" || !is_repeated(at_ + 1)) return;
    if (type != "Quaterniond") put("+=");
    if (is_one_of(type, {"double", "Matrix3d", "Quaterniond"}) && sign == at_ + 2) put("*=");
  }

  /// Does a loop repeat the statement here?
  bool is_repeated(std::size_t index) const {
    const auto ends_head = [&](std::size_t close) {
      return token(close) == ")" && source_.partner_of(close) > 0 &&
             is_one_of(token(source_.partner_of(close) - 1), {"for", "while"});
    };
    if (ends_head(index - 1)) return true;
    for (std::size_t open = source_.opening_around(index); open > 0 && token(open) == "{";
         open = source_.opening_around(open))
      if (ends_head(open - 1) || token(open - 1) == "do") return true;
    return false;
  }

  /// `a * b - c / d` as `a * (b - c) / d`, and `a * b + c + d` as `a * (b + c + d)`.
  void brackets() {
    constexpr std::ptrdiff_t most = 8;
    if (!is_one_of(here(), {"+", "-"}) || !follows_operand() || all_bugs_ || conditions_.in_loop(at_)) return;
    std::size_t first = at_ - 1;
    if (closes(token(first))) first = source_.partner_of(first);
    if (is_one_of(token(first), {"(", "["}) && is_identifier(token(first - 1)) && token(first - 1) != "return") --first;
    while (first > 2 && is_one_of(token(first - 1), {".", "::"}) && is_identifier(token(first - 2))) first -= 2;
    if (!begins_operand(at_ + 1)) return;
    const std::size_t last = end_of_factor(at_ + 1);
    const char left = shape_of(first, at_ - 1), right = shape_of(at_ + 1, last);
    const bool are_known = left != '\0' && right != '\0';
    if (is_scalar(first, at_ - 1) != is_scalar(at_ + 1, last) || (are_known && left != right)) return;
    if (!is_one_of(token(first - 1), {"*", "/"}) && !is_one_of(token(last + 1), {"*", "/"})) return;
    if (std::ranges::count(found_, VariantKind::brackets, &Variant::kind) >= most) return;
    std::size_t end = last;
    while (is_one_of(token(end + 1), {"+", "-"}) && begins_operand(end + 2)) end = end_of_factor(end + 2);
    for (const std::size_t behind : std::set{last, end}) {
      const Token& closed = source_.tokens()[behind];
      add(VariantKind::brackets, "brackets around the sum (* and / come before + and −)", at_,
          {{source_.tokens()[first].offset, 0, "("}, {closed.offset + closed.text.size(), 0, ")"}});
    }
  }

  /// `c ? a : b * d` as `(c ? a : b) * d`, and `d * c > 0 ? a : b` as `d * (c > 0 ? a : b)`.
  void brackets_around_choice() {
    if (here() != "?" || all_bugs_) return;
    std::size_t sign = at_;
    while (sign > first_ && !is_one_of(token(sign), {"<", ">", "<=", ">=", "==", "(", ";", "{", "}"})) --sign;
    std::size_t behind = at_;
    while (behind < last_ && !is_one_of(token(behind), {";", ")", "}"})) ++behind;
    if (is_one_of(token(sign), {"<", ">", "<=", ">=", "=="}) && behind < last_)
      if (const std::size_t condition = operand_of(sign); is_one_of(token(condition - 1), {"*", "/", "+", "-"}))
        add(VariantKind::brackets, brackets_around_choice_words, at_,
            {{source_.tokens()[condition].offset, 0, "("}, {source_.tokens()[behind].offset, 0, ")"}});
    std::size_t first = at_, colon = at_;
    while (first > first_ && !opens(token(first - 1)) && !is_one_of(token(first - 1), {"return", "=", ",", ";", "}"}))
      first = closes(token(first - 1)) ? source_.partner_of(first - 1) : first - 1;
    while (colon < last_ && !is_one_of(token(colon), {":", ";"})) ++colon;
    if (token(colon) != ":" || !begins_operand(colon + 1)) return;
    const Token& end = source_.tokens()[end_of_factor(colon + 1)];
    if (!is_one_of(token(end_of_factor(colon + 1) + 1), {"*", "/", "+", "-"})) return;
    add(VariantKind::brackets, brackets_around_choice_words, at_,
        {{source_.tokens()[first].offset, 0, "("}, {end.offset + end.text.size(), 0, ")"}});
  }

  /// `A * B.transpose()` as `B.transpose() * A`.
  void order_of_matrices() {
    constexpr std::ptrdiff_t most = 6;
    if (here() != "*" || !follows_operand() || !begins_operand(at_ + 1) || all_bugs_) return;
    const auto is_matrix = [&](std::size_t first, std::size_t last) {
      const auto type = types_.find(std::string(token(first)));
      const bool is_whole = first == last && type != types_.end() && type->second == "Matrix3d";
      return is_whole ||
             (token(last) == ")" && is_one_of(token(last - 2), {"transpose", "inverse", "toRotationMatrix"}));
    };
    const auto may_be = [&](std::size_t first, std::size_t last) {
      return is_matrix(first, last) ||
             (token(last) == ")" && is_identifier(token(first)) && token(first) != "std" &&
              !token(first).starts_with("Vector") && !types_.contains(std::string(token(first))));
    };
    const std::size_t left = operand_of(at_);
    std::size_t right = at_ + 1, end = end_of_factor(right);
    const auto exchange_both = [&](const char* words) {
      add(VariantKind::brackets, words, at_,
          {replaced(left, at_ - 1, text_of(right, end)), replaced(right, end, text_of(left, at_ - 1))});
    };
    // `A * I * A.transpose()`
    if (const std::size_t last = end_of_factor(end + 2);
        token(end + 1) == "*" && !is_one_of(token(left - 1), {"*", "/"})) {
      const std::string one = text_of(left, at_ - 1), other = text_of(end + 2, last);
      if (one != other + ".transpose()" && other != one + ".transpose()") return;
      right = end + 2;
      end = last;
      return exchange_both("the first and the last of these three matrices exchanged");
    }
    if (is_one_of(token(left - 1), {"/", "*"}) || is_one_of(token(end + 1), {"*", "/"}) || !may_be(left, at_ - 1) ||
        !may_be(right, end) || !(is_matrix(left, at_ - 1) || is_matrix(right, end)) ||
        std::ranges::count(found_, order_words, &Variant::words) >= most)
      return;
    exchange_both(order_words);
  }

  /// `A * v.cross(w)` as `(A * v).cross(w)`.
  void brackets_before_method() {
    static const std::initializer_list<std::string_view> methods = {
        "cross",     "dot",     "norm",       "squaredNorm",  "sum",
        "transpose", "inverse", "normalized", "cwiseProduct", "cwiseQuotient"};
    if (here() != "." || !is_one_of(after(), methods) || all_bugs_) return;
    const std::size_t operand = operand_of(at_);
    if (operand < 3 || !is_one_of(token(operand - 1), {"*", "+", "-"})) return;
    const std::string_view end = token(operand - 2);
    if (end == "return" || !(is_identifier(end) || closes(end))) return;
    const std::size_t left = operand_of(operand - 1);
    if (token(operand - 1) != "*" && is_scalar(left, operand - 2)) return;
    if (shape_of(left, operand - 2) == 'v' && shape_of(operand, at_ - 1) == 'v' && token(operand - 1) == "*") return;
    add(VariantKind::brackets, brackets_before_method_words, at_,
        {{source_.tokens()[left].offset, 0, "("}, {source_.tokens()[at_].offset, 0, ")"}});
  }

  /// `x = c * x - s * y; y = s * x + c * y;` with the x from before.
  void overwritten() {
    constexpr std::size_t most = 6;
    if (!is_one_of(here(), {";", "{", "}"}) || !is_identifier(after()) || is_identifier(token(at_ + 2)) || all_bugs_)
      return;
    const std::size_t equals = end_of_target(at_ + 1);
    if (!is_one_of(token(equals), {"=", "+=", "-=", "*=", "/="})) return;
    const std::size_t length = equals - at_ - 1, end = end_of_statement(equals);
    const auto stands_at = [&](std::size_t index) {
      for (std::size_t k = 0; k < length; ++k)
        if (token(index + k) != token(at_ + 1 + k)) return false;
      return !is_one_of(token(index - 1), {".", "->", "::"});
    };
    Variant variant{VariantKind::overwritten, "", {}, {}};
    const Token& target = source_.tokens()[at_ + 1];
    const std::string text(source_.text().substr(
        target.offset, source_.tokens()[equals - 1].offset + source_.tokens()[equals - 1].text.size() - target.offset));
    const std::string old = fmt::format("workbook_old_{}", at_);
    variant.edits.push_back({target.offset, 0, fmt::format("const auto {} = workbook_value({}); ", old, text)});
    std::size_t statement = end + 1;
    for (std::size_t count = 0; count < most && statement < last_ && is_identifier(token(statement)); ++count) {
      const std::size_t stop = end_of_statement(statement);
      if (stands_at(statement) || token(statement) == "return") break;
      for (std::size_t k = statement + 1; k < stop; ++k) {
        if (!stands_at(k)) continue;
        if (variant.edits.size() == 1) variant.place = source_.place_of(source_.tokens()[k].offset);
        variant.edits.push_back(replaced(k, k + length - 1, old));
      }
      statement = stop + 1;
    }
    if (variant.edits.size() == 1) return;
    variant.words = "the value of `" + text + "` from before the line that changes it";
    found_.push_back(std::move(variant));
  }

  std::size_t end_of_statement(std::size_t index) const {
    while (index < last_ && token(index) != ";")
      index = opens(token(index)) ? source_.partner_of(index) + 1 : index + 1;
    return index;
  }

  /// `int i = …`: half of it is none.
  bool declares_whole_number() const {
    if (at_ < 1 || here() != "=") return false;
    const auto type = types_.find(std::string(before()));
    return type != types_.end() && is_one_of(type->second, whole_types);
  }

  void bugs() {
    static const std::map<std::string_view, std::vector<const char*>> others = {
        {"<", {"<=", ">"}}, {"<=", {"<", ">="}}, {">", {">=", "<"}},  {">=", {">", "<="}}, {"==", {"!="}},
        {"!=", {"=="}},     {"&&", {"||"}},      {"||", {"&&"}},      {"*", {"/"}},        {"/", {"*"}},
        {"0", {"1"}},       {"0.0", {"1.0"}},    {"true", {"false"}}, {"false", {"true"}}};
    if (const auto found = others.find(here()); found != others.end() && !is_index(at_))
      for (const char* other : found->second) add(VariantKind::bug, "another operator or constant", other);
    if (here() == "." && token(at_ + 2) == "(" && token(at_ + 3) == ")")
      add(VariantKind::call, "one call left out", at_, {replaced(at_, at_ + 3, "")});
    if (here() == ";" || here() == "{" || here() == "}") statement_after();
  }

  /// Left out, unless it declares something or is a plain return.
  void statement_after() {
    if (!is_identifier(after()) || after() == "return" || is_identifier(token(at_ + 2))) return;
    int depth = 0;
    for (std::size_t end = at_ + 1; end < last_ && token(end) != "}" && token(end) != "{"; ++end) {
      if (token(end) == "(") ++depth;
      if (token(end) == ")") --depth;
      if (token(end) == ";" && depth == 0)
        return add(VariantKind::statement, "one statement left out", at_ + 1, {replaced(at_ + 1, end, ";")});
    }
  }

  const SourceText& source_;
  const Conditions conditions_;
  const bool all_bugs_;
  const std::size_t most_;
  std::map<std::string, std::string> types_;                                 ///< of arguments and local variables
  std::set<std::string> constants_;                                          ///< of these
  std::map<std::string, Unit, std::less<>> units_;                           ///< of arguments
  std::map<std::string, std::vector<Scope>> scopes_;                         ///< of local variables
  std::map<std::pair<std::string, std::string>, std::vector<Edit>> places_;  ///< of one text in place of another
  Scope body_ = {0, last_token_looked_at};                                   ///< of the exercise's function
  std::vector<Operand> operands_;
  std::vector<Lambda> closed_;  ///< without a default of their captures
  std::map<std::string, std::set<std::ptrdiff_t>, std::less<>> changed_arguments_;  ///< of functions: their places
  std::vector<std::pair<std::string, std::string>> angles_;  ///< an argument, and the angle in it
  static constexpr const char* order_words = "the two matrices in the other order";
  std::vector<Variant> found_;
  std::size_t at_ = 0, first_ = 0, last_ = 0;
};

}  // namespace

std::vector<Variant> branch_variants(const SourceText& source) {
  constexpr std::size_t most = 48;
  const std::vector<Token>& tokens = source.tokens();
  const Conditions conditions(source);
  std::vector<Variant> found;
  const auto add = [&](std::size_t place, std::pair<std::size_t, std::size_t> condition,
                       std::pair<std::size_t, std::size_t> body) {
    const auto begin_of = [&](std::size_t index) { return tokens[index].offset; };
    const auto end_of = [&](std::size_t index) { return tokens[index].offset + tokens[index].text.size(); };
    const std::size_t begin = begin_of(condition.first), end = end_of(condition.second);
    for (const VariantKind kind : {VariantKind::branch, VariantKind::branch_off, VariantKind::branch_on})
      found.push_back({kind,
                       std::string(source.text().substr(begin, end - begin)),
                       source.place_of(begin_of(place)),
                       {{begin, end - begin, ""}},
                       begin_of(body.first),
                       end_of(body.second)});
    found.push_back({VariantKind::branch_opposite,
                     "the opposite of this condition",
                     source.place_of(begin_of(condition.first)),
                     {{begin, end - begin, ""}}});
  };
  const std::size_t last = std::min(tokens.size(), last_token_looked_at);
  for (std::size_t k = 1; k + 2 < last && found.size() < most; ++k) {
    if (tokens[k].in_directive) continue;
    if (tokens[k].text == "if" && tokens[k + 1].text == "(") {
      const std::size_t close = source.partner_of(k + 1);
      if (close + 1 >= last || close < k + 3) continue;
      std::size_t condition = close;  // behind what `if (const double x = f(y); x > 0)` declares
      while (condition > k + 2 && tokens[condition - 1].text != ";") --condition;
      std::size_t body_end = close + 1;
      if (tokens[body_end].text == "{") {
        body_end = source.partner_of(body_end);
      } else {
        while (body_end + 1 < last && tokens[body_end].text != ";")
          body_end = opens(tokens[body_end].text) ? source.partner_of(body_end) + 1 : body_end + 1;
      }
      add(k, {condition, close - 1}, {close + 1, std::min(body_end, last - 1)});
    } else if (tokens[k].text == "?") {
      const std::size_t end = conditions.end_of_operand(k), begin = conditions.begin_of_operand(k);
      if (begin < k && end < last && tokens[end].text == ":") add(begin, {begin, k - 1}, {k + 1, end - 1});
    }
  }
  return found;
}

std::vector<Variant> one_token_variants(const SourceText& source, const ExerciseReference& exercise) {
  return SourceMutations(source, exercise, false).all();
}

std::vector<Variant> source_mutants(const SourceText& source, const ExerciseReference& exercise) {
  return SourceMutations(source, exercise, true).all();
}

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::ranges::sort(edits, {}, &Edit::offset);
  std::string result;
  std::size_t at = 0;
  for (const Edit& edit : edits) {
    result += text.substr(at, edit.offset - at);
    result += edit.replacement;
    at = edit.offset + edit.length;
  }
  return result.append(text.substr(at));
}

}  // namespace workbook
