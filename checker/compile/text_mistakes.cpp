#include "checker/compile/diagnostics.hpp"

#include "checker/base/text.hpp"

#include <boost/algorithm/string/erase.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace workbook {
namespace {

constexpr std::size_t most_tokens = 6000;       // no exercise is longer; of a longer file the beginning is read
constexpr std::size_t longest_statement = 500;  // in letters

/// A statement, or the head of a block: its tokens with one space between them, the mark that ends it among them.
struct Statement {
  std::string text;
  std::vector<std::size_t> ends;    ///< of each token in the text
  std::vector<std::size_t> tokens;  ///< the number of each

  std::size_t token_at(std::size_t offset) const {
    return tokens.at(static_cast<std::size_t>(std::ranges::upper_bound(ends, offset) - ends.begin()));
  }
};

std::vector<Statement> statements_of(std::span<const Token> tokens) {
  std::vector<Statement> statements(1);
  std::vector<int> levels(1, 0);  // of round and square brackets, in each open block
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].in_directive) continue;
    Statement& statement = statements.back();
    const std::string token(tokens[i].is_literal() ? "\"\"" : tokens[i].text);
    statement.text += (statement.ends.empty() ? "" : " ") + token;
    statement.ends.push_back(statement.text.size());
    statement.tokens.push_back(i);
    levels.back() += token == "(" || token == "[" ? 1 : token == ")" || token == "]" ? -1 : 0;
    if (token == "{") levels.push_back(0);
    if (token == "}" && levels.size() > 1) levels.pop_back();
    if (token == "{" || token == "}" || (token == ";" && levels.back() <= 0)) statements.emplace_back();
  }
  return statements;
}

/// Statements that follow each other, a line each.
Statement joined(std::span<const Statement> statements) {
  Statement all;
  for (const Statement& one : statements) {
    if (!all.text.empty()) all.text += "\n";
    for (const std::size_t end : one.ends) all.ends.push_back(all.text.size() + end);
    all.tokens.insert(all.tokens.end(), one.tokens.begin(), one.tokens.end());
    all.text += one.text;
  }
  return all;
}

/// " = += " for one of two tokens
bool token_is(std::span<const Token> tokens, std::size_t i, std::string_view texts) {
  return i < tokens.size() && texts.find(" " + std::string(tokens[i].text) + " ") != std::string_view::npos;
}

bool has_one_of(std::span<const Token> tokens, std::string_view texts) {
  return std::ranges::any_of(tokens, [&](const Token& token) { return token_is({&token, 1}, 0, texts); });
}

/// Does a text name one of the " words with blanks between "?
bool names_one_of(const std::string& text, const std::string& names) {
  const std::vector<Match> words = search_all(text, "\\w+");
  return std::ranges::any_of(words,
                             [&](const Match& word) { return names.find(" " + word[0] + " ") != std::string::npos; });
}

/// A mistake that a statement gives away, or several that follow each other, with "\n" between them; the pattern then
/// ends in the last one. The caret stands at what $1 stands for.
struct TextMistake {
  const char* name;
  std::string pattern;
  const char* sentence;
  bool (*holds)(const Match& found) = nullptr;  ///< a further condition
  const char* unless = "";                      ///< not in a file with one of these words
  Weight weight = Weight::cause;
  Fix fix = Fix::none;
  bool needs_failure = true;
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
  // Whatever else mentions it may keep what it was given.
  const auto is_named_once = [](const Match& found) {
    return search_all(found[0], "\\b" + found[2] + "\\b").size() == 1;
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
      {"degrees_argument",
       R"((\w+) = [^\n]* 180(?:\.0*)? / (?:std :: numbers :: )?(?:pi|M_PI|3\.14\d*) ;\n(?:[^\n]*\n)*?[^\n]*(sin|cos|tan) \( \1 \)[^\n]*$)",
       "$2 takes radians, but 180 / π has turned `$1` into degrees.", nullptr, "", Weight::possible},
      {"self_assignment", R"(^(\w+) = \1 ;$)",
       "This assigns `$1` to itself: a parameter hides the member of this name, which is this->$1."},
      {"xor_for_power", R"((?:^| )(?<!\^ )(10 \^ (?:- )?\d+|\S+ \^ [2-9])(?= |$))",
       "`$1` is not a power in C++: ^ combines the bits of whole numbers. Write x * x or std::pow(x, 2), and 1e-6 for "
       "10^-6."},
      {"discarded_result",
       R"(^(\w+)(?: \. \w+ \( )" + inside + R"(\))*? \. (transpose|normalized|inverse|adjoint|cross|dot|norm|)" +
           R"(squaredNorm|sum|trace|determinant|eval|solve|mean|reverse|asDiagonal|cwise\w+) \( )" + inside +
           R"(\) ;$)",
       "$2() changes nothing: it returns a new value, which is dropped here. Write A = A.$2(...).", nullptr, own_types},
      {"discarded_result",
       R"(^(?:std :: )?(sqrt|pow|abs|fabs|a?sin|a?cos|a?tan|atan2|exp|log|hypot|fmod|round|floor|ceil|min|max) \( )" +
           inside + R"(\) ;$)",
       "$1() changes nothing: it returns a new value, which is dropped here. Write x = $1(...)."},
      {"discarded_result",
       R"(^(?!(?:double|int|float|auto|bool|char|long|unsigned|(?:Row)?Vector\w*|Matrix\w*|return|else|case)\b)(\w+ [-*/+]) [^=\n;{}]* ;$)",
       "What this computes is dropped here: write return before it, or = where it belongs.", nullptr,
       " struct class union using typedef "},
      {"discarded_result", R"(^(\w+) \. (Zero|Identity|Ones) \( [^()]*\) ;$)",
       "$2() makes a new matrix or vector, which is dropped here: `$1.set$2()` changes `$1`.", nullptr, own_types},
      {"aliasing", R"(^(\w+) \. noalias \( \) [+-]?= (?:.* )?\1 (?:.* )?;$)",
       "noalias() writes into `$1` while `$1` is still read on the right: leave it out, or use another variable.",
       nullptr, own_types, Weight::possible, Fix::no_noalias},
      {"aliasing", R"(^(\w+) = \1 \. (reverse) \( \) ;$)",
       "`$1` is overwritten here while it is read: write $1.reverseInPlace()."},
      {"uninitialized_variable",
       R"(^(?:const )?(?:double|int|(?:Eigen :: )?(?:Vector|Matrix)\w+) (\w+) = (?:[^\n,]*[^\s.>:] )?\1\b[^\n]* ;$)",
       "On the right of this = the name `$1` means the new variable already, which has no value yet: choose another "
       "name.",
       nullptr, "", Weight::cause, Fix::none, false},
      {"empty_body", R"(^(?:else )?(for|if) \( )" + inside + R"(\) ;$)",
       "The ; directly after $1 (...) is all that it does: what follows does not belong to it. Leave out this ;"},
      {"empty_body", "^(else) ;$",
       "The ; directly after else is all that it does: what follows does not belong to it."},
      {"empty_body", R"(^(while) \( )" + inside + R"(\) ;$)",
       "The ; directly after $1 (...) is all that it does: what follows does not belong to it. Leave out this ;",
       nullptr, " do "},
      {"other_counter",
       R"(for \( (?:[\w:]+ )?(\w+) = [^;]* ; \1 [^;&|]* ; (?:(?:\+\+|--) (?!\1\b)(\w+)|(?!\1\b)(\w+) (?:\+\+|--)) \))",
       "This loop runs as long as `$1` is small enough, but its head changes `$2$3`."},
      {"wrong_direction",
       R"(for \( (?:int |long )?(\w+) = [^;]* ; \1 (?:<=? [^;]* ; (?:-- \1|\1 --)|>=? [^;]* ; (?:\+\+ \1|\1 \+\+)) \))",
       "This loop counts `$1` away from its end."},
      {"loop_never_runs", R"(for \( (?:[\w:]+ )?(\w+) = (\d{1,9}) ; \1 (>=?) (\d{1,9}) ;)",
       "This loop never runs: `$1` begins at $2, where $1 $3 $4 is false.", is_false_at_first},
      {"always_true", R"((?:[=!]=|[<>]=?) [^ ]+ (\|\| \d[\w.]*)(?= (?:[)|&;?]|\|\|)))",
       "`$1` is always true, whatever stands before it: write the whole comparison again, as in x == 1 || x == 2."},
      {"chained_comparison", R"( (==) (?:(?![&|?:;,()=!<>])[^ \n]+ )+== )",
       "A comparison a == b == c does not compare three numbers in C++; write a == b && b == c."},
      {"comma_operator", R"((?:=|^return) (\( (?:[^(),]|\()" + inside + R"(\))+ , )" + inside + R"(\)) ;$)",
       "Of `$1` only the last value is kept: values in parentheses follow a name, as in Vector2d v(a, b)."},
      {"whole_sum", R"((accumulate|inner_product|reduce) \( )" + inside + R"(, 0 (?:\)|,))",
       "This sum begins with the whole number 0 and drops what follows every decimal point: begin with 0.0."},
      {"divisor", R"((/ 1(?:\.0*)?) [-+] \w)", "`$1` divides by 1, not by what follows: write / (1 + x) for that."},
      {"rounded_pi", R"((?:^| )(3\.14\d*)(?= |$))", "$1 is only near π; write std::numbers::pi.", is_rounded_pi, "",
       Weight::possible, Fix::exact_pi},
      {"bound_below_rounding",
       R"(^while \( (?:[^&|]* )?(?:abs|fabs|norm) \( [^&|]* > (\d[\d.]*e-(?:1[6-9]|[2-9]\d)) \))",
       "`$1` is less than rounding leaves of most differences, so that this loop may never end.", nullptr, "",
       Weight::possible},
      {"semicolon_in_sum", R"((;)\n[-+] [^\n]* ;$)",
       "This ; ends the statement, and the line below it is a statement of its own that is added to nothing."},
      {"kept_expression",
       R"(^(?:const )?auto (\w+) = \w+ \( )" + inside +
           R"(\) \. (?:transpose|col|row|block|head|tail|segment|diagonal|array|matrix)\b[^\n]* ;$)",
       "With auto, `$1` reads from what the function has returned, which is gone after this line: write its type.",
       nullptr, "", Weight::possible, Fix::as_value},
      {"changed_in_statement",
       R"(^(?:(?:for|while|if) [^\n]*\) )?\w+ [\[(] (\w+) [\])] = [^\n]*\b\1 (?:\+\+|--)[^\n]* ;$)",
       "`$1` changes in this statement, and the index before the = is the new one: change it in a statement of its "
       "own.",
       nullptr, "", Weight::possible},
      {"unsigned_difference",
       R"(^for \( (?:std :: )?(?:unsigned|size_t)(?: int| long)? (\w+) = (?:[^\n]*\n)*?[^\n]*(?:\(|=|,) (\d+ - (?:\d+ \* )?\1)(?! \])\b[^\n]*$)",
       "`$2` is never negative but huge, for `$1` has no sign: count with int.", nullptr, "", Weight::possible},
      {"modulo_first", R"([-+] (\d{1,9} % \d{1,9})(?= |$))",
       "`$1` is a number of its own: % binds before + and -. Write (i + 1) % 3 for what is meant."},
      {"size_for_length", R"((?:^| )(\w+) / \1 \. size \( \))",
       "`$1.size()` is the number of components: the length of a vector is `$1.norm()`."},
      {"unused_value",
       R"(^(?:(?:for|if|while) \( )" + inside + R"(\) )?(?!(?:return|for|if|while|switch)\b)[\w.]+(?: \( )" + inside +
           R"(\)| \[ [^\[\]]* \])* (==) [^\n]* ;$)",
       "== compares, and what it finds is not kept: a value is given by =."},
      {"matrix_constructor", R"(^(Vector[234]d|Matrix[234]d) \w+ \( \d[\d.]* \) ;$)",
       "A single number in these parentheses is taken for a size: write $1::Zero() or $1::Constant(number).", nullptr,
       "", Weight::possible},
      {"rows_first", R"((Matrix3Xd) \w+ \( (?!3 ,)[^,]+ , 3 \))",
       "Rows come first, and a $1 has 3 of them: write $1 name(3, n).", nullptr, "", Weight::possible},
      {"unsigned_difference",
       R"(for \( (?:std :: )?(?:unsigned|size_t)(?: int| long)? (\w+) = [^;]* ; \1 <=? ([^;]* - \d+) ;)",
       "`$2` is never negative but huge, for it has no sign: count with int.", nullptr, "", Weight::possible},
      {"one_too_far",
       R"(^for \( [^;\n]*; (\w+) < (\w+) \. (size|cols|rows) \( \) ; (?:\+\+ \1|\1 \+\+) \) (?:\{\n)?(?:(?!if|else)[^\n]*[;{}]\n)*?)"
       R"((?!if|else)[^\n]*\b\2 (?:\. (?:col|row) )?[\[(] \1 (\+ 1) [\])](?! %)[^\n]*$)",
       "In the last turn of the loop, `$1 + 1` is one beyond the end: let it run to $2.$3() - 1 only.", nullptr, "",
       Weight::possible},
      {"one_too_far", R"(^for \( [^;]* = 0 ; \w+ (<=) ([^;]*\. (?:size|cols|rows) \( \)) ;)",
       "This loop runs one too far: the last index is $2 - 1, so write < for <=.", nullptr, "", Weight::possible},
      {"float_precision", R"((?:^| )(float|(?:Matrix|Vector)\w+f)\b)", "A float keeps only about 7 digits; use double.",
       nullptr, "", Weight::possible, Fix::as_double},
      // Several statements.
      {"uninitialized_variable",
       R"(^(Matrix[234]d|Vector[234]d) (\w+) (?:\( \d \) )?;\n(?:(?!(?:if|else|switch|while|do)\b|[^\n]*\b\2\b)[^\n]*\n)*(?:for \( [^\n]*\) )?\2 [-+]= [^\n]*$)",
       "`$2` begins with no value, but is added to below: write $1 $2 = $1::Zero();", nullptr, own_types, Weight::cause,
       Fix::none, false},
      {"uninitialized_variable",
       R"(^(?:double|int|Vector\w+|Matrix\w+) (\w+) ;\nif \( (?:(?!\b\1\b)[^\n])* \) (?:\{\n)?\1 = [^\n]* ;(?:\n\})?\nreturn [^\n]*\b\1\b[^\n]*$)",
       "`$1` has a value only where the condition below it holds: give it one here."},
      {"no_size",
       R"(^(?:const )?(?:Eigen :: |std :: )?(?:(?:Matrix|Vector)\w*X\w*|vector < [^;\n]* >) (\w+) ;\n(?:(?![^\n]*\b\1\b)[^\n]*\n)*(?:for [^\n]*\) )?\1 (?:\(|\[|<<|\. (?:col|row) \() [^\n]*$)",
       "`$1` has no size yet, and so nothing that could be set: give it one in parentheses behind its name.", nullptr,
       "", Weight::possible},
      {"appended",
       R"(^(?:std :: )?vector < [^\n;]* > (\w+) \( \w+ \) ;\n(?:[^\n]*\n)*?[^\n]*\b\1 \. (push_back|emplace_back) \([^\n]*$)",
       "`$1` has elements from its declaration on, and $2() adds behind them: declare it without a size."},
      {"captured_copy",
       R"((\[ (?:=|\w+)[^&\]\n]*\]) \( [^\n]* mutable \{\n(?:[^\n]*\n)*?(?!return)[^\n]* [-+*/]?= [^\n]*$)",
       "$1 gives this lambda copies of its own, and what it changes there is not changed outside: write [&]."},
      {"kept_view",
       R"(^(?:const )?auto (\w+) = ([^\n]*\. (?:col|row|head|tail|segment|block|diagonal)\b[^\n]*) ;\n\2 = [^\n]* ;\n[^\n]* = \1 ;$)",
       "With auto, `$1` is no copy but `$2` itself, which has changed before it is used: write its type."},
      {"semicolon_in_list",
       R"(^\w+(?: \. \w+ \( [^()\n]*\))? << [^\n]* (;)\n(?!(?:\w+ (?::: )?)*[A-Za-z_]\w* [A-Za-z_]\w* |return|[^\n]* (?:=|<<) |[^\n]* > [A-Za-z_]\w* [;({]))"
       R"((?:(?:[^()\n]|\((?:[^()\n]|\([^()\n]*\))*\))* ,|[\d(-]) [^\n]* ;$)",
       "This ; ends the list of <<, although more of it follows: between all numbers stands a comma.", nullptr, "",
       Weight::possible},
      {"shared_counter", R"(^for \( (?:\w+ )?(\w+) = [^;\n]*;[^;\n]*;[^\n]*\) (?:\{\n)?for \( \1 = [^\n]*$)",
       "Both loops count with the same `$1`, so the outer one ends too early or never: the inner one needs another "
       "name."},
      {"left_from_stub",
       R"((?|^[^\n]*[;}]\n(throw) NotStarted \{\n\}\n;$|(throw) NotStarted \{\n\}\n;\n(?!\})[^\n]+$))",
       "This line of the empty exercise is still there: remove it.", nullptr, "", Weight::cause, Fix::none, false},
      {"entrywise_product", R"(\. array \( \) \. (exp) \( \))",
       "array().exp() takes the exponential of each entry: that of a matrix is in unsupported/Eigen/MatrixFunctions, "
       "and a rotation is Eigen::AngleAxisd.",
       nullptr, "", Weight::possible},
      {"printed_value", R"((cout) << [^\n]* ;\nreturn 0(?:\.0*)? ;\n\}$)",
       "What is printed is no result: return it in place of the 0.", nullptr, " if "},
      {"restarted_sum",
       R"(^(?:for|while) \( .* \) \{\n(\w+) (?:= 0(?:\.0*)?|\. setZero \( \)) ;\n\1 [-+]= [^\n]* ;\n\}$)",
       "`$1` begins at 0 again in every turn of the loop: give it this value before the loop."},
      {"last_turn_only",
       R"(for \( (?:[\w:]+ )+?(\w+) = (?:(?! (?:if|while) )[^\n])*\) (?:\{\n(?=(?:(?!if|else|for|while|switch)[^\n]* ;\n)+\}$)(?:[^\n]*\n)*?)?(\w+) = )"
       R"([^\n]*\b\1\b[^\n]* ;(?:(?:\n[^\n]*)*\n\})?$)",
       "`$2` is given a new value in every turn, and only that of the last turn is left: to add up, write +=.",
       is_named_once},
      {"resize_in_loop", R"(^(?:for|while) \( .* \) \{\n(\w+) \. resize \( [^\n]*;$)",
       "resize() drops what `$1` held so far: give it its size once, before the loop."},
  };
  return mistakes;
}

/// while (p < n) { … } @returns does its block, which begins at a token, neither change one of these names nor end the
/// loop?
bool never_changes(std::span<const Token> tokens, std::size_t brace, const std::string& names) {
  int depth = 0;
  for (std::size_t k = brace; k < tokens.size(); ++k) {
    depth += tokens[k].text == "{" ? 1 : tokens[k].text == "}" ? -1 : 0;
    if (depth == 0) return true;
    if (token_is(tokens, k, " break return throw goto exit ")) return false;
    const bool is_argument = token_is(tokens, k - 1, " ( , ") && !(k > 2 && token_is(tokens, k - 3, " . "));
    if (token_is(tokens, k, names) && (is_argument || token_is(tokens, k + 1, " = += -= *= /= ++ -- << . [ ( ") ||
                                       token_is(tokens, k - 1, " ++ -- & >> ")))
      return false;
  }
  return false;
}

/// Vector3d v = a; … v = b; } @returns the token at which a variable is given what its block never reads, or 0
std::size_t never_read(std::span<const Token> tokens, std::size_t declared) {
  int depth = 0;
  for (std::size_t k = declared; k-- > 0;) {  // what hides another variable is told as that
    depth += tokens[k].text == "}" ? 1 : tokens[k].text == "{" ? -1 : 0;
    if (depth <= 0 && tokens[k].text == tokens[declared].text) return 0;
  }
  depth = 0;
  std::size_t statement = 0, last = 0;  // the first token of this one, and of the last that names it
  for (std::size_t k = declared; k < tokens.size() && depth >= 0; ++k) {
    depth += tokens[k].text == "{" ? 1 : tokens[k].text == "}" ? -1 : 0;
    if (token_is(tokens, k - 1, " ; { } ")) statement = k;
    const bool is_lambda = tokens[k].text == "[" && token_is(tokens, k + 1, " = ");
    const bool is_captured =
        tokens[k].text == tokens[declared].text && token_is(tokens, k - 1, " [ ") && token_is(tokens, k - 2, " = ( , ");
    if (tokens[k].text == "&" || is_lambda || is_captured) return 0;  // another name of it, or what sees it
    if (tokens[k].text == tokens[declared].text) last = depth == 0 ? statement : 0;
  }
  const bool is_given = tokens[last].text == tokens[declared].text && token_is(tokens, last + 1, " = += -= *= /= ");
  return last > declared && is_given ? last : 0;
}

/// void turn(Vector3d L) { … L[0] = c; } @returns is a parameter, which is a copy, given what is read nowhere?
bool changes_copy(const SourceText& source, std::size_t brace, std::string_view parameter) {
  const std::vector<Token>& tokens = source.tokens();
  std::size_t last = 0;  // the statement that gives it a value, if nothing is read behind it
  bool is_read = false;
  const std::size_t end = source.partner_of(brace);
  for (std::size_t k = brace + 1, statement = k; k < end; ++k) {
    const bool is_word = std::isalpha(static_cast<unsigned char>(tokens[k].text[0])) != 0;
    if (token_is(tokens, k - 1, " ; { } ") || (token_is(tokens, k - 1, " ) ") && is_word)) statement = k;
    if (tokens[k].text != parameter || token_is(tokens, k - 1, " . :: -> ")) continue;
    if (token_is(tokens, source.opening_around(k) - 1, " swap ")) {
      last = statement;
      continue;
    }
    std::size_t sign = k + 1;  // behind L, L[0] or L.row(0)
    while (sign < end && !token_is(tokens, sign, " = += -= *= /= << ; { } ) ] ")) sign = source.partner_of(sign) + 1;
    if (k == statement && token_is(tokens, sign, " = += -= *= /= << ")) {
      last = statement;
    } else if (statement != last) {
      last = 0;
      is_read = true;
    }
  }
  return last > 0 && (source.opening_around(last) == brace || !is_read);
}

/// @returns the names of such parameters of a function that returns nothing, whose body begins at a token
std::vector<std::size_t> changed_copies(const SourceText& source, std::size_t brace) {
  const std::vector<Token>& tokens = source.tokens();
  std::vector<std::size_t> names;
  if (brace < 5 || tokens[brace].text != "{") return names;
  const std::size_t close = tokens[brace - 1].text == "const" ? brace - 2 : brace - 1;
  const std::size_t open = tokens[close].text == ")" ? source.partner_of(close) : 0;
  const bool is_function = open > 2 && (token_is(tokens, open - 1, " ] ") || token_is(tokens, open - 2, " void ") ||
                                        token_is(tokens, open - 3, " operator "));
  for (std::size_t k = brace; k < source.partner_of(brace); ++k)
    if (!is_function || (tokens[k].text == "return" && tokens[k + 1].text != ";")) return names;
  for (std::size_t k = open + 1; k < brace; ++k)
    if (token_is(tokens, k + 1, " , ) ") && source.opening_around(k) == open &&
        search(tokens[k - 1].text, "^([A-Za-z_]\\w*|>)$") && changes_copy(source, brace, tokens[k].text))
      names.push_back(k);
  return names;
}

/// Is this the { of a loop?
bool opens_loop(const SourceText& source, std::size_t brace) {
  if (brace == 0 || source.tokens()[brace].text != "{" || source.tokens()[brace - 1].text != ")") return false;
  const std::size_t head = source.partner_of(brace - 1);
  return head > 0 && token_is(source.tokens(), head - 1, " for while ");
}

/// for (…) { … return x; } @returns does the return always end the loop in its first turn?
bool ends_loop_at_once(const SourceText& source, std::size_t returns) {
  const std::size_t brace = source.opening_around(returns);
  return opens_loop(source, brace) &&
         !has_one_of(std::span(source.tokens()).subspan(brace, returns - brace), " continue break switch do case ");
}

/// for (…) { double s = 0; … s += x; … } @returns has the sum a single term, which is added once in each turn?
bool is_sum_of_one_term(const SourceText& source, std::size_t declared) {
  const std::vector<Token>& tokens = source.tokens();
  if (!opens_loop(source, source.opening_around(declared))) return false;
  bool has_term = false;
  int depth = 0;
  for (std::size_t k = declared + 1; k < tokens.size() && depth >= 0; ++k) {
    depth += tokens[k].text == "{" ? 1 : tokens[k].text == "}" ? -1 : 0;
    if (tokens[k].text != tokens[declared].text || !token_is(tokens, k + 1, " = += -= *= /= [ ( . ")) continue;
    if (has_term || depth > 0 || !token_is(tokens, k + 1, " += ") || !token_is(tokens, k - 1, " ; } ")) return false;
    has_term = true;
  }
  return has_term;
}

/// double w[3]; … w[3] @returns the token with an index that the array does not have, or 0; in its block, as long as
/// nothing else there is called like it
std::size_t index_beyond(std::span<const Token> tokens, std::size_t declared, long size) {
  int depth = 0;
  for (std::size_t k = declared + 1; k + 3 < tokens.size() && depth >= 0; ++k) {
    depth += tokens[k].text == "{" ? 1 : tokens[k].text == "}" ? -1 : 0;
    if (tokens[k].text != tokens[declared].text) continue;
    if (search(tokens[k - 1].text, R"(^(?:(?!return)[A-Za-z_]\w*|[&>])$)")) return 0;
    if (tokens[k + 1].text != "[" || tokens[k + 3].text != "]") continue;
    if (search(tokens[k + 2].text, R"(^\d{1,9}$)") && std::stol(std::string(tokens[k + 2].text)) >= size) return k + 2;
  }
  return 0;
}

/// double twice(double x) { … twice(y); @returns which functions of the file give a value and change no argument
std::string value_functions(std::span<const Statement> statements) {
  std::string names;
  for (const Statement& statement : statements)
    if (const Match head = search(
            statement.text, R"(^(?:static |inline )*(?:double|int|bool|(?:Eigen :: )?(?:Matrix|Vector)\w+) (\w+) )"
                            R"(\( (?:(?:const [^,()]+|[^,&*()]+)(?:, |\)))+ \{$)"))
      names += " " + head[1] + " ";
  return names;
}

/// static double s = 0; … s += x; @returns does it keep what calls before have left
bool accumulates(std::span<const Token> tokens, std::size_t declared) {
  for (std::size_t k = declared + 1; k < std::min(tokens.size(), declared + 1000); ++k)
    if (tokens[k].text == tokens[declared].text && !search(tokens[k - 1].text, "^(?!else$|do$)[A-Za-z_&>*]") &&
        (token_is(tokens, k + 1, " = += -= *= /= ++ -- << ") || token_is(tokens, k - 1, " ++ -- ")))
      return true;
  return false;
}

}  // namespace

std::vector<Reason> text_mistakes(const SourceText& source) {
  constexpr std::size_t most = 20, most_joined = 6;
  const std::span tokens(source.tokens().data(), std::min(source.tokens().size(), most_tokens));
  std::vector<const TextMistake*> possible;
  for (const TextMistake& mistake : table())
    if (!has_one_of(tokens, mistake.unless)) possible.push_back(&mistake);
  std::vector<Reason> found;
  const auto add = [&](std::size_t token, const char* name, Match match, const char* sentence,
                       Weight weight = Weight::cause, Fix fix = Fix::none, bool needs_failure = true) {
    for (std::string& group : match.groups) boost::erase_all(group, " ");
    found.push_back(source.reason(source.place_of(tokens[token].offset), name, match.fill(sentence), weight, fix));
    found.back().needs_failure = needs_failure;
  };
  std::string arguments = " ";  // of all functions, and local variables
  int depth = 0;                // of braces that no namespace opens
  const std::vector<Statement> statements = statements_of(tokens);
  const std::string values_of = value_functions(statements);
  for (std::size_t last = 0; last < statements.size(); ++last) {
    const Statement& statement = statements[last];
    if (statement.text.size() > longest_statement || found.size() > most) continue;
    std::vector<Statement> parts;  // this one alone, and with those before it
    for (std::size_t count = 1; count <= std::min(most_joined, last + 1); ++count) {
      parts.push_back(joined(std::span(statements).subspan(last + 1 - count, count)));
      if (parts.back().text.size() > longest_statement) break;
    }
    std::ranges::reverse(parts);
    for (const TextMistake* mistake : possible) {
      const bool is_of_many = mistake->pattern.find("\\n") != std::string::npos;
      for (const Statement& part : is_of_many ? std::span(parts) : std::span(parts).last(1)) {
        const Match match = part.text.size() > longest_statement ? Match() : search(part.text, mistake->pattern);
        if (!match || (mistake->holds != nullptr && !mistake->holds(match))) continue;
        add(part.token_at(match.offsets[1]), mistake->name, match, mistake->sentence, mistake->weight, mistake->fix,
            mistake->needs_failure);
        break;
      }
    }
    const bool is_outside = depth == 0;
    if (is_outside && statement.text.ends_with(") {"))
      for (const Match& argument : search_all(statement.text, R"([\w&*>] (\w+) (?=[,)]))"))
        arguments += argument[1] + " ";
    if (statement.text.ends_with("{") && !statement.text.starts_with("namespace")) ++depth;
    if (statement.text.ends_with("}") && depth > 0) --depth;
    const Match waiting = search(statement.text, R"(^while \( ((?:[^&|=]|[<>!]=|==)*) \) [{;]$)");
    if (waiting && !search(waiting[1], R"(\( \)|\+\+|--)")) {
      const std::size_t end = statement.tokens.back(), head = statement.tokens.front();
      const std::size_t block = head > 0 && tokens[head - 1].text == "}" ? source.partner_of(head - 1) : 0;  // of a do
      const bool is_do = block > 0 && tokens[block - 1].text == "do";
      const std::size_t brace = tokens[end].text == "{" ? end : is_do ? block : 0;
      std::string names = " ";
      for (const Match& word : search_all(waiting[1], "[A-Za-z_]\\w*")) names += word[0] + " ";
      const Match first = search(names, "^ (?!true )(\\w+)");
      if (brace > 0 && never_changes(tokens, brace, names))
        add(first ? statement.token_at(waiting.offsets[1]) : head, "endless_loop", first,
            first ? "Nothing in this loop changes `$1`, so it never ends." : "Nothing ends this loop.",
            Weight::possible);
    }
    if (statement.text.starts_with("return ") && ends_loop_at_once(source, statement.tokens.front()))
      add(statement.tokens.front(), "return_in_loop", {},
          "This return ends the loop in its first turn: it belongs after the } of the loop.");
    if (const Match sum = search(statement.text, R"(^double (\w+) = 0(?:\.0*)? ;$)"))
      if (is_sum_of_one_term(source, statement.token_at(sum.offsets[1])))
        add(statement.tokens.front(), "restarted_sum", sum,
            "`$1` begins at 0 again in every turn of the loop: give it this value before the loop.", Weight::possible);
    const Match local =
        search(statement.text, R"(^(?:double|int|(?:Eigen :: )?(?:Vector|Matrix)\w+) (\w+) (?:=|;|\())");
    if (local && !is_outside)
      if (const std::size_t given = never_read(tokens, statement.token_at(local.offsets[1])); given > 0)
        add(given, "never_read", local, "What `$1` is given here is read nowhere: it is a variable of its own.",
            Weight::possible);
    if (const Match call =
            search(statement.text, R"(^(?:(?:else )?(?:if|while) \( (?:[^()]|\([^()]*\))* \) |else )?(\w+) \( .* ;$)");
        call && values_of.find(" " + call[1] + " ") != std::string::npos)
      add(statement.tokens.front(), "discarded_result", call,
          "`$1` hands its result back, which is dropped here: write x = $1(...).",
          has_one_of(tokens, " cout cerr printf static ") ? Weight::possible : Weight::cause);
    const Match kept = search(statement.text, R"(^(static )?(?:[\w:<>]+ )+?(\w+) (?:;|=|\(|\{))");
    const bool is_set_once = !is_outside && (search(statement.text, R"(^static (?!const|auto)[^=]* (?:=|\{|\() )") ||
                                             (search(statement.text, R"(^static const [\w:<> ]* (?:=|\(|\{) )") &&
                                              names_one_of(statement.text, arguments)));
    if (!is_outside &&
        search(statement.text, R"(^(?:const )?(?:double|auto|(?:Eigen :: )?(?:Vector|Matrix)\w+) \w+ =)"))
      for (const Match& variable : search_all(statement.text, R"([\w,] (\w+) =(?!=))")) arguments += variable[1] + " ";
    const bool is_kept = is_outside || (kept && !kept[1].empty());
    if (kept && is_kept && (is_set_once || accumulates(tokens, statement.token_at(kept.offsets[2]))))
      add(statement.tokens.front(), "static_variable", kept,
          is_outside
              ? "`$2` keeps its value from one call to the next, and results depend on earlier ones: define it in "
                "the function."
              : "`$2` keeps its value from one call to the next, and results depend on earlier ones: leave "
                "`static` out.",
          Weight::possible, Fix::not_static);
    if (const Match given = search(statement.text, R"((?:^|\) )(\w+(?: [.\[(][^=]*)?) (=) ([-+]) )")) {
      const std::size_t at = statement.token_at(given.offsets[2]);
      const auto follows = [&](std::size_t k) {
        return tokens[k].offset == tokens[k - 1].offset + tokens[k - 1].text.size();
      };
      if (follows(at + 1) && !follows(at + 2))
        add(at, given[3] == "-" ? "unary_minus" : "unary_plus", given,
            "=$3 only assigns; what changes a variable by what follows is $3=.", Weight::possible, Fix::compound);
    }
    for (const std::size_t name : changed_copies(source, statement.tokens.empty() ? 0 : statement.tokens.back()))
      add(name, "changed_copy", search(tokens[name].text, "(.+)"),
          "`$1` is a copy of what the function is called with, and nothing is returned: write & behind its type.",
          Weight::cause, Fix::by_reference);
    for (const std::size_t k : statement.tokens) {
      const std::string_view token = tokens[k].text;
      if (token.size() == 3 && token[0] == '\'' && token[1] >= '0' && token[1] <= '9')
        add(k, "character", {},
            "A digit in quotation marks is a character, and counts as another number ('0' as 48): leave them out.",
            has_one_of(tokens, " cout cerr printf ") ? Weight::possible : Weight::cause);
    }
    const Match array =
        search(statement.text, R"(^(?:const )?(?:double|int|float|Vector\w+|Matrix\w+) (\w+) \[ (\d{1,9}) \])");
    if (array)
      if (const std::size_t index = index_beyond(tokens, statement.token_at(array.offsets[1]), std::stol(array[2]));
          index > 0)
        add(index, "index_out_of_range", array, "`$1` has $2 elements, and indices start at 0: this one is not there.",
            Weight::cause, Fix::none, false);
  }
  constexpr const char* list_of_bases =
      R"(\b(?:struct|class)\s+(\w+)\b[^]*?\b(?:struct|class)\s+\w+(?:\s+final)?\s*:\s*(?:public\s+)?\1\b[^]*?\b(?:vector|array|deque|list)\s*<\s*(\1)\s*[,>])";
  if (has_one_of(tokens, " virtual "))
    if (const Match list = search(source.text(), list_of_bases))
      found.push_back(
          source.reason(source.place_of(list.offsets[2]), "sliced_object",
                        list.fill("A list of `$2` keeps of each object only the part that is a `$2`, with the "
                                  "functions of `$2`: take a list of std::unique_ptr<$2>."),
                        Weight::cause));
  return found;
}

}  // namespace workbook
