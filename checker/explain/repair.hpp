/// @file
/// A wrong value explained by trying: with which small change would the file be right at every case?
#pragma once

#include "checker/explain/diagnostic_run.hpp"
#include "checker/explain/values/diagnosis.hpp"
#include "checker/explain/variants.hpp"
#include "checker/sandbox/worker_process.hpp"

#include <limits>
#include <set>

namespace workbook {

/// What findings about the code have to do with a wrong value.
struct CodeReasons {
  std::vector<Reason> reasons;  ///< with them fixed, the values are others
  bool are_all = false;         ///< with them fixed, all cases are right
  bool are_tried = false;       ///< they compile
};
/// @param fixes  variants of the file with some of the findings fixed: each has the name and place of one, or is of all
CodeReasons code_reasons(const DiagnosticTask& task, const std::vector<Reason>& findings, std::vector<Variant> fixes,
                         const Toolchain& toolchain, const std::filesystem::path& cache);

/// Of values that are nearly right only numbers and the ends of loops, of what is explained only a single slip.
enum class Sought { all, accuracy, one_slip };

/// The one token with which all cases are right: the place and its kind, not the answer; else the condition that holds
/// at the failing cases.
std::optional<Reason> slip_or_branch(const DiagnosticTask& task, const Toolchain& toolchain,
                                     const std::filesystem::path& cache, Sought sought = Sought::all);

/// What may be spent on trying the variants of a file; as it stands, while a student waits. It is counted, so that a
/// busy machine finds what an idle one finds; time, of a processor, only ends what would never end.
struct TrialLimits {
  int compilations = limits::trial_compilations;  ///< each leaves out what it objected to
  long work = 200'000'000;                        ///< in switches: some seconds
  int calls = 20'000;
  int slow_calls = 6;  ///< that reach the limit of one
  limits::Seconds compiling = limits::trial_compile_time, one_call = limits::trial_of_one;
};

/// Variants of a file in one executable, run in one process as long as they behave.
class VariantRunner {
 public:
  /// Erases the variants that do not compile. @throws std::runtime_error where none is left, or within the limits none
  /// can be compiled
  VariantRunner(const DiagnosticTask& task, std::vector<Variant>& variants, const Toolchain& toolchain,
                const std::filesystem::path& cache, const TrialLimits& limits = {});

  /// Does the file as it stands, among its variants, give what was judged, at nearly all failing cases?
  bool is_as_judged();
  /// At every case? @param part_left  of all work, that is kept for what follows
  bool is_right(std::size_t variant, double part_left = 0);
  /// A variant in which something is multiplied by so much.
  struct Multiple {
    std::size_t variant = 0;
    double times = 1;
  };
  /// If results go along with what is multiplied, as these two show: are all cases right with some multiple of it?
  bool is_right_with_a_multiple(Multiple one, Multiple other);
  /// Does it differ from what was judged at a failing case? At this one?
  bool is_other(std::size_t variant);
  bool is_other(std::size_t variant, std::size_t case_index);
  /// By how much it is wrong at some failing cases, in natural sizes; nothing where it has no value at one, or at the
  /// first a larger error.
  std::vector<double> errors(std::size_t variant, double below = std::numeric_limits<double>::infinity());
  /// The number for a variant that throws where it needs clearly more work than the file as it stands.
  std::size_t with_work_of_the_file(std::size_t variant) const {
    return VariantUnit::limited(variant, work_of_the_file_);
  }
  /// The cases at which the condition of a branch is true, with a slip beside it; nothing where that is not certain.
  std::optional<std::set<std::size_t>> cases_taking_branch(std::size_t variant, std::optional<std::size_t> beside = {});

 private:
  /// @param overdraft  how much more work than planned this may take
  Reply call(std::size_t variant, std::size_t case_index, long overdraft = 0);
  Reply answer(std::size_t variant, std::size_t case_index);
  /// Did the file as it stands return there, as far as is known?
  bool may_return(std::size_t case_index) const;
  /// Of 2, with which the call of the file as it stands needs less work.
  int exponent_of(std::size_t case_index);
  void plan_work();

  const DiagnosticTask& task_;
  const Program program_;
  const TrialLimits limits_;
  const std::size_t unchanged_;  ///< the number of the file as it stands
  std::vector<std::size_t> order_;
  std::vector<int> exponents_;  ///< of the cases; 0 where not yet known
  std::optional<long> work_left_;
  int slow_ = 0;
  int work_of_the_file_ = 0;  ///< of one call: less than 2 to this power
  Budget budget_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace workbook
