/// @file
/// A student's file with one token changed: which small slip would make it right?
#pragma once

#include "checker/data/reference_results.hpp"
#include "checker/source/source_text.hpp"

#include <string_view>

namespace workbook {

/// One change in one place.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;
};

struct Variant {
  std::string kind;   ///< "sign", "index", "name", "function", "number", "factor"; or the name of a finding
  std::string words;  ///< of what is changed, without the answer: "another sign"; the condition of a branch
  Place place;
  std::vector<Edit> edits;
  // Of a branch: what is done where its condition is true, from the one offset to the other.
  std::size_t body_begin = 0, body_end = 0;

  bool is_branch() const { return body_end > 0; }
};

/// Of every `if` and `?`: a file that throws where its condition is true ("branch"), to learn which cases go that way,
/// and files in which it is never so ("branch_off") and always so ("branch_on").
std::vector<Variant> branch_variants(const SourceText& source);

/// Slips of one token: signs, indices, names of arguments of one kind, functions, numbers, a lost or surplus factor, a
/// surplus abs, transpose or static. All of them keep the types as they are, so that most compile. Conditions stay as
/// they are: to change one may only switch a wrong branch off.
std::vector<Variant> one_token_variants(const SourceText& source, const ExerciseReference& exercise);

/// Bugs in a file: all slips of one token, and those that are hardly slips: another comparison, a call such as
/// .normalized() or a statement left out.
std::vector<Variant> source_mutants(const SourceText& source, const ExerciseReference& exercise);

std::string edited(std::string_view text, std::vector<Edit> edits);

/// Files in which a finding about the code is fixed, and last one with all of them fixed; none for findings that no
/// small change fixes.
std::vector<Variant> fixed_variants(const SourceText& source, const std::vector<Finding>& findings);

/// One translation unit with variants of a file, each in a namespace of its own, and the exercise's function that calls
/// the one with the number `workbook_variant`.
class VariantUnit {
 public:
  VariantUnit(std::string_view source, const std::vector<Variant>& variants, const ExerciseReference& exercise);

  const std::string& text() const { return text_; }
  /// The variant that a line of the text belongs to; -1: none.
  int variant_at(int line) const;

 private:
  std::string text_;
  std::vector<int> first_lines_;  ///< of the variants
  int end_line_ = 0;
};

}  // namespace workbook
