#include "checker/explain/repair.hpp"

#include "checker/base/text.hpp"
#include "checker/compile/compile.hpp"
#include "checker/explain/explainers.hpp"
#include "checker/judging/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <utility>

namespace workbook {

namespace {

const std::string variants_name = "variants.cpp";

Reason repair(const SourceText& source, Place place, std::string name, const std::string& sentence) {
  Reason reason = source.reason(place, std::move(name), sentence);
  reason.kind = ReasonKind::repair;
  return reason;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

std::int32_t mode_of(std::size_t variant) { return static_cast<std::int32_t>(variant) << protocol::variant_shift; }

/// The variants whose lines the compiler objects to, as it is printed of each error and of what led to it.
std::set<std::size_t> uncompilable(const VariantUnit& unit, const std::string& compiler_output) {
  std::set<std::size_t> objected;
  for (const std::string& line : lines_of(compiler_output))
    // What is around an expression that is wrong is not.
    if (line.starts_with(variants_name + ':') && !has(line, "<expression error>") &&
        (has(line, " error: ") || has(line, " required from ")))
      objected.merge(unit.variants_at(std::atoi(line.c_str() + variants_name.size() + 1)));
  return objected;
}

/// All variants that compile, in one executable; those that do not are erased.
Program compile_variants(const DiagnosticTask& task, std::vector<Variant>& variants, const Toolchain& toolchain,
                         const std::filesystem::path& cache, const TrialLimits& trial) {
  const SourceText source(task.submission.text);
  Toolchain with_all_errors = toolchain;
  with_all_errors.flags.insert(with_all_errors.flags.end(), {"-fmax-errors=0", "-w"});
  for (int tries = 0; tries < trial.compilations && !variants.empty(); ++tries) {
    // What keeps the types for sure.
    if (tries + 1 == trial.compilations)
      std::erase_if(variants, [](const Variant& each) {
        using enum VariantKind;
        return each.kind == name || each.kind == method || each.kind == function || each.kind == term ||
               each.kind == matrix;
      });
    const VariantUnit unit(source, variants, task.reference);
    const Submission all{variants_name, variants_name, unit.text(), task.submission.library, task.submission.own_names};
    const Compilation compilation =
        compile({.submission = all, .exercise = task.reference.name, .signature = task.reference.signature},
                with_all_errors, cache, {.time = trial.compiling});
    if (compilation.executable) return compilation.program();
    const std::set<std::size_t> objected = uncompilable(unit, compilation.details);
    std::vector<Variant> rest;
    for (std::size_t k = 0; k < variants.size(); ++k)
      if (!objected.contains(k)) rest.push_back(std::move(variants[k]));
    if (objected.empty()) break;
    variants = std::move(rest);
  }
  throw std::runtime_error("the variants do not compile within the limits");
}

/// A condition that is true at the failing cases, or false there.
struct DecidingBranch {
  std::size_t number = 0;  ///< of the variant
  Variant branch;
  bool when = true;       ///< the condition is so at the failing cases
  std::size_t cases = 0;  ///< at which it is so
  bool repairs = false;   ///< with the other outcome everywhere, all cases are right

  /// A slip elsewhere that makes all right may only switch the branch off.
  bool may_hold(const Variant& slip) const {
    const std::size_t offset = slip.edits.front().offset;
    const bool is_in_body = offset >= branch.body_begin && offset < branch.body_end;
    return is_in_body == when;
  }
};

/// The branch of fewest cases that all failing ones take, if many of its cases fail or all are right without it.
void consider(std::optional<DecidingBranch>& best, std::size_t number, const Variant& branch,
              const std::set<std::size_t>& taken, const std::function<bool(bool)>& is_right_if_always,
              const DiagnosticTask& task) {
  const std::vector<std::size_t>& failing = task.judgement.failing;
  const std::size_t total = task.reference.cases.size();
  for (const bool when : {true, false}) {
    const std::size_t cases = when ? taken.size() : total - taken.size();
    const bool all_fail_there =
        std::ranges::all_of(failing, [&](std::size_t index) { return taken.contains(index) == when; });
    // Where nothing else is at stake a wrong branch may be right; a few cases may share it by accident.
    const std::size_t least_part = failing.size() > 1 ? 4 : 2;
    if (!all_fail_there || cases == total) continue;
    const bool repairs = is_right_if_always(!when);
    if (!repairs && (least_part * failing.size() < cases || 2 * cases > total)) continue;
    if (!best || std::pair(!repairs, cases) < std::pair(!best->repairs, best->cases))
      best = DecidingBranch{number, branch, when, cases, repairs};
  }
}

/// @param branches  all of the file: of those with one condition nobody knows which is wrong
Reason finding_of(const DecidingBranch& found, const std::vector<Variant>& branches, const SourceText& source,
                  const DiagnosticTask& task) {
  const std::size_t failing = task.judgement.failing.size();
  const std::size_t total = task.reference.cases.size();
  const std::string condition = fmt::format("`{}` is {}", found.branch.words, found.when);
  std::string sentence =
      failing == found.cases
          ? fmt::format("{} at exactly the cases that are wrong ({} of {})", condition, failing, total)
          : fmt::format("only cases at which {} are wrong ({} of {})", condition, failing, found.cases);
  if (found.repairs) sentence += fmt::format("; were it always {}, all would be right", !found.when);
  std::vector<int> others;
  for (const Variant& each : branches)
    if (each.kind == VariantKind::branch && each.words == found.branch.words &&
        each.place.line != found.branch.place.line)
      others.push_back(each.place.line);
  if (!others.empty())
    sentence +=
        fmt::format("; it decides in {} {} too", others.size() == 1 ? "line" : "lines", fmt::join(others, ", "));
  return repair(source, found.branch.place, "branch", sentence + ".");
}

bool is_factor(const Variant& variant) {
  using enum VariantKind;
  return variant.kind == factor || variant.kind == inverse || variant.kind == term || variant.kind == matrix ||
         variant.kind == steps;
}

/// Others need a copy of the file.
bool can_be_switched(const Variant& variant) {
  using enum VariantKind;
  return variant.kind != brackets && variant.kind != overwritten && variant.kind != assignment;
}

/// There are few of its kind.
bool is_exact(const Variant& variant) {
  using enum VariantKind;
  constexpr VariantKind exact[] = {sign, function, method, loop, brackets};
  return std::ranges::count(exact, variant.kind) > 0;
}

double sum(const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); }

/// By what one number is multiplied; 0 where something else is changed.
double multiple(const Variant& variant, const SourceText& source) {
  const Edit& edit = variant.edits.front();
  const std::string text(source.text().substr(edit.offset, edit.length));
  return variant.kind != VariantKind::number || variant.edits.size() > 1
             ? 0
             : std::strtod(edit.replacement.c_str(), nullptr) / std::strtod(text.c_str(), nullptr);
}

/// The same of a factor in front of a term.
double times_of(const Variant& variant, const SourceText& source) {
  const bool is_factor = variant.kind == VariantKind::factor && variant.words == "another factor";
  return is_factor ? std::strtod(variant.edits.front().replacement.c_str(), nullptr) : multiple(variant, source);
}

/// How many steps, and how small something is. Another number of about that size may be that of another formula.
bool is_of_accuracy(const Variant& variant, const SourceText& source) {
  const double times = multiple(variant, source);
  return variant.kind == VariantKind::loop || variant.kind == VariantKind::steps ||
         (variant.kind == VariantKind::number &&
          (variant.edits.size() > 1 || std::abs(times - 10) < 1e-6 || std::abs(times - 0.1) < 1e-6));
}

/// The variant that has another multiple of the same number.
std::optional<std::size_t> with_multiple(double times, const Variant& number, const std::vector<Variant>& variants,
                                         const SourceText& source) {
  const auto found = std::ranges::find_if(variants, [&](const Variant& each) {
    return each.edits.front().offset == number.edits.front().offset &&
           std::abs(multiple(each, source) / times - 1) < 1e-6;
  });
  return found == variants.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - variants.begin()));
}

/// What is left of the error with twice a number, or half of it, if of the rest as much is left the next time: it is a
/// number of steps, or their size. 1 where it is not so.
double part_left(VariantRunner& runner, const std::vector<Variant>& variants, std::size_t number,
                 const std::vector<double>& errors, const SourceText& source) {
  const double once = multiple(variants[number], source);
  const auto twice = with_multiple(once * once, variants[number], variants, source);
  if (!twice) return 1;
  const double one = sum(runner.errors(number, errors.front())) / sum(errors);
  if (one == 0) return 1;
  const double both = sum(runner.errors(*twice)) / sum(errors);
  const bool is_law = both > 0 && one < 0.75 && std::abs(std::log(both) / std::log(one) - 2) < 0.5;
  return is_law ? one : 1;
}

/// Is it a number as of steps, or of their size?
bool may_be_steps(const Variant& variant, const SourceText& source) {
  const Edit& edit = variant.edits.front();
  const double number = std::strtod(std::string(source.text().substr(edit.offset, edit.length)).c_str(), nullptr);
  return number >= 8 || (number > 0 && number <= 0.1);
}

/// How many times larger the error is with a tenth of a number, or with ten times it, if it grows as much once more
/// with a hundredth, or a hundred times it; 1 where it does not. A wrong number of a formula follows no such law.
double growth_of_error(VariantRunner& runner, const std::vector<Variant>& variants, std::size_t number,
                       const std::vector<double>& errors, const SourceText& source) {
  const double once = multiple(variants[number], source);
  const auto further = with_multiple(once * once, variants[number], variants, source);
  if (!further) return 1;
  const auto error_with = [&](std::size_t variant) {
    return sum(runner.errors(runner.with_work_of_the_file(variant))) / sum(errors);
  };
  const double one = error_with(number);
  const double both = one > 1 ? error_with(*further) : 0;
  return one > 1 && std::abs(std::log(both) / std::log(one) - 2) < 0.15 ? one : 1;
}

/// Does the error fall with twice a number, and further with four times it, or with half of it and a quarter? Another
/// number of a formula may be nearer to the right one by chance. What is not a number is believed.
bool falls_step_by_step(VariantRunner& runner, const std::vector<Variant>& variants, std::size_t number,
                        const std::vector<double>& errors, const SourceText& source) {
  const double times = multiple(variants[number], source);
  if (variants[number].kind != VariantKind::number || times <= 0) return true;
  double last = sum(errors);
  for (const double step : times > 1 ? std::array{2.0, 4.0} : std::array{0.5, 0.25}) {
    const auto found = with_multiple(step, variants[number], variants, source);
    if (!found) continue;
    const double error = sum(runner.errors(*found));
    if (!(error < last)) return false;
    last = error;
  }
  return true;
}

/// The number, or the end of a loop, with which the error falls, of some failing cases taken together: it follows a
/// law, so that this limits the accuracy.
std::optional<Reason> coarse(VariantRunner& runner, const std::vector<Variant>& variants, const SourceText& source) {
  constexpr double clearly_less = 0.35, much_less = 0.15, nearly_right = 0.1, known = 0.7;
  constexpr double of_no_rule = 1e-7;  // to be left of an error: the file goes another way then
  const std::vector<double> errors = runner.errors(variants.size());
  if (errors.size() < 3 || !(std::ranges::max(errors) < known)) return std::nullopt;
  const bool is_near = std::ranges::max(errors) <= nearly_right;
  double best = is_near ? clearly_less : much_less;
  std::optional<Reason> found;
  // With less of a change there is more left; where a series or a rule of Gauss ends, that falls fast.
  const auto follows_rule = [&](std::size_t k, double ratio) {
    const double times = multiple(variants[k], source);
    const auto first = times > 0 ? with_multiple(times > 1 ? 2 : 0.5, variants[k], variants, source) : std::nullopt;
    return ratio >= of_no_rule || (first && sum(runner.errors(*first)) >= of_no_rule * sum(errors));
  };
  const auto tell = [&](std::size_t k, const std::string& words, double ratio) {
    // One step more may add what is no part of a sum: that the error becomes smaller is then an accident.
    if (ratio >= (variants[k].kind == VariantKind::loop ? std::min(best, much_less) : best) || !follows_rule(k, ratio))
      return;
    best = ratio;
    const double times = variants[k].kind == VariantKind::steps ? 10 : multiple(variants[k], source);
    const double order = times > 0 ? std::abs(std::log(ratio) / std::log(times)) : 0;
    found = repair(
        source, variants[k].place, "slip_coarse",
        fmt::format("this limits the accuracy: with {} here, about {:.0f} % of the error are left{}.", words,
                    std::ceil(100 * ratio),
                    std::abs(order - 1) < 0.1
                        ? ", as with a rule of first order; one of higher order needs far fewer steps"
                    : std::abs(order - 0.5) < 0.05 ? ", as where what is added up grows beyond all bounds at an end"
                                                   : ""));
  };
  // Ten times as many steps may take long, and a tenth of them does not.
  for (std::size_t k = 0; k < variants.size() && is_near; ++k)
    if (const double times = multiple(variants[k], source);
        may_be_steps(variants[k], source) &&
        (times == 2 || times == 0.5 || std::abs(std::abs(std::log10(times)) - 1) < 1e-6))
      if (const double growth = growth_of_error(runner, variants, k, errors, source); growth > 1.5)
        tell(k, times < 1 ? "a larger number" : "a smaller number", 1 / growth);
  if (found) return found;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    if (!is_of_accuracy(variants[k], source)) continue;
    const std::vector<double> others = runner.errors(k, errors.front());
    if (others.size() == errors.size() && falls_step_by_step(runner, variants, k, errors, source))
      tell(k, variants[k].words, sum(others) / sum(errors));
  }
  if (found || !is_near) return found;
  // Ten times as many steps may be too many to try.
  best = 1;
  for (std::size_t k = 0; k < variants.size(); ++k)
    if (const double times = multiple(variants[k], source); times == 2 || times == 0.5)
      tell(k, times == 2 ? "twice this number" : "half of this number", part_left(runner, variants, k, errors, source));
  return found;
}

/// A number, or a factor of a term, with another value of which all cases are right: two values that were tried show
/// how the results go with it.
std::optional<Reason> fitted_number(VariantRunner& runner, const std::vector<Variant>& variants,
                                    const SourceText& source, const DiagnosticTask& task) {
  constexpr std::size_t enough = 4;  // failing cases: a single number can be fitted to one or two
  if (task.judgement.failing.size() < enough) return std::nullopt;
  const auto is_of_one_place = [](const Variant& one, const Variant& other) {
    return one.kind == other.kind && one.edits.front().offset == other.edits.front().offset;
  };
  for (std::size_t k = 0; k + 1 < variants.size(); ++k) {
    const double one = times_of(variants[k], source), other = times_of(variants[k + 1], source);
    const bool is_first =
        k == 0 || !is_of_one_place(variants[k - 1], variants[k]) || times_of(variants[k - 1], source) == 0;
    if (one == 0 || other == 0 || !is_first || !is_of_one_place(variants[k], variants[k + 1])) continue;
    if (runner.is_right_with_a_multiple({k, one}, {k + 1, other}) ||
        runner.is_right_with_a_multiple({k, 1 / one}, {k + 1, 1 / other}))
      return repair(
          source, variants[k].place, "slip_" + to_string(variants[k].kind),
          fmt::format("with {} here, the result is right at all {} cases.",
                      is_factor(variants[k]) ? "another factor" : "another number", task.reference.cases.size()));
  }
  return std::nullopt;
}

}  // namespace

VariantRunner::VariantRunner(const DiagnosticTask& task, std::vector<Variant>& variants, const Toolchain& toolchain,
                             const std::filesystem::path& cache, const TrialLimits& limits)
    : task_(task),
      program_(compile_variants(task, variants, toolchain, cache, limits)),
      limits_(limits),
      unchanged_(variants.size()),
      order_(task.reference.cases.size()),
      exponents_(task.reference.cases.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  // What fails today comes first: almost every variant fails there too.
  std::stable_partition(order_.begin(), order_.end(), [&](std::size_t index) {
    return std::ranges::find(task.judgement.failing, index) != task.judgement.failing.end();
  });
}

Reply VariantRunner::call(std::size_t variant, std::size_t case_index, long overdraft) {
  if (!work_left_) plan_work();
  const long work = std::max(1L << exponent_of(case_index), limits_.work / limits_.calls);
  *work_left_ -= work;
  if (*work_left_ < -overdraft || slow_ >= limits_.slow_calls) return {};
  return answer(variant, case_index);
}

Reply VariantRunner::answer(std::size_t variant, std::size_t case_index) {
  // For what calls no switch in its endless loop.
  budget_ = {Clock::now() + std::chrono::duration_cast<Clock::duration>(limits_.one_call),
             limits::trial_processor_time.count(), limits::diagnostic_output};
  const auto planned = [&](std::size_t index) {
    const Case& one = task_.reference.cases[index];
    return PlannedCall{one.inputs, one.expected.rows, one.expected.cols};
  };
  if (!worker_ || !worker_->running()) {
    worker_ = std::make_unique<Worker>(program_, run_profile(), budget_);
    // What is computed once for all calls is computed from what the file says.
    if (variant != unchanged_ && may_return(order_.front()))
      worker_->call(planned(order_.front()), mode_of(unchanged_));
  }
  Reply reply = worker_->call(planned(case_index), mode_of(variant));
  if (reply.ending == Ending::time_limit) ++slow_;
  return reply;
}

bool VariantRunner::may_return(std::size_t case_index) const {
  const std::vector<Reply>& judged = task_.observation.replies;
  return judged.empty() || (case_index < judged.size() && judged[case_index].ending == Ending::returned);
}

int VariantRunner::exponent_of(std::size_t case_index) {
  constexpr int least = 10, most = 23;
  int& exponent = exponents_[case_index];
  if (exponent > 0) return exponent;
  if (!may_return(case_index)) return exponent = std::max(work_of_the_file_, least);  // it tells nothing of its work
  for (exponent = least; exponent < most; ++exponent)
    if (answer(VariantUnit::limited(unchanged_, exponent), case_index).ending != Ending::exception) break;
  return exponent;
}

void VariantRunner::plan_work() {
  constexpr std::size_t looked_at = 3, first_ones = 8;
  constexpr long fewest = 60;
  const auto exponent = [&](std::size_t index) { return exponent_of(index); };
  for (const std::size_t index : evenly_spaced(order_, looked_at))
    work_of_the_file_ = std::max(work_of_the_file_, exponent(index) + 1);
  // Of the failing cases, at which almost every variant fails too, one of little work comes first.
  const std::vector<std::size_t> some = evenly_spaced(task_.judgement.failing, first_ones);
  if (!some.empty())
    std::iter_swap(order_.begin(), std::ranges::find(order_, *std::ranges::min_element(some, {}, exponent)));
  work_left_ = std::max(limits_.work, fewest << exponent(order_.front()));
}

bool VariantRunner::is_right(std::size_t variant, double part_left) {
  if (work_left_ && *work_left_ < part_left * static_cast<double>(limits_.work)) return false;
  constexpr int promising = 3;  // cases that are right: such a variant is followed to its end, and there are few
  int right = 0;
  return std::ranges::all_of(order_, [&](std::size_t index) {
    const Reply reply = call(variant, index, right++ < promising ? 0 : limits_.work);
    return has_usable_value(reply, task_.reference.cases[index]) && passes(task_.reference, index, reply.value);
  });
}

bool VariantRunner::is_right_with_a_multiple(Multiple one, Multiple other) {
  std::optional<double> step;  // from the file as it stands to what is right
  for (const std::size_t index : order_) {
    const Case& expected = task_.reference.cases[index];
    const auto numbers_of = [&](const Reply& reply) {
      const std::vector<double> none, &all = has_usable_value(reply, expected) ? reply.value.numbers : none;
      return Eigen::VectorXd(Eigen::VectorXd::Map(all.data(), static_cast<Eigen::Index>(all.size())));
    };
    const Eigen::VectorXd now = numbers_of(task_.observation.replies[index]),
                          with_one = numbers_of(call(one.variant, index)),
                          with_other = numbers_of(call(other.variant, index));
    if (now.size() == 0 || with_one.size() != now.size() || with_other.size() != now.size()) return false;
    const Eigen::VectorXd slope = (with_one - now) / (one.times - 1);
    if (!slope.allFinite() || (!step && slope.isZero(0))) return false;
    const Eigen::VectorXd off = now + (other.times - 1) * slope - with_other;
    if (!(off.norm() <= 1e-6 * slope.norm() + 1e-12 * now.norm())) return false;
    if (!step) {
      const auto& right = expected.expected.numbers;
      step = (Eigen::VectorXd::Map(right.data(), now.size()) - now).dot(slope) / slope.squaredNorm();
    }
    Value value = expected.expected;
    Eigen::VectorXd::Map(value.numbers.data(), now.size()) = now + *step * slope;
    if (!passes(task_.reference, index, value)) return false;
  }
  return step.has_value();
}

bool VariantRunner::is_as_judged() {
  // Numbers that are wrong without bounds may have lost all digits that the compiler's options leave.
  constexpr std::size_t most = 10, looked_at = 10;
  const std::vector<std::size_t> failing = evenly_spaced(task_.judgement.failing, looked_at);
  const auto differs = [&](std::size_t index) { return is_other(unchanged_, index); };
  return most * static_cast<std::size_t>(std::ranges::count_if(failing, differs)) <= failing.size();
}

bool VariantRunner::is_other(std::size_t variant, std::size_t index) {
  const Reply reply = call(variant, index);
  const Reply& judged = task_.observation.replies.at(index);
  const Case& one = task_.reference.cases[index];
  if (!has_usable_value(reply, one) || !has_usable_value(judged, one)) return reply.ending != judged.ending;
  return !is_same_answer(task_.reference, index, reply.value, judged.value);
}

bool VariantRunner::is_other(std::size_t variant) {
  return std::ranges::any_of(task_.judgement.failing, [&](std::size_t index) { return is_other(variant, index); });
}

std::vector<double> VariantRunner::errors(std::size_t variant, double below) {
  constexpr std::size_t looked_at = 5;
  // Generated inputs may be so large or small that rounding is larger than what a step or a series leaves out.
  std::vector<std::size_t> failing = task_.judgement.failing;
  std::erase_if(failing, [&](std::size_t index) { return index >= task_.reference.described_cases(); });
  std::vector<double> errors;
  for (const std::size_t index : evenly_spaced(failing, looked_at)) {
    const Reply reply = call(variant, index);
    if (!has_usable_value(reply, task_.reference.cases[index])) return {};
    errors.push_back(0);
    for (const Deviation& each : deviations(task_.reference, index, reply.value))
      errors.back() = std::max(errors.back(), each.relative_size());
    if (errors.front() > below) return {};
  }
  return errors;
}

std::optional<std::set<std::size_t>> VariantRunner::cases_taking_branch(std::size_t variant,
                                                                        std::optional<std::size_t> beside) {
  if (beside) variant = VariantUnit::both(variant, *beside);
  std::set<std::size_t> cases;
  for (const std::size_t index : order_) {
    if (task_.observation.replies.at(index).ending != Ending::returned) return std::nullopt;
    const Ending ending = call(variant, index).ending;
    if (ending == Ending::exception) cases.insert(index);
    if (ending != Ending::exception && ending != Ending::returned) return std::nullopt;
  }
  return cases;
}

CodeReasons code_reasons(const DiagnosticTask& task, const std::vector<Reason>& findings, std::vector<Variant> variants,
                         const Toolchain& toolchain, const std::filesystem::path& cache) try {
  if (variants.empty()) return {};
  VariantRunner runner(task, variants, toolchain, cache);
  const auto fixed_by = [&](const Variant& variant) {
    std::vector<Reason> fixed;
    for (const Reason& each : findings) {
      const bool is_meant = std::ranges::any_of(variants, [&](const Variant& other) {
        return (variant.kind == VariantKind::all_fixes || &other == &variant) && other.words == each.name &&
               other.place.line == each.line && other.place.column == each.column;
      });
      const auto is_told = [&](const Reason& told) { return told.sentence == each.sentence && told.line == each.line; };
      if (is_meant && std::ranges::none_of(fixed, is_told)) fixed.push_back(each);
    }
    return fixed;
  };
  for (std::size_t k = 0; k < variants.size(); ++k)
    if (runner.is_right(k)) return {fixed_by(variants[k]), true, true};
  // What moves an error by a little, as another number of steps does, is not its reason.
  const std::vector<double> errors = runner.errors(variants.size());
  const auto is_alike = [](double one, double other) { return std::abs(one - other) <= 0.01 * other; };
  CodeReasons reasons{{}, false, true};
  for (std::size_t k = 0; k < variants.size(); ++k) {
    if (variants[k].kind == VariantKind::all_fixes || !runner.is_other(k)) continue;
    const std::vector<double> left = runner.errors(k);
    if (!errors.empty() && std::ranges::equal(left, errors, is_alike)) continue;
    // What may be meant as it stands, like `int n = t / h`, is a reason only if the error becomes clearly less.
    constexpr double clearly_less = 0.7;
    const bool is_better = errors.empty() || (!left.empty() && sum(left) < clearly_less * sum(errors));
    for (Reason& each : fixed_by(variants[k]))
      if (each.is_cause() || is_better) reasons.reasons.push_back(std::move(each));
  }
  return reasons;
} catch (const std::exception&) {  // it is a help only; what matters has been judged
  return {};
}

std::optional<Reason> slip_or_branch(const DiagnosticTask& task, const Toolchain& toolchain,
                                     const std::filesystem::path& cache, Sought sought) try {
  constexpr double part_for_branches = 0.3;  // of the work
  const SourceText source(task.submission.text);
  std::vector<Variant> variants = branch_variants(source);
  std::ranges::move(one_token_variants(source, task.reference), std::back_inserter(variants));
  std::erase_if(variants, [&](const Variant& each) {
    return each.kind == VariantKind::division ||  // which are known
           (sought == Sought::accuracy && !is_of_accuracy(each, source) && each.kind != VariantKind::number);
  });
  VariantRunner runner(task, variants, toolchain, cache);
  if (!runner.is_as_judged()) return std::nullopt;
  struct Branches {
    std::optional<DecidingBranch> deciding = {};
    std::vector<std::size_t> mixed = {};  // that some cases take and some do not
  };
  const auto is_mixed = [&](const std::set<std::size_t>& cases) {
    return !cases.empty() && cases.size() < task.reference.cases.size();
  };
  const auto branches_of_cases = [&] {
    Branches found;
    for (std::size_t k = 0; k < variants.size(); ++k) {
      if (variants[k].kind != VariantKind::branch) continue;
      const auto is_right_if_always = [&](bool outcome) {
        const auto forced = std::ranges::find_if(variants, [&](const Variant& other) {
          return other.kind == (outcome ? VariantKind::branch_on : VariantKind::branch_off) &&
                 other.edits.front().offset == variants[k].edits.front().offset;
        });
        return forced != variants.end() && runner.is_right(static_cast<std::size_t>(forced - variants.begin()));
      };
      if (const auto taken = runner.cases_taking_branch(k)) {
        consider(found.deciding, k, variants[k], *taken, is_right_if_always, task);
        if (is_mixed(*taken)) found.mixed.push_back(k);
      }
    }
    return found;
  };
  std::optional<Branches> branches;
  // Is it right only because all cases go one way now? Another sign may do so rightly, but not where the way alone
  // does.
  const auto only_leads_elsewhere = [&](std::size_t slip) {
    const std::optional<DecidingBranch>& branch = branches->deciding;
    return can_be_switched(variants[slip]) && std::ranges::any_of(branches->mixed, [&](std::size_t k) {
             if (is_exact(variants[slip]) && !(branch && branch->repairs && branch->number == k)) return false;
             const auto taken = runner.cases_taking_branch(k, slip);
             return taken && !is_mixed(*taken);
           });
  };
  // Another number may stand for many a mistake, and a last turn alone for a sum: they come last; where few cases fail
  // a number may only move rounding.
  const auto rank = [&](std::size_t k) {
    const VariantKind kind = variants[k].kind;
    const bool is_tangent = kind == VariantKind::function && variants[k].edits.front().replacement == "std::tan";
    const bool is_last = kind == VariantKind::number || kind == VariantKind::assignment || is_tangent;
    return kind == VariantKind::guard || kind == VariantKind::branch_opposite ? 3
           : is_factor(variants[k])                                           ? 2
                                                                              : is_last;
  };
  std::vector<std::size_t> order(variants.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, rank);
  const auto slip_among = [&](bool in_loops) -> std::optional<Reason> {
    for (const std::size_t k : order) {
      const Variant& each = variants[k];
      if (each.is_branch() || (each.kind == VariantKind::loop) != in_loops || !runner.is_right(k, part_for_branches))
        continue;
      if (!branches) branches = branches_of_cases();
      const std::optional<DecidingBranch>& branch = branches->deciding;
      const bool goes_both_ways = std::ranges::any_of(branches->mixed, [&](std::size_t other) {
        return variants[other].edits.front().offset == each.edits.front().offset;
      });
      const bool may_hold = each.kind == VariantKind::branch_opposite
                                ? goes_both_ways && !(branch && branch->repairs)
                                : !branch || (each.kind != VariantKind::guard && branch->may_hold(each));
      if (may_hold && !only_leads_elsewhere(k))
        return repair(
            source, each.place, "slip_" + to_string(each.kind),
            fmt::format("with {} here, the result is right at all {} cases.", each.words, task.reference.cases.size()));
    }
    return std::nullopt;
  };
  // Where steps are many, few calls can be made: what they limit comes first.
  if (auto slip = slip_among(true)) return slip;
  auto limit = coarse(runner, variants, source);
  if (auto slip = slip_among(false)) return slip;
  if (sought == Sought::one_slip) return std::nullopt;
  if (!branches) branches = branches_of_cases();
  if (branches->deciding) return finding_of(*branches->deciding, variants, source, task);
  if (limit || sought == Sought::accuracy) return limit;
  return fitted_number(runner, variants, source, task);
} catch (const std::exception&) {
  return std::nullopt;
}

bool explain_by_small_change(Search& search) {
  const Evidence& evidence = search.evidence;
  // What is right but for a few divisions by zero has no slip.
  const auto is_finite_and_wrong = [&](std::size_t i) { return search.answers[i] && search.answers[i]->is_finite(); };
  const std::vector<std::size_t>& failing = evidence.task.judgement.failing;
  if (2 * static_cast<std::size_t>(std::ranges::count_if(failing, is_finite_and_wrong)) < failing.size()) return false;
  const auto is_inaccurate = [](const Reason& reason) {
    return reason.kind == ReasonKind::accuracy && reason.weight == Weight::possible;
  };
  const bool are_inaccurate = std::ranges::any_of(search.reasons, is_inaccurate);
  const bool are_explained = std::ranges::any_of(search.reasons, [](const Reason& reason) {
    return (reason.kind == ReasonKind::misconception || reason.kind == ReasonKind::input_transform ||
            reason.kind == ReasonKind::transform) &&
           reason.weight == Weight::possible;
  });
  const Sought sought = are_inaccurate ? Sought::accuracy : are_explained ? Sought::one_slip : Sought::all;
  if (const auto found = slip_or_branch(evidence.task, evidence.toolchain, evidence.cache, sought)) {
    // The change says which values of an input decide; a split that is a symptom only says it again.
    std::erase_if(search.reasons, [&](const Reason& reason) {
      return (reason.kind != ReasonKind::split || reason.weight == Weight::symptom) && !is_inaccurate(reason);
    });
    search.add_code({*found});
    return true;
  }
  // A float or a π of few digits is reason enough.
  if (are_inaccurate && search.has_mistake_in_code()) search.reasons.clear();
  return are_inaccurate || are_explained;
}

}  // namespace workbook
