/// @file
/// What GCC or clang printed about a student's file, taken apart. (GCC's JSON lacks the chain of templates that leads
/// from an error inside Eigen to the student's line, so its text is read.)
#pragma once

#include "checker/source/source_text.hpp"

#include <functional>
#include <optional>

namespace workbook {

/// The name under which every student's file is compiled.
inline const std::string unit_name = "unit.cpp";

/// One error or warning.
struct Diagnostic {
  bool is_error = true;
  Place place;         ///< in the student's file: of the error itself, or of the line that led to it; line 0: none
  std::string header;  ///< the file with the error, if that is not the student's
  std::string text;
  std::string option;   ///< "-Wreturn-type"
  std::string notes;    ///< line by line
  std::string context;  ///< the arguments of the templates that led to it, the innermost first, line by line
};

struct CompilerOutput {
  std::vector<Diagnostic> diagnostics;  ///< in the compiler's order
  std::string shown;                    ///< the errors as the compiler printed them, with the file's own name
  std::string foreign_file;             ///< the first file that may not be shown
};

/// @param may_be_shown  is this file one that students may include? Of others nothing comes back, not even quoted
/// lines.
CompilerOutput read_compiler_output(std::string_view output, const std::string& shown_name,
                                    const std::function<bool(const std::string&)>& may_be_shown);

/// A text of the compiler or the linker without what only authors of templates need: "const Vector3d&" for
/// "Eigen::Matrix<double, 3, 1> const&", "1×3 row vector" for an expression of that shape, no "[with …]", no "{aka …}",
/// long template arguments as "<…>".
std::string in_plain_words(std::string_view text);

// --- the mistakes that a file's text and what compilers say of it give away, by name; all of them are data

/// A mistake that makes the compiler print a message. `message` is a regular expression that matches the message in
/// plain words (with its option, "-Wshadow=local: …"), then its header, notes and context, then "raw: " and the message
/// as it came; in it <number>, <matrix>, <value> (one of both), <list> and <type> stand for a quoted type. `code`
/// matches the student's line without comments, where @ marks the column. In the sentence $1 is what `message` matched,
/// %1 what `code` matched, $right the right spelling of $1, $member the one of a member $1, $contract the signature of
/// the exercise, $elsewhere where else the name $1 is declared, $unclosed the line before which a { is not closed;
/// without such a place it is another mistake.
struct MessageMistake {
  const char* name;
  const char* message;
  const char* sentence;
  const char* code = "";  ///< empty: whatever the line is
  Weight weight = Weight::cause;
  Fix fix = Fix::none;
};

/// What clang says, in the words of GCC where the tables need them; any other text as it is. For the token at the place
/// of the error stands @token or @sign.
std::string in_words_of_gcc(const std::string& message);

// The first that fits counts.
extern const std::vector<MessageMistake> error_table;
extern const std::vector<MessageMistake> warning_table;

/// Right spellings of what students bring from elsewhere, ";wrong=right;"; a dot marks members of Eigen's types.
extern const std::string_view spellings;

/// The first error of a compilation. Where several concern that line, the one that is understood best. Nothing if no
/// error has a place in the file.
std::optional<Reason> first_error(std::vector<Diagnostic> found, const SourceText& source,
                                  const std::string& signature);

/// What the compiler warned of and is certainly so.
std::vector<Reason> warned_mistakes(const std::vector<Diagnostic>& found, const SourceText& source);

/// What the text alone gives away.
std::vector<Reason> text_mistakes(const SourceText& source);

}  // namespace workbook
