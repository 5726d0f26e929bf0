/// @file
/// A student's file with one token changed: which small slip would make it right?
#pragma once

#include "checker/data/observation.hpp"
#include "checker/data/reference_results.hpp"
#include "checker/source/source_text.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace workbook {

/// One change in one place.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;
};

struct Variant {
  std::string kind;   ///< "sign", "index", "name", "function", "number", "factor"; or the name of a finding
  std::string words;  ///< of what is changed, without the answer: "another sign"
  Place place;
  std::vector<Edit> edits;
};

/// Slips of one token: signs, indices, names of arguments of one kind, functions, numbers, a lost or surplus factor, a
/// surplus abs, transpose or static. All of them keep the types as they are, so that most compile.
std::vector<Variant> one_token_variants(const SourceText& source, const ExerciseReference& exercise);

/// Files in which a finding about the code is fixed; none for findings that no small change fixes.
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
