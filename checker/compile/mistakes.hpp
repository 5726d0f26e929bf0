/// @file
/// The mistakes that a file's text and what compilers say of it give away, by name. All of them are data: see the
/// tables.
#pragma once

#include "checker/compile/diagnostics.hpp"
#include "checker/data/observation.hpp"
#include "checker/source/source_text.hpp"

namespace workbook {

/// A mistake that makes the compiler print a message. `message` is a regular expression that matches the message in
/// plain words (with its option, "-Wshadow=local: …"), then its header, notes and context, then "raw: " and the message
/// as it came; in it <number>, <matrix>, <value> (one of both), <list> and <type> stand for a quoted type. `code`
/// matches the student's line without comments, where @ marks the column. In the sentence $1 is what `message` matched,
/// %1 what `code` matched, $right the right spelling of $1, $member the one of a member $1, $contract the signature of
/// the exercise.
struct MessageMistake {
  const char* name;
  const char* message;
  const char* sentence;
  const char* code = "";  ///< empty: whatever the line is
};

// The first that fits counts.
extern const std::vector<MessageMistake> error_table;
extern const std::vector<MessageMistake> warning_table;

/// Right spellings of what students bring from elsewhere, ";wrong=right;"; a dot marks members of Eigen's types.
extern const std::string_view spellings;

/// The first error of a compilation. Where several concern that line, the one that is understood best. Nothing if no
/// error has a place in the file.
std::optional<Finding> first_error(const std::vector<Diagnostic>& found, const SourceText& source,
                                   const std::string& signature);

/// What the compiler warned of and is certainly so.
std::vector<Finding> warned_mistakes(const std::vector<Diagnostic>& found, const SourceText& source);

/// What the text alone gives away.
std::vector<Finding> text_mistakes(const SourceText& source);

}  // namespace workbook
