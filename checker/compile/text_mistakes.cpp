#include "checker/compile/mistakes.hpp"

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <span>

namespace workbook {
namespace {

constexpr std::size_t most_tokens = 20000;      // no exercise is longer; of a longer file the beginning is read
constexpr std::size_t longest_statement = 500;  // in letters; std::regex recurses over the length of its text

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
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (is_one_of(tokens, i, texts)) return true;
  return false;
}

/// A mistake that a statement gives away. The caret stands at what $1 stands for.
struct TextMistake {
  const char* name;
  std::regex pattern;
  const char* sentence;
  bool (*holds)(const std::smatch& found) = nullptr;  ///< a further condition
  const char* unless = "";                            ///< not in a file with one of these words
};

// The methods of a type of one's own may do anything.
constexpr const char* own_types = " struct class union ";

const std::vector<TextMistake>& table() {
  const auto is_inexact = [](const std::smatch& found) { return std::stol(found[2]) % std::stol(found[3]) != 0; };
  const auto is_rounded_pi = [](const std::smatch& found) {
    const double distance = std::abs(std::stod(found[1]) - std::numbers::pi);
    return distance > 1e-15 && distance < 2e-3;
  };
  // Between parentheses, which may be nested twice.
  const std::string inside = R"((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)";
  static const std::vector<TextMistake> mistakes = {
      {"integer_division", std::regex(R"((?:^|[^*/%).>[] )((\d{1,9}) / ([1-9]\d{0,8}))(?= |$))"),
       "`$1` divides whole numbers and drops what follows the decimal point; write at least one of them as in 1.0.",
       is_inexact},
      {"degrees_literal",
       std::regex(
           R"((?:^|[^.>] )((sin|cos|tan) \( ((?:- )?(?:15|30|45|60|75|90|120|135|150|180|270|360)(?:\.0*)?) \)))"),
       "`$1`: $2 takes radians, not degrees; multiply degrees by std::numbers::pi / 180."},
      {"degrees_argument",
       std::regex(
           R"((?:^|[^.>] )((sin|cos|tan) \((?![^()]*/ 180)[^()]* 180(?:\.0*)? / (?:std :: numbers :: )?(pi|M_PI)\b))"),
       "$2 takes radians, but 180 / $3 turns its argument into degrees."},
      {"xor_for_power", std::regex(R"((?:^| )(\S+ \^ [2-9])(?= |$))"),
       "`$1` is not a power in C++: ^ combines the bits of whole numbers. Write x * x or std::pow(x, 2)."},
      {"discarded_result",
       std::regex(R"(^(\w+)(?: \. \w+ \( )" + inside +
                  R"(\))*? \. (transpose|normalized|inverse|adjoint|cross|dot|norm|)" +
                  R"(squaredNorm|sum|trace|determinant|eval|cwise\w+) \( )" + inside + R"(\) ;$)"),
       "$2() changes nothing: it returns a new value, which is dropped here. Write A = A.$2(...).", nullptr, own_types},
      {"aliasing", std::regex(R"(^(\w+) \. noalias \( \) [+-]?= (?:.* )?\1 (?:.* )?;$)"),
       "noalias() writes into `$1` while `$1` is still read on the right: leave it out, or use another variable.",
       nullptr, own_types},
      {"empty_body", std::regex(R"(^(?:else )?(for|if) \( )" + inside + R"(\) ;$)"),
       "The ; directly behind $1 (...) is all that it does: what follows does not belong to it. Leave out this ;"},
      {"rounded_pi", std::regex(R"((?:^| )(3\.14\d*)(?= |$))"), "$1 is only near π; write std::numbers::pi.",
       is_rounded_pi},
      {"float_precision", std::regex("(?:^| )(float) "), "A float keeps only about 7 digits; use double."},
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

}  // namespace

std::vector<Finding> text_mistakes(const SourceText& source) {
  static const std::regex declaration("^(Matrix[234]d|Vector[234]d) (\\w+) ;$");
  constexpr std::size_t most = 20;
  const std::span tokens(source.tokens().data(), std::min(source.tokens().size(), most_tokens));
  const bool has_own_types = has_one_of(tokens, own_types);
  std::vector<const TextMistake*> possible;
  for (const TextMistake& mistake : table())
    if (!has_one_of(tokens, mistake.unless)) possible.push_back(&mistake);
  std::vector<Finding> found;
  std::smatch match;
  const auto add = [&](std::size_t token, const char* name, std::string sentence) {
    for (std::size_t i = 1; i < match.size(); ++i)
      boost::replace_all(sentence, "$" + std::to_string(i), boost::erase_all_copy(match[i].str(), " "));
    found.push_back(source.finding(source.place_of(tokens[token].offset), name, sentence));
  };
  for (const Statement& statement : statements_of(tokens)) {
    if (statement.text.size() > longest_statement || found.size() > most) continue;
    for (const TextMistake* mistake : possible) {
      if (!std::regex_search(statement.text, match, mistake->pattern)) continue;
      if (mistake->holds != nullptr && !mistake->holds(match)) continue;
      const auto at = std::ranges::upper_bound(statement.ends, static_cast<std::size_t>(match.position(1)));
      add(statement.first_token + static_cast<std::size_t>(at - statement.ends.begin()), mistake->name,
          mistake->sentence);
    }
    if (has_own_types || !std::regex_search(statement.text, match, declaration)) continue;
    if (const std::size_t sum = sum_without_start(tokens, statement.first_token + 1); sum > 0)
      add(sum, "uninitialized_variable", "`$2` has no value yet here: begin with $1 $2 = $1::Zero();");
  }
  return found;
}

}  // namespace workbook
