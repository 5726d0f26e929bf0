#include "checker/compile/warning_mistakes.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/code_text.hpp"
#include "checker/messages/compiling.hpp"

#include <algorithm>
#include <functional>
#include <regex>

namespace workbook {
namespace {

constexpr std::size_t longest_for_patterns = 1500;  // std::regex recurses over the length of its text

struct Warned {
  std::smatch found;
  std::string code;    ///< the student's line without comments
  std::string before;  ///< up to the caret
  std::string after;   ///< from the caret
};

bool matches(const std::string& text, const char* pattern) { return std::regex_search(text, std::regex(pattern)); }

/// A warning, and what it tells a student; an empty sentence tells nothing.
struct Mistake {
  const char* option;  ///< its beginning
  std::regex message;
  bool is_odd_only;  ///< not wrong in itself
  std::function<std::string(const Warned&)> sentence;
};

const std::vector<Mistake>& mistakes() {
  using namespace messages;
  using W = const Warned&;
  static const std::vector<Mistake> table = {
      {"-Wreturn-type", std::regex("no return statement|control reaches end"), false,
       [](W) { return missing_return(); }},
      // "may be used uninitialized" is a guess; this is not.
      {"-Wuninitialized", std::regex("^'(\\w+)' is used uninitialized"), false,
       [](W at) {
         const std::string name = at.found[1];
         return matches(at.code, ("\\b" + name + "\\b").c_str()) ? used_before_set(name) : std::string();
       }},
      {"-Wfloat-conversion", std::regex("conversion from '(?:const )?double' to '((?:long |unsigned |short )*int)'"),
       false,
       [](W at) {
         return matches(at.code, "round|floor|ceil|trunc|rint") ? std::string() : cut_to_whole_number(at.found[1]);
       }},
      {"-Wfloat-conversion", std::regex("to 'float'"), false, [](W) { return kept_in_float(); }},
      {"-Wparentheses", std::regex("assignment used as truth value"), false,
       [](W) { return assignment_as_condition(); }},
      {"-Wparentheses", std::regex("do not have their mathematical meaning"), false,
       [](W) { return chained_comparison(); }},
      {"-Wunused-value", std::regex("operand of comma operator has no effect"), false,
       [](W at) {
         const bool decimal = matches(at.before, "(^|[^\\w.,])\\d+$") || matches(at.after, "^\\d+,\\d");
         return decimal && matches(at.code, "\\d,\\d") ? decimal_comma() : part_without_effect();
       }},
      {"-Wunused-value", std::regex("has no effect|value computed is not used"), false,
       [](W) { return without_effect(); }},
      {"-Wtype-limits", std::regex("comparison of unsigned expression in"), false, [](W) { return never_negative(); }},
      {"-Wmisleading-indentation", std::regex("this '(\\w+)' clause does not guard"), false,
       [](W at) {
         const bool is_one_line = matches(at.code, "[;}]\\s*$");  // where nothing is indented
         return is_one_line ? std::string() : misleading_indentation(at.found[1]);
       }},
      {"-Wreturn-local-addr", std::regex("local variable '(\\w+)' returned"), false,
       [](W at) { return reference_to_local(at.found[1]); }},
      {"-Wdiv-by-zero", std::regex("division by zero"), false, [](W) { return division_by_zero(); }},
      {"-Wimplicit-fallthrough", std::regex("may fall through"), false, [](W) { return falls_through(); }},
      {"-Wshadow", std::regex("declaration of '[^']*?(\\w+)' shadows a (?:previous local|parameter)"), false,
       [](W at) {
         return at.code.find("](") != std::string::npos ? std::string() : shadows_local(at.found[1]);  // a lambda's own
       }},
      {"-Wunused", std::regex("unused variable '(\\w+)'|variable '(\\w+)' set but not used"), true,
       [](W at) { return never_used(at.found[1].str() + at.found[2].str()); }},
      {"-Wunused-parameter", std::regex("unused parameter '(\\w+)'"), true,
       [](W at) { return argument_never_used(at.found[1]); }},
  };
  return table;
}

}  // namespace

const std::vector<std::string>& warning_flags() {
  static const std::vector<std::string> flags = {
      "-Wreturn-type",       "-Wuninitialized",        "-Wfloat-conversion",
      "-Wparentheses",       "-Wunused-value",         "-Wtype-limits",
      "-Wunused-variable",   "-Wunused-parameter",     "-Wunused-but-set-variable",
      "-Wreturn-local-addr", "-Wimplicit-fallthrough", "-Wmisleading-indentation",
      "-Wshadow=local",      "-Wdiv-by-zero"};
  return flags;
}

std::vector<Finding> warning_mistakes(const std::vector<Diagnostic>& found, const std::string& source) {
  const std::vector<std::string> lines = lines_of(source);
  const std::vector<std::string> code = lines_of(code_only(source));
  std::vector<Finding> wrong;
  std::vector<Finding> odd;
  for (const Diagnostic& warning : found) {
    const auto index = static_cast<std::size_t>(warning.place.line - 1);
    const bool is_students = warning.severity == Severity::warning && warning.header.empty() &&
                             warning.place.line > 0 && index < lines.size() &&
                             lines[index].size() <= longest_for_patterns && warning.text.size() <= longest_for_patterns;
    if (!is_students) continue;
    const std::size_t byte = byte_at_column(code[index], warning.place.column);
    for (const Mistake& mistake : mistakes()) {
      if (!warning.option.starts_with(mistake.option)) continue;
      Warned at{{}, code[index], code[index].substr(0, byte), code[index].substr(byte)};
      if (!std::regex_search(warning.text, at.found, mistake.message)) continue;
      const std::string sentence = mistake.sentence(at);
      if (!sentence.empty())
        (mistake.is_odd_only ? odd : wrong)
            .push_back({warning.place.line, excerpt(lines[index], warning.place.column), printable(sentence)});
      break;
    }
  }
  wrong.insert(wrong.end(), odd.begin(), odd.end());
  return wrong;
}

}  // namespace workbook
