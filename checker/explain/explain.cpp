#include "checker/explain/explainers.hpp"

#include <algorithm>

namespace workbook {

namespace {

/// When an explainer is asked, if no reason has been found by then.
enum class When { no_return, no_value, values, wrong_value };

/// From the most certain reason on.
// clang-format off
constexpr struct {
  When when;
  Explainer* look;
} explainers[] = {
    {When::no_return, explain_slips_of_language},
    {When::no_value, explain_failed_call},
    {When::values, explain_fixed_mistakes},
    {When::values, explain_slips_of_language},
    {When::values, explain_spoilt_statement},
    {When::values, explain_suspected_undefined},
    {When::values, explain_values},
    {When::wrong_value, explain_lost_digits},
    {When::values, explain_by_small_change},
    {When::values, explain_by_sanitizers},
};
// clang-format on

bool is_due(When when, Verdict verdict) {
  using enum Verdict;
  return when == When::no_return  ? verdict == uncaught_exception || verdict == crashed || verdict == time_limit
         : when == When::no_value ? !has_values(verdict)
         : when == When::values   ? has_values(verdict)
                                  : verdict == wrong_value;
}

}  // namespace

bool has_values(Verdict verdict) { return verdict == Verdict::wrong_value || verdict == Verdict::non_finite_value; }

void Search::add_code(std::vector<Reason> more) {
  for (Reason& reason : more) {
    const bool is_new = std::ranges::none_of(reasons, [&](const Reason& other) {
      return reason.line > 0 ? other.line == reason.line : other.sentence == reason.sentence;
    });
    if (is_new) reasons.push_back(std::move(reason));
  }
}

std::vector<Reason> explain(const Evidence& evidence) {
  const DiagnosticTask& task = evidence.task;
  Search search{evidence, answers_of(task.reference, task.observation.replies),
                source_findings(evidence.compile_task, evidence.compilation, evidence.toolchain, evidence.cache)};
  // Where the function came to an end, so did its loops.
  if (search.verdict() != Verdict::time_limit)
    std::erase_if(search.in_code,
                  [](const Reason& reason) { return reason.name == "endless_loop" || reason.name == "exact_end"; });
  std::ranges::stable_partition(search.in_code, &Reason::is_cause);
  for (const auto& [when, look] : explainers)
    if (is_due(when, search.verdict()) && look(search)) break;
  search.add_code(std::move(search.in_code));
  std::ranges::stable_partition(
      search.reasons, [](const Reason& reason) { return reason.is_in_code() && reason.weight != Weight::symptom; });
  return std::move(search.reasons);
}

}  // namespace workbook
