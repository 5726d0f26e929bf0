#include "checker/compile/diagnostics.hpp"

#include "checker/base/text.hpp"

#include <boost/algorithm/string/erase.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace workbook {
namespace {

constexpr std::size_t most_tokens = 20000;      // no exercise is longer; of a longer file the beginning is read
constexpr std::size_t longest_statement = 500;  // in letters

/// A statement, or the head of a block: its tokens with one space between them, the mark that ends it among them.
struct Statement {
  std::string text;
  std::vector<std::size_t> ends;  ///< of each token in the text
  std::size_t first_token = 0;
};

std::vector<Statement> statements_of(std::span<const Token> tokens) {
  std::vector<Statement> statements(1);
  std::vector<int> levels(1, 0);  // of round and square brackets, in each open block
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].in_directive) continue;
    Statement& statement = statements.back();
    const std::string token(tokens[i].is_literal() ? "\"\"" : tokens[i].text);
    if (statement.ends.empty()) statement.first_token = i;
    statement.text += (statement.ends.empty() ? "" : " ") + token;
    statement.ends.push_back(statement.text.size());
    levels.back() += token == "(" || token == "[" ? 1 : token == ")" || token == "]" ? -1 : 0;
    if (token == "{") levels.push_back(0);
    if (token == "}" && levels.size() > 1) levels.pop_back();
    if (token == "{" || token == "}" || (token == ";" && levels.back() <= 0)) statements.emplace_back();
  }
  return statements;
}

/// " = += " for one of two tokens
bool is_one_of(std::span<const Token> tokens, std::size_t i, std::string_view texts) {
  return i < tokens.size() && texts.find(" " + std::string(tokens[i].text) + " ") != std::string_view::npos;
}

bool has_one_of(std::span<const Token> tokens, std::string_view texts) {
  return std::ranges::any_of(tokens, [&](const Token& token) { return is_one_of({&token, 1}, 0, texts); });
}

/// A mistake that a statement gives away. The caret stands at what $1 stands for.
struct TextMistake {
  const char* name;
  std::string pattern;
  const char* sentence;
  bool (*holds)(const Match& found) = nullptr;  ///< a further condition
  const char* unless = "";                      ///< not in a file with one of these words
  Weight weight = Weight::cause;
  Fix fix = Fix::none;
};

// The methods of a type of one's own may do anything.
constexpr const char* own_types = " struct class union ";

const std::vector<TextMistake>& table() {
  const auto is_inexact = [](const Match& found) { return std::stol(found[2]) % std::stol(found[3]) != 0; };
  const auto is_rounded_pi = [](const Match& found) {
    const double distance = std::abs(std::stod(found[1]) - std::numbers::pi);
    return distance > 1e-15 && distance < 2e-3;
  };
  const auto is_false_at_first = [](const Match& found) {
    return std::stol(found[2]) < std::stol(found[4]) + (found[3] == ">" ? 1 : 0);
  };
  // Between parentheses, which may be nested twice.
  const std::string inside = R"((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)";
  static const std::vector<TextMistake> mistakes = {
      {"integer_division", R"((?:^|[^*/%).>[] )((\d{1,9}) / ([1-9]\d{0,8}))(?= |$))",
       "`$1` divides whole numbers and drops what follows the decimal point; write at least one of them as in 1.0.",
       is_inexact, "", Weight::cause, Fix::real_quotient},
      {"degrees_literal",
       R"((?:^|[^.>] )((sin|cos|tan) \( ((?:- )?(?:15|30|45|60|75|90|120|135|150|180|270|360)(?:\.0*)?) \)))",
       "`$1`: $2 takes radians, not degrees; multiply degrees by std::numbers::pi / 180."},
      {"degrees_argument",
       R"((?:^|[^.>] )((sin|cos|tan) \((?![^()]*/ 180)[^()]* 180(?:\.0*)? / (?:std :: numbers :: )?(pi|M_PI)\b))",
       "$2 takes radians, but 180 / $3 turns its argument into degrees.", nullptr, "", Weight::possible},
      {"xor_for_power", R"((?:^| )(\S+ \^ [2-9])(?= |$))",
       "`$1` is not a power in C++: ^ combines the bits of whole numbers. Write x * x or std::pow(x, 2)."},
      {"discarded_result",
       R"(^(\w+)(?: \. \w+ \( )" + inside + R"(\))*? \. (transpose|normalized|inverse|adjoint|cross|dot|norm|)" +
           R"(squaredNorm|sum|trace|determinant|eval|cwise\w+) \( )" + inside + R"(\) ;$)",
       "$2() changes nothing: it returns a new value, which is dropped here. Write A = A.$2(...).", nullptr, own_types},
      {"aliasing", R"(^(\w+) \. noalias \( \) [+-]?= (?:.* )?\1 (?:.* )?;$)",
       "noalias() writes into `$1` while `$1` is still read on the right: leave it out, or use another variable.",
       nullptr, own_types, Weight::possible, Fix::no_noalias},
      {"empty_body", R"(^(?:else )?(for|if) \( )" + inside + R"(\) ;$)",
       "The ; directly after $1 (...) is all that it does: what follows does not belong to it. Leave out this ;"},
      {"empty_body", R"(^(while) \( )" + inside + R"(\) ;$)",
       "The ; directly after $1 (...) is all that it does: what follows does not belong to it. Leave out this ;",
       nullptr, " do "},
      {"unary_plus", R"(^for \( .* \) [\w.\[\]]+ (= \+) )", "=+ only assigns; what adds to a variable is +=."},
      {"other_counter",
       R"(for \( (?:[\w:]+ )?(\w+) = [^;]* ; \1 [^;]* ; (?:(?:\+\+|--) (?!\1\b)(\w+)|(?!\1\b)(\w+) (?:\+\+|--)) \))",
       "This loop runs as long as `$1` is small enough, but its head changes `$2$3`."},
      {"loop_never_runs", R"(for \( (?:[\w:]+ )?(\w+) = (\d{1,9}) ; \1 (>=?) (\d{1,9}) ;)",
       "This loop never runs: `$1` begins at $2, where $1 $3 $4 is false.", is_false_at_first},
      {"always_true", R"((?:[=!]=|[<>]=?) [^ ]+ (\|\| \d[\w.]*)(?= (?:[)|&;?]|\|\|)))",
       "`$1` is always true, whatever stands before it: write the whole comparison again, as in x == 1 || x == 2."},
      {"whole_sum", R"((accumulate) \( .* , 0 \))",
       "This sum begins with the whole number 0 and drops what follows every decimal point: begin with 0.0."},
      {"rounded_pi", R"((?:^| )(3\.14\d*)(?= |$))", "$1 is only near π; write std::numbers::pi.", is_rounded_pi, "",
       Weight::cause, Fix::exact_pi},
      {"size_for_length", R"((?:^| )(\w+) / \1 \. size \( \))",
       "`$1.size()` is the number of components: the length of a vector is `$1.norm()`."},
      {"size_in_bytes", R"(< (sizeof \( (\w+) \)))", "`$1` counts bytes: how many elements there are is `$2.size()`.",
       nullptr, "", Weight::possible},
      {"rows_first", R"((Matrix3Xd) \w+ \( (?!3 ,)[^,]+ , 3 \))",
       "Rows come first, and a $1 has 3 of them: write $1 name(3, n).", nullptr, "", Weight::possible},
      {"unsigned_difference",
       R"(for \( (?:std :: )?(?:unsigned|size_t)(?: int| long)? (\w+) = [^;]* ; \1 <=? ([^;]* - \d+) ;)",
       "`$2` is never negative but huge, for it has no sign: count with int.", nullptr, "", Weight::possible},
      {"exact_end", R"(^(?:while|for) \( (?:[^;()]*;)? ?(\w+ != \d*\.\d*)(?= [;)]))",
       "Rounded steps hardly ever hit a number, so that `$1` is never false: compare by <.", nullptr, "",
       Weight::possible},
      {"float_precision", "(?:^| )(float) ", "A float keeps only about 7 digits; use double.", nullptr, "",
       Weight::possible, Fix::as_double},
  };
  return mistakes;
}

/// Matrix3d I; for (...) I += ...; where nothing can have given I a value before. @returns the second I or 0
std::size_t sum_without_start(std::span<const Token> tokens, std::size_t declared) {
  std::size_t sum = 0;
  for (std::size_t k = declared + 1; k < std::min(tokens.size(), declared + 1000); ++k) {
    if (tokens[k].text != tokens[declared].text) continue;
    if (sum == 0 && !is_one_of(tokens, k + 1, " += -= ")) return 0;
    if (sum == 0) sum = k;
    if (is_one_of(tokens, k + 2, " transpose norm trace dot cross ")) continue;
    // Anything that may give it a value, on whatever way through the function.
    if (is_one_of(tokens, k + 1, " = << . ( [ -> ") || is_one_of(tokens, k - 1, " & = [ ")) return 0;
    if (is_one_of(tokens, k - 1, " ( , ") && is_one_of(tokens, k + 1, " ) , ")) return 0;
  }
  return sum;
}

/// static double s = 0; … s += x; @returns does it keep what calls before have added
bool accumulates(std::span<const Token> tokens, std::size_t declared) {
  for (std::size_t k = declared + 1; k < std::min(tokens.size(), declared + 1000); ++k)
    if (tokens[k].text == tokens[declared].text &&
        (is_one_of(tokens, k + 1, " += -= *= /= ++ -- ") || is_one_of(tokens, k - 1, " ++ -- ")))
      return true;
  return false;
}

}  // namespace

std::vector<Reason> text_mistakes(const SourceText& source) {
  constexpr std::size_t most = 20;
  const std::span tokens(source.tokens().data(), std::min(source.tokens().size(), most_tokens));
  const bool has_own_types = has_one_of(tokens, own_types);
  std::vector<const TextMistake*> possible;
  for (const TextMistake& mistake : table())
    if (!has_one_of(tokens, mistake.unless)) possible.push_back(&mistake);
  std::vector<Reason> found;
  const auto add = [&](std::size_t token, const char* name, Match match, const char* sentence,
                       Weight weight = Weight::cause, Fix fix = Fix::none) {
    for (std::string& group : match.groups) boost::erase_all(group, " ");
    found.push_back(source.reason(source.place_of(tokens[token].offset), name, match.fill(sentence), weight, fix));
  };
  std::string last;            // statement
  int depth = 0;               // of braces that no namespace opens
  bool is_first_turn = false;  // of a loop, without a condition so far
  for (const Statement& statement : statements_of(tokens)) {
    const std::string before = std::exchange(last, statement.text);
    if (is_first_turn && statement.text.starts_with("return "))
      add(statement.first_token, "return_in_loop", Match(),
          "This return ends the loop in its first turn: it belongs after the } of the loop.");
    if (statement.text.ends_with("{") || statement.text.ends_with("}"))
      is_first_turn = search(statement.text, R"(^for \( .* \) \{$)").groups.size() > 0;
    else if (search(statement.text, R"(^(if|else|while|do|switch|for|case|break|continue)\b)"))
      is_first_turn = false;
    if (statement.text.size() > longest_statement || found.size() > most) continue;
    if (const Match copied = search(before, R"(^([\w.\[\]() ,]+) = ([\w.\[\]() ,]+) ;$)");
        copied && statement.text == copied[2] + " = " + copied[1] + " ;")
      add(statement.first_token, "overwritten", copied,
          "`$1` was given the value of `$2` just before, so this changes nothing: std::swap exchanges two values.",
          Weight::possible);
    for (const TextMistake* mistake : possible) {
      const Match match = search(statement.text, mistake->pattern);
      if (!match || (mistake->holds != nullptr && !mistake->holds(match))) continue;
      const auto at = std::ranges::upper_bound(statement.ends, match.offsets[1]);
      add(statement.first_token + static_cast<std::size_t>(at - statement.ends.begin()), mistake->name, match,
          mistake->sentence, mistake->weight, mistake->fix);
    }
    const bool is_outside = depth == 0;
    if (statement.text.ends_with("{") && !statement.text.starts_with("namespace")) ++depth;
    if (statement.text.ends_with("}") && depth > 0) --depth;
    const Match kept = search(statement.text, R"(^(static )?(?:[\w:<>]+ )+?(\w+) (?:;|=|\(|\{))");
    if (kept && (is_outside || !kept[1].empty())) {
      const auto at = std::ranges::lower_bound(statement.ends, kept.offsets[2] + kept[2].size());
      if (accumulates(tokens, statement.first_token + static_cast<std::size_t>(at - statement.ends.begin())))
        add(statement.first_token, "static_variable", kept,
            "`$2` keeps its value from one call to the next, and results depend on earlier ones: define it in the "
            "function.",
            Weight::possible, Fix::not_static);
    }
    const Match declaration = search(statement.text, "^(Matrix[234]d|Vector[234]d) (\\w+) ;$");
    if (has_own_types || !declaration) continue;
    if (const std::size_t sum = sum_without_start(tokens, statement.first_token + 1); sum > 0)
      add(sum, "uninitialized_variable", declaration, "`$2` has no value yet here: begin with $1 $2 = $1::Zero();");
  }
  return found;
}

}  // namespace workbook
