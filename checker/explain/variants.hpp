/// @file
/// A student's file with one token changed: which small slip would make it right?
#pragma once

#include "checker/data/reference_results.hpp"
#include "checker/source/source_text.hpp"

#include <set>

#include <string_view>

namespace workbook {

/// One change in one place.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string replacement;
  std::size_t operand = std::string_view::npos;  ///< of a method's call: where that begins of which it is called
};

/// What is changed: slips (`inverse` is one over an operand, `power` its square, root, absolute value, transpose or
/// unit vector, `whole` the square or root of all behind an = or return, or one over it, `term` and `matrix` what is
/// missing before a sum or a product; `steps` are many more steps of a loop); the condition of a branch, which throws
/// where it is true, never is true, always is, or is where it was not; what needs a copy of the file. `brackets` stand
/// around a sum, `overwritten` is a value that the line above has changed, `assignment` another = or
/// +=.
enum class VariantKind {
  sign,
  factor,
  inverse,
  power,
  whole,
  term,
  matrix,
  steps,
  number,
  index,
  name,
  function,
  method,
  loop,
  guard,
  brackets,
  overwritten,
  assignment,
  branch,
  branch_off,
  branch_on,
  branch_opposite,
  division,
  bug,
  call,
  statement,
  fix,
  all_fixes
};
/// @pre it is a slip
std::string to_string(VariantKind kind);

struct Variant {
  VariantKind kind = VariantKind::fix;
  std::string
      words;  ///< of what is changed, without the answer: "another sign"; a condition; the name of what is fixed
  Place place;
  std::vector<Edit> edits;
  // Of a branch: what is done where its condition is true, from the one offset to the other.
  std::size_t body_begin = 0, body_end = 0;

  bool is_branch() const { return body_end > 0; }
};

/// What is said of two kinds of `brackets`.
inline constexpr const char* brackets_around_choice_words = "brackets around all of ? and :, which come after * and +";
inline constexpr const char* brackets_before_method_words =
    "brackets around what stands before the method, which binds first";

/// Of every `if` and `?`: one that throws where its condition is true ("branch"), to learn which cases go that way, and
/// ones in which it is never so ("branch_off") and always so ("branch_on").
std::vector<Variant> branch_variants(const SourceText& source);

/// Slips of one place: signs, indices, names of one type, functions, numbers, a lost or surplus factor, a surplus abs,
/// transpose or static, the end of a loop, brackets around a sum, a value that is changed too early. All of them keep
/// the types as they are, so that most compile. Conditions stay as they are: to change one may only switch a wrong
/// branch off.
std::vector<Variant> one_token_variants(const SourceText& source, const ExerciseReference& exercise);

/// Bugs in a file: all slips of one token, and those that are hardly slips: another comparison, a call such as
/// .normalized() or a statement left out.
std::vector<Variant> source_mutants(const SourceText& source, const ExerciseReference& exercise);

std::string edited(std::string_view text, std::vector<Edit> edits);

/// Files in which a finding about the code is fixed, and last one with all of them fixed; none for findings that no
/// small change fixes.
std::vector<Variant> fixed_variants(const SourceText& source, const std::vector<Reason>& findings);

/// One translation unit with all variants of a file, and the exercise's function that calls the one with the number
/// `workbook_variant`; the number behind the last is the file as it stands. Slips stand in one copy of the file, where
/// each is switched on by its number: it compiles in the time of a few copies, however many there are. Changes of
/// types and statements need a copy each, in a namespace of its own.
class VariantUnit {
 public:
  /// The number for a second slip beside the first.
  static constexpr std::size_t both(std::size_t one, std::size_t other) { return one + ((other + 1) << 12); }
  /// The number for a variant that may do work of 2^exponent switches only, and throws where it needs more.
  static constexpr std::size_t limited(std::size_t variant, int exponent) {
    return variant + (static_cast<std::size_t>(first_limit + exponent) << 12);
  }
  static constexpr int first_limit = 2001;       ///< no unit has so many slips
  static constexpr long most_work = 20'000'000;  ///< of one call, in switches

  VariantUnit(const SourceText& source, const std::vector<Variant>& variants, const ExerciseReference& exercise);

  const std::string& text() const { return text_; }
  /// The variants that a line of the text belongs to, or that stand last before it.
  std::set<std::size_t> variants_at(int line) const;

 private:
  struct Piece;
  std::vector<Piece> pieces_of(const SourceText& source, const std::vector<Variant>& variants) const;
  void append(std::string_view text, const std::set<std::size_t>& variants = {});

  std::string text_;
  int line_ = 1;                                      ///< the last one
  std::map<int, std::set<std::size_t>> variants_at_;  ///< by the first line from which they count
};

}  // namespace workbook
