#include "checker/compile/compile_mistakes.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/code_text.hpp"
#include "checker/compile/eigen_type.hpp"
#include "checker/compile/plain_words.hpp"
#include "checker/messages/compiling.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <regex>
#include <utility>

namespace workbook {
namespace {

using messages::Operand;

/// std::regex recurses over the length of its text; nothing that a person says is longer.
constexpr std::size_t longest_for_patterns = 1500;

std::string clipped(std::string text) {
  if (text.size() > longest_for_patterns) text.resize(longest_for_patterns);
  return text;
}

/// An error and all that may explain it.
struct Situation {
  const Diagnostic& error;
  std::string message;             ///< in plain words
  std::string code;                ///< the student's line without comments
  std::string before, after;       ///< that line, up to the caret and from it
  std::string raw;                 ///< the line as it stands there
  std::vector<std::string> notes;  ///< in plain words
  const std::string& signature;
  std::smatch found;  ///< what the pattern matched in the message

  std::string part(std::size_t i) const { return found[i].str(); }
};

bool matches(const std::string& text, const char* pattern) { return std::regex_search(text, std::regex(pattern)); }

// --- sizes, which Eigen reports by the names of static assertions

/// The type that stands for a template parameter in the context: "Lhs" in "[with Lhs = …; Rhs = …]".
std::optional<TypeName> template_argument(const Situation& at, const std::string& function,
                                          const std::string& parameter) {
  for (const std::string& line : at.error.context) {
    if (line.find(function) == std::string::npos) continue;
    for (const char* lead : {"; ", "; int ", "[with "}) {
      const std::string mark = lead + parameter + " = ";
      const std::size_t begin = line.find(mark);
      if (begin == std::string::npos) continue;
      const std::size_t from = begin + mark.size();
      const std::size_t end = line.find_first_of(";]", from);
      return read_type(std::string_view(line).substr(from, end == std::string::npos ? end : end - from));
    }
  }
  return std::nullopt;
}

std::string sign_of(const TypeName& operation) {
  if (operation.name == "internal::scalar_sum_op") return "+";
  if (operation.name == "internal::scalar_difference_op") return "-";
  if (operation.name.find("add_assign_op") != std::string::npos) return "+=";
  if (operation.name.find("sub_assign_op") != std::string::npos) return "-=";
  return {};
}

std::string sizes_of_operation(const std::string& operation, const TypeName& left, const TypeName& right) {
  const auto left_shape = shape_of(left);
  const auto right_shape = shape_of(right);
  if (!left_shape || !right_shape) return messages::different_sizes();
  const bool flipped = *left_shape == right_shape->transposed() && std::min(left_shape->rows, left_shape->columns) == 1;
  if (flipped) return messages::row_and_column(operation, noun_for(left), noun_for(right));
  return messages::different_sizes(operation, noun_for(left), noun_for(right));
}

std::string mixed_sizes(const Situation& at) {
  const char* const operation = "CwiseBinaryOp<BinaryOp, Lhs, Rhs>::CwiseBinaryOp";
  const auto left = template_argument(at, operation, "Lhs");
  const auto right = template_argument(at, operation, "Rhs");
  if (left && right) {
    const std::string sign = sign_of(template_argument(at, operation, "BinaryOp").value_or(TypeName{}));
    return sizes_of_operation(sign, *left, *right);
  }
  const auto target = template_argument(at, "call_assignment_no_alias", "Dst");
  const auto source = template_argument(at, "call_assignment_no_alias", "Src");
  if (!target || !source || !shape_of(*target) || !shape_of(*source)) return messages::different_sizes();
  const std::string sign = sign_of(template_argument(at, "call_assignment_no_alias", "Func").value_or(TypeName{}));
  if (!sign.empty()) return sizes_of_operation(sign, *target, *source);
  return messages::does_not_fit_into(noun_for(*source), noun_for(*target));
}

std::string product_sizes(const Situation& at) {
  const auto left = template_argument(at, "operator*", "Derived");
  const auto right = template_argument(at, "operator*", "OtherDerived");
  if (!left || !right || !shape_of(*left) || !shape_of(*right)) return messages::product_of_wrong_sizes();
  return messages::product_of_wrong_sizes(noun_for(*left), shape_of(*left)->columns, noun_for(*right),
                                          shape_of(*right)->rows);
}

/// The matrix type whose constructor was called.
std::string constructed(const Situation& at) {
  if (const auto type = template_argument(at, "PlainObjectBase", "Derived")) return short_name(*type);
  const auto rows = template_argument(at, "::Matrix(", "_Rows");
  const auto columns = template_argument(at, "::Matrix(", "_Cols");
  if (!rows || !columns) return {};
  return short_name(read_type("Eigen::Matrix<double, " + rows->name + ", " + columns->name + ">"));
}

std::string specific_size(const Situation& at) {
  if (at.error.header.ends_with("OrthoMethods.h")) return messages::cross_needs_three();
  const std::string type = constructed(at);
  if (type.empty()) return {};
  return type.starts_with("Matrix") ? messages::numbers_in_matrix_constructor()
                                    : messages::wrong_count_of_numbers(type);
}

std::string whole_number_expected(const Situation& at) {
  const std::string type = constructed(at);
  if (type.empty()) return {};
  return type.find('X') == std::string::npos ? messages::wrong_count_of_numbers(type) : messages::size_not_whole();
}

std::string vector_method(const Situation& at) {
  if (at.error.header.ends_with("PlainObjectBase.h"))
    if (const std::string type = constructed(at); !type.empty()) return messages::number_as_matrix(type);
  if (at.error.header.ends_with("Dot.h")) return messages::dot_needs_vectors();
  return messages::vector_method_on_matrix();
}

/// Eigen's own words, read aloud: YOU_MIXED_VECTORS_OF_DIFFERENT_SIZES.
std::string advice_of_eigen(const Situation& at) {
  std::string words = at.part(1);
  for (char& letter : words)
    letter = letter == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return messages::eigen_says(words);
}

// --- operators and conversions

/// The type of an operand as plain words have it: "const 3×1 part" is the type of such a matrix.
TypeName type_of(std::string words) {
  words = std::regex_replace(words, std::regex("^const |&+$"), "");
  static const std::regex piece("^(\\d+|n)×(\\d+|n) (" + messages::part_noun() + "|" + messages::expression_noun() +
                                ")$");
  std::smatch sizes;
  if (!std::regex_match(words, sizes, piece)) return read_type(words);
  const auto size = [&](std::size_t i) { return sizes[i] == "n" ? std::string("-1") : sizes[i].str(); };
  return read_type("Eigen::Matrix<double, " + size(1) + ", " + size(2) + ">");
}

std::string noun(const std::string& type) { return noun_for(type_of(type)); }

bool is_one_number(const std::string& type) { return is_number(type_of(type)); }

bool is_matrix(const std::string& type) { return !is_one_number(type) && shape_of(type_of(type)).has_value(); }

std::string assignment_of_number(const Situation& at, const std::string& target) {
  if (!is_matrix(target)) return {};
  if (matches(at.code, "=[^;=]*,")) return messages::list_needs_shift();
  const std::string type = std::regex_replace(target, std::regex("^const "), "");
  return short_name(read_type(type)).empty() ? messages::number_and_vector_mixed(noun(target), messages::number_noun())
                                             : messages::number_assigned_to_matrix(type);
}

bool is_list(const std::string& type) {
  return matches(type, "^(const )?std::(vector|array)<|^double( \\(&\\))? ?\\[|^double\\*$");
}

/// "cannot convert 'A' to 'B' in return"
std::string conversion(const Situation& at, const std::string& from, const std::string& to) {
  const std::string given = noun(from);
  const std::string wanted = noun(to);
  if (is_list(from) && is_matrix(to)) return messages::standard_vector_is_no_vector();
  if (given.empty() || wanted.empty() || given == wanted) return {};
  if (shape_of(type_of(from)) == Shape{1, 1} && is_one_number(to)) return messages::one_by_one_matrix();
  if (is_one_number(from) && matches(at.code, "=[^;=]*,") && !matches(at.code, "\\breturn\\b"))
    return messages::list_needs_shift();
  const bool is_returned = at.message.ends_with("in return") || matches(at.code, "^[^;]*\\breturn\\b[^;]*;[^;]*$");
  return is_returned ? messages::returns_wrong_kind(wanted, given) : messages::number_and_vector_mixed(wanted, given);
}

/// The variable left of the = in the statement at the caret.
std::string assigned_name(const Situation& at) {
  static const std::regex target("^\\s*(\\w+)(?:\\.\\w+\\([^()]*\\))*\\s*(?:=|\\+=|-=|\\*=|/=|<<)");
  const std::size_t begin = at.before.find_last_of(";{}");
  const std::string statement = (begin == std::string::npos ? at.before : at.before.substr(begin + 1)) + at.after;
  std::smatch name;
  return std::regex_search(statement, name, target) ? name[1].str() : std::string();
}

/// "no match for 'operator+' (operand types are 'A' and 'B')"
std::string operands(const Situation& at) {
  const std::string sign = at.part(1);
  const std::string left = at.part(2);
  const std::string right = at.part(3);
  const std::string constant = "^const (\\w*(Vector|Matrix)\\w+|[\\dn]+×[\\dn]+ " + messages::part_noun() + ")$";
  const bool assigns = sign == "=" || sign == "+=" || sign == "-=" || sign == "*=" || sign == "/=" || sign == "<<";
  if (assigns && matches(left, constant.c_str())) {
    return messages::changes_constant(assigned_name(at));
  }
  const std::string named_only = "<unresolved overloaded function type>";
  if (left == named_only || right == named_only) return messages::call_without_parentheses();
  if (is_list(left) || is_list(right))
    if (std::string("+-*/=").find(sign) != std::string::npos) return messages::standard_vector_is_no_vector();
  const std::string left_noun = noun(left);
  const std::string right_noun = noun(right);
  if (sign == "^" && !left_noun.empty()) return messages::power_sign("^");
  if (left_noun.empty() || right_noun.empty()) return {};
  if (sign == "=" && is_one_number(right)) return assignment_of_number(at, left);
  const bool one_is_number = is_one_number(left) != is_one_number(right);
  if ((sign == "+" || sign == "-" || sign == "+=" || sign == "-=") && one_is_number)
    return messages::number_plus_matrix(sign);
  if (matches(sign, "^[<>]=?$")) return messages::order_of_vectors();
  if ((sign == "/" || sign == "/=") && !is_one_number(right)) return messages::division_by_vector(right_noun);
  const bool with_array = left.find("array") != std::string::npos || at.raw.find(".array()") != std::string::npos;
  if (with_array && std::string("+-*").find(sign) != std::string::npos) return messages::array_and_matrix();
  return {};
}

std::string read_only(const Situation& at) {
  std::smatch name;
  const std::string what = at.part(2);
  if (std::regex_search(what, name, std::regex("\\(& ?(\\w+)\\)"))) return messages::changes_constant(name[1]);
  if (std::regex_match(what, std::regex("\\w+"))) return messages::changes_constant(what);
  return messages::changes_constant("");
}

/// "passing 'const Matrix3d' as 'this' argument discards qualifiers"
std::string method_of_constant(const Situation& at) {
  std::smatch name;
  const bool named = std::regex_search(at.before, name, std::regex("(\\w+)\\.\\w+\\s*$"));
  return messages::changes_constant(named ? name[1].str() : "");
}

// --- names

bool one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// "'x' was not declared in this scope; did you mean 'y'?"
std::string undeclared(const Situation& at) {
  const std::string name = at.part(1);
  const std::string suggestion = at.part(3);
  if (one_of(name, {"pi", "PI", "Pi", "M_PI", "M_Pi", "π", "pi_v"})) return messages::undeclared_pi();
  if (matches(name, "^(a?(sin|cos|tan)d)$")) return messages::degrees_function(name);
  if (one_of(name, {"Vector2d", "Vector3d", "VectorXd", "Matrix3d", "Matrix3Xd", "NotStarted"}))
    return messages::undeclared_outside_namespace(name);
  if (one_of(name, {"cross", "dot", "norm", "transpose", "inverse", "trace", "determinant", "squaredNorm", "normalized",
                    "normalize", "cwiseProduct", "diagonal", "asDiagonal"}))
    return messages::method_as_function(name);
  if (one_of(name, {"True", "TRUE"})) return messages::python_word(name, "true");
  if (one_of(name, {"False", "FALSE"})) return messages::python_word(name, "false");
  if (one_of(name, {"None", "null", "nil"})) return messages::python_word(name, "nullptr");
  if (one_of(name, {"retrun", "retun", "reutrn", "retrn", "retur", "Return", "RETURN"}))
    return messages::python_word(name, "return");
  if (name == "elif") return messages::python_word(name, "else if");
  if (one_of(name, {"vector",  "array", "string",     "cout",     "cerr",           "endl",          "max",
                    "min",     "map",   "accumulate", "clamp",    "swap",           "sort",          "numbers",
                    "complex", "pair",  "tuple",      "function", "numeric_limits", "runtime_error", "invalid_argument",
                    "move"}))
    return messages::missing_prefix(name, "std::" + name);
  if (suggestion == "std::" + name || suggestion == "Eigen::" + name) return messages::missing_prefix(name, suggestion);
  for (const std::string& note : at.error.notes)
    if (note.find("'Eigen::" + name) != std::string::npos) return messages::missing_prefix(name, "Eigen::" + name);
  // Plain words say "RowVector3d" for "Eigen::RowVector3d".
  if (suggestion == name) return messages::missing_prefix(name, "Eigen::" + name);
  if (name == "cmath" || matches(at.code, "^\\s*include\\s*[<\"]")) return messages::include_without_hash();
  if (!suggestion.empty()) return messages::did_you_mean(name, suggestion);
  return messages::undeclared(name);
}

/// "'set' is not a member of 'std'", with the compiler's advice on headers in a note
std::string not_a_member(const Situation& at) {
  if (at.part(1) == "pi") return messages::undeclared_pi();
  const std::string full_name = at.part(2) + "::" + at.part(1);
  for (const std::string& note : at.notes) {
    std::smatch header;
    if (std::regex_search(note, header, std::regex("forget to '#include (<[\\w./]+>)'")))
      return messages::missing_include(full_name, header[1]);
  }
  const std::string suggestion = at.part(4);
  if (suggestion.empty()) return {};
  const bool has_namespace = suggestion.find("::") != std::string::npos;
  return messages::did_you_mean(full_name, has_namespace ? suggestion : at.part(2) + "::" + suggestion);
}

std::string no_member(const Situation& at) {
  static const std::pair<const char*, const char*> known[] = {{"length", "norm"},
                                                              {"magnitude", "norm"},
                                                              {"abs", "norm"},
                                                              {"len", "size"},
                                                              {"column", "col"},
                                                              {"transposed", "transpose"},
                                                              {"T", "transpose"},
                                                              {"t", "transpose"},
                                                              {"det", "determinant"},
                                                              {"inv", "inverse"},
                                                              {"invert", "inverse"},
                                                              {"unit", "normalized"},
                                                              {"normalised", "normalized"},
                                                              {"normal", "normalized"},
                                                              {"tr", "trace"},
                                                              {"diag", "diagonal"},
                                                              {"identity", "Identity"},
                                                              {"zero", "setZero"},
                                                              {"norm2", "squaredNorm"},
                                                              {"vec", "cross"}};
  std::string suggestion = at.part(4);
  for (const auto& [wrong, right] : known)
    if (is_matrix(at.part(1)) && at.part(2) == wrong) suggestion = right;
  std::string type = std::regex_replace(at.part(1), std::regex("^const "), "");
  if (std::string what = noun(type); !what.empty() && short_name(read_type(type)).empty()) type = what;
  return messages::no_such_member(type, at.part(2), suggestion);
}

/// The name of the function in "double twice(double x)".
std::string function_in(const std::string& signature) {
  std::smatch name;
  return std::regex_search(signature, name, std::regex("(\\w+)\\s*\\(")) ? name[1].str() : std::string();
}

std::string result_type(const Situation& at) {
  return messages::other_result_type(at.part(1) == function_in(at.signature) ? at.signature : "");
}

std::string parameters(const Situation& at) { return messages::other_parameters(at.part(1), at.signature); }

// --- punctuation

bool ends_there(const std::string& rest) { return matches(rest, "^\\s*$"); }

/// "expected ';' before 'x'", where the caret stands behind what comes before
std::string semicolon(const Situation& at) {
  const std::string token = at.found.size() > 2 ? at.part(2) : at.part(1);
  if (token == ")") return messages::surplus_parenthesis();
  if (matches(token, "·|×|−|–|—|“|”|‘|’")) return messages::foreign_character();
  if (matches(at.code, "\\b(if|for|while)\\s+[^(\\s]")) return messages::condition_without_parentheses();
  if (ends_there(at.after) || token == "}") return messages::missing_semicolon();
  return messages::something_missing_before(token);
}

std::string called_value(const Situation& at) { return messages::call_of_value(at.part(1)); }

std::string function_of_vector(const Situation& at) {
  const std::string function = at.part(1);
  const std::string given = std::regex_replace(at.part(2), std::regex("&+$"), "");
  if (!is_matrix(given)) return {};
  if (function == "inverse") return messages::method_as_function(function);
  return messages::function_of_vector(function, noun(given));
}

std::string member_call(const Situation& at) {
  if (!is_one_number(std::regex_replace(at.part(3), std::regex("&+$"), ""))) return {};
  return messages::method_needs_vector(at.part(2));
}

std::string header_missing(const Situation& at) { return messages::no_such_header(at.part(1)); }

using Sentence = std::function<std::string(const Situation&)>;

/// A sentence that does not depend on the error.
Sentence say(std::string (*text)()) {
  return [text](const Situation&) { return text(); };
}

/// A sentence about what the pattern matched.
Sentence say(std::string (*text)(Operand), std::size_t part) {
  return [text, part](const Situation& at) { return text(at.part(part)); };
}

/// The mistake that makes the compiler print a message. The first that fits counts; one whose sentence is empty does
/// not fit after all.
struct Mistake {
  std::regex message;
  const char* code;  ///< a pattern that the student's line must match as well, or nullptr
  Sentence sentence;
};

const std::vector<Mistake>& mistakes() {
  using namespace messages;
  const auto on = [](const char* pattern) { return std::regex(pattern); };
  static const std::vector<Mistake> table = {
      // Sizes.
      {on("YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES"), nullptr, mixed_sizes},
      {on("YOU_MIXED_VECTORS_OF_DIFFERENT_SIZES"), nullptr,
       [](const Situation& at) {
         return at.error.header.ends_with("Dot.h") ? dot_needs_vectors() : messages::different_sizes();
       }},
      {on("INVALID_MATRIX_PRODUCT$"), nullptr, product_sizes},
      {on("INVALID_VECTOR_VECTOR_PRODUCT"), nullptr, say(product_of_two_vectors)},
      {on("THIS_METHOD_IS_ONLY_FOR_VECTORS_OF_A_SPECIFIC_SIZE"), nullptr, specific_size},
      {on("FLOATING_POINT_ARGUMENT_PASSED__INTEGER_WAS_EXPECTED"), nullptr, whole_number_expected},
      {on("YOU_TRIED_CALLING_A_VECTOR_METHOD_ON_A_MATRIX"), nullptr, vector_method},
      {on("THE_BRACKET_OPERATOR_IS_ONLY_FOR_VECTORS"), nullptr, say(brackets_on_matrix)},
      {on("static assertion failed: ([A-Z][A-Z_]{8,}[A-Z])$"), nullptr, advice_of_eigen},

      // Characters, comments, includes.
      {on("extended character|stray '|'(·|×|−|–|—|“|”|‘|’)[^' ]*' was not declared"), nullptr, say(foreign_character)},
      {on("unterminated comment"), nullptr, say(messages::unterminated_comment)},
      {on("missing terminating ' character"), "\\w'", say(apostrophe_for_transpose)},
      {on("missing terminating "), nullptr, say(unterminated_text)},
      {on("^([^ ]+): No such file or directory"), nullptr, header_missing},
      {on("."), "^\\s*include\\s*[<\"]", say(include_without_hash)},

      // Brackets and calls.
      {on("^invalid types '.*' for array subscript"), "\\]\\s*\\[", say(brackets_on_matrix)},
      {on("^invalid types '(double|int|float)\\["), nullptr, say(brackets_on_number)},
      {on("^'(\\w+)' cannot be used as a function"), nullptr, called_value},
      {on("^expression cannot be used as a function"), "\\b(sin|cos|tan)\\s*\\^",
       [](const Situation&) { return power_sign("^"); }},
      {on("^expression cannot be used as a function()"), nullptr, called_value},
      {on("unable to find numeric literal operator 'operator\"\"[A-Za-z_]"), nullptr, say(number_before_name)},
      {on("invalid operands of types '.*' and '.*' to binary 'operator\\^'"), nullptr,
       [](const Situation&) { return power_sign("^"); }},
      {on("invalid type argument of unary '\\*'"), "\\*\\s*\\*", [](const Situation&) { return power_sign("**"); }},
      {on("invalid operands of types '.*double.*' to binary 'operator%'"), nullptr, say(modulo_of_double)},
      {on("unresolved overloaded function type.* to (binary|non-scalar)|did you forget the '\\(\\)'|cannot resolve "
          "overloaded function|cannot convert '.*' from type '.*\\(.*::\\)\\(\\)|cannot convert '\\w+ "
          "\\(\\*\\)\\(.*\\).*' to|to binary 'operator.' .*<unresolved"),
       nullptr, say(call_without_parentheses)},
      {on("expected primary-expression before '(double|int|const|float|auto)'"), "\\w\\s*\\(",
       [](const Situation& at) { return matches(at.before, "\\w\\s*\\([^()]*$") ? type_in_call() : std::string(); }},
      {on("expected primary-expression before ':' token"), "\\(\\s*:|,\\s*:", say(column_by_colon)},
      {on("expected identifier before numeric constant|expected '\\]' before ',' token"), "[=(,]\\s*\\[|return\\s*\\[",
       say(list_in_brackets)},
      {on("expected primary-expression before '\\.' token|expected unqualified-id before '\\.' token"),
       "\\b(std|Eigen|rigid|\\w*Matrix\\w*|\\w*Vector\\w*)\\s*\\.", say(dot_for_colons)},
      {on("expected primary-expression before '>' token"), "=>", say(arrow_for_comparison)},
      {on("assignment of function '"), nullptr, say(result_by_assignment)},
      {on("base operand of '->' has non-pointer type"), nullptr, say(arrow_for_dot)},
      {on("too (few|many) arguments to function '([^']*)'"), nullptr,
       [](const Situation& at) {
         return wrong_count_of_arguments(at.part(1) == "few", in_contract_words(at.part(2)));
       }},
      {on("invalid initialization of reference of type '([^']*)' from expression of type '([^']*)'"), nullptr,
       [](const Situation& at) {
         const std::string wanted = noun(at.part(1));
         const std::string given = noun(at.part(2));
         if (wanted.empty() || given.empty() || wanted == given) return std::string();
         return argument_of_wrong_kind(wanted, given);
       }},

      // Operators and conversions.
      {on("no match for 'operator([^']+)' \\(operand types are '([^']*)' and '([^']*)'\\)"), nullptr, operands},
      {on("conversion from '([^']*)' to non-scalar type '([^']*)' requested"), nullptr,
       [](const Situation& at) {
         if (at.part(1) == "<unresolved overloaded function type>") return call_without_parentheses();
         if (is_one_number(at.part(1))) return assignment_of_number(at, at.part(2));
         return conversion(at, at.part(1), at.part(2));
       }},
      {on("could not convert '.*' from '([^']*)' to '([^']*)'$"), nullptr,
       [](const Situation& at) { return conversion(at, at.part(1), at.part(2)); }},
      {on("cannot convert '([^']*)' to '([^']*)'"), nullptr,
       [](const Situation& at) { return conversion(at, at.part(1), at.part(2)); }},
      {on("no matching function for call to '(pow|sqrt|sin|cos|tan|exp|log|abs|fabs|inverse)\\(([^,()]*)[,)]"), nullptr,
       workbook::function_of_vector},
      {on("no matching function for call to '(.*)::(cross|dot)\\((.*)\\)'"), nullptr, member_call},
      {on("operands to '\\?:' have different types"), nullptr, say(branches_differ)},
      {on("lvalue required as left operand of assignment"), nullptr, say(nothing_to_assign_to)},

      // const.
      {on("(assignment|increment|decrement) of read-only \\w+ '(.*)'"), nullptr, read_only},
      {on("passing 'const ([^']*)' as 'this' argument discards qualifiers"), nullptr, method_of_constant},
      {on("non-member function '.*' cannot have cv-qualifier"), nullptr, say(const_behind_parameters)},

      // Names and types.
      {on("ambiguating new declaration of '[^']*\\brigid::(\\w+)\\("), nullptr, result_type},
      {on("'([^']*)' should have been declared inside 'rigid'"), nullptr, parameters},
      {on("was declared 'extern' and later '(static)'"), nullptr, say(marked, 1)},
      {on("differs in '(constexpr|consteval)' from previous declaration"), nullptr, say(marked, 1)},
      {on("forbids declaration of '.*' with no type"), nullptr, say(no_result_type)},
      {on("return-statement with no value"), nullptr, say(return_without_value)},
      {on("redeclaration of '[^']*?(\\w+)'"), nullptr, say(declared_twice, 1)},
      {on("declaration of '[^']*?(\\w+)' shadows a parameter"), nullptr, say(messages::shadows_parameter, 1)},
      {on("redefinition of '[^'(]*?([\\w:]+)(\\(.*)?'"), nullptr, say(defined_twice, 1)},
      {on("call of overloaded '([\\w:]+)\\(.*' is ambiguous"), nullptr, say(ambiguous_call, 1)},
      {on("'([^' ]+)' (?:was not declared in this scope|has not been declared)(; did you mean '([^']+)'\\?)?"), nullptr,
       workbook::undeclared},
      {on("'(\\w+)' does not name a type()(); did you mean|'(\\w+)' does not name a type()()$"), nullptr,
       [](const Situation& at) {
         const std::string name = at.part(1) + at.part(4);
         const bool known = one_of(name, {"Vector2d", "Vector3d", "VectorXd", "Matrix3d", "Matrix3Xd"});
         return known ? undeclared_outside_namespace(name) : std::string();
       }},
      {on("'(\\w+)' is not a member of '(std|Eigen)'(; did you mean '([^']+)'\\?)?"), nullptr, not_a_member},
      {on("'std::(\\w+)' has not been declared|aggregate 'std::(\\w+).*' has incomplete type"), nullptr,
       [](const Situation& at) {
         const std::string name = at.part(1) + at.part(2);
         return missing_include("std::" + name, "<" + name + ">");
       }},
      {on("invalid use of incomplete type '.*Matrix(Exponential|Power|Logarithm|SquareRoot|Function)"), nullptr,
       say(matrix_functions_need_header)},
      {on("'([^']+)' has no member named '(\\w+)'(; did you mean '(\\w+)'\\?)?"), nullptr, no_member},
      {on("request for member '(\\w+)' in '(\\w+)', which is of non-class type '(?:const )?(?:double|int|float)'"),
       nullptr, [](const Situation& at) { return member_of_number(at.part(1), at.part(2)); }},

      // Punctuation.
      {on("expected '\\(' before"), "\\b(if|for|while)\\b", say(condition_without_parentheses)},
      {on("expected (',' or )?';' before '?([^']+)'?"), nullptr, semicolon},
      {on("expected initializer before '?([^']+)'?"), nullptr,
       [](const Situation& at) { return ends_there(at.after) ? missing_semicolon() : std::string(); }},
      {on("expected '\\}' at end of input"), nullptr, say(missing_closing_brace)},
      {on("expected declaration before '\\}' token"), nullptr, say(surplus_closing_brace)},
      {on("expected '(\\(|\\)|\\])' before"), nullptr, say(missing_parenthesis, 1)},
      {on("expected (?:primary-expression|declaration) before '\\)' token"), nullptr, say(surplus_parenthesis)},
      {on("a function-definition is not allowed here before '\\{' token|qualified-id in declaration before '\\('"),
       nullptr, say(function_inside_function)},
      {on("'else' without a previous 'if'"), nullptr, say(messages::else_without_if)},
      {on("no match for call to '\\(std::vector"), nullptr,
       [](const Situation&) { return messages::brackets_for_standard_vector(); }},
  };
  return table;
}

/// The sentence for a mistake that is recognized.
std::string named_mistake(Situation& at) {
  const std::string code = clipped(at.raw.size() > at.code.size() ? at.raw : at.code);
  for (const Mistake& mistake : mistakes()) {
    if (!std::regex_search(at.message, at.found, mistake.message)) continue;
    if (mistake.code != nullptr && !matches(code, mistake.code)) continue;
    if (std::string sentence = mistake.sentence(at); !sentence.empty()) return sentence;
  }
  return {};
}

/// Where the code before a place ends: there the missing ; belongs.
Place end_of_code_before(const std::vector<std::string>& code, Place place) {
  const auto index = static_cast<std::size_t>(place.line - 1);
  const auto last_letter = [](std::string_view text) { return text.find_last_not_of(" \t\r"); };
  const std::size_t byte = byte_at_column(code[index], place.column);
  std::size_t last = last_letter(std::string_view(code[index]).substr(0, byte));
  if (last != std::string::npos) return place;
  for (std::size_t i = index; i-- > 0;)
    if (last = last_letter(code[i]); last != std::string::npos)
      return {static_cast<int>(i) + 1, column_of(code[i], last) + 1};
  return place;
}

class Explanation {
 public:
  Explanation(const std::string& source, const std::string& signature)
      : lines_(lines_of(source)), code_(lines_of(code_only(source))), signature_(signature) {}

  /// The place to show, which is not always where the compiler noticed.
  Place place_of(const Diagnostic& error) const {
    if (!is_in_file(error.place)) return error.place;
    const bool noticed_late = error.text.starts_with("expected ',' or ';' before") ||
                              error.text.starts_with("expected ';' before") ||
                              error.text.starts_with("expected initializer before");
    return noticed_late ? end_of_code_before(code_, error.place) : error.place;
  }

  bool is_in_file(const Place& place) const {
    return place.line > 0 && static_cast<std::size_t>(place.line) <= lines_.size();
  }

  /// The sentence for the mistake; empty if it has no name.
  std::string mistake(const Diagnostic& error) const {
    const Place place = place_of(error);
    Situation at{error, clipped(in_plain_words(error.text)), {}, {}, {}, {}, {}, signature_, {}};
    for (const std::string& note : error.notes) at.notes.push_back(clipped(in_plain_words(note)));
    if (is_in_file(place)) {
      const auto index = static_cast<std::size_t>(place.line - 1);
      at.raw = clipped(lines_[index]);
      at.code = clipped(code_[index]);
      const std::size_t byte = byte_at_column(code_[index], place.column);
      const std::size_t from = byte > longest_for_patterns ? byte - longest_for_patterns : 0;
      at.before = code_[index].substr(from, byte - from);
      at.after = clipped(code_[index].substr(byte));
    }
    return named_mistake(at);
  }

  Finding finding(const Diagnostic& error, std::string sentence) const {
    const Place place = place_of(error);
    Finding finding;
    finding.line = place.line;
    finding.sentence = printable(sentence);
    if (is_in_file(place)) finding.excerpt = excerpt(lines_[static_cast<std::size_t>(place.line - 1)], place.column);
    return finding;
  }

 private:
  std::vector<std::string> lines_;
  std::vector<std::string> code_;
  const std::string& signature_;
};

}  // namespace

std::string error_text(const Diagnostic& error) {
  constexpr std::size_t longest = 300;
  std::string text = in_plain_words(error.text);
  if (text.size() > longest) text = text.substr(0, longest) + " …";
  return printable(text);
}

std::optional<Finding> first_error(const std::vector<Diagnostic>& found, const std::string& source,
                                   const std::string& signature) {
  const Explanation explanation(source, signature);
  const auto is_error = [](const Diagnostic& one) { return one.severity == Severity::error && one.place.line > 0; };
  const auto first = std::find_if(found.begin(), found.end(), is_error);
  if (first == found.end()) return std::nullopt;
  for (auto next = first; next != found.end(); ++next) {
    if (!is_error(*next) || next->place.line != first->place.line) continue;
    if (std::string sentence = explanation.mistake(*next); !sentence.empty())
      return explanation.finding(*next, std::move(sentence));
  }
  return explanation.finding(*first, messages::compiler_says(error_text(*first)));
}

}  // namespace workbook
