// Mistakes in the code that are the reason of wrong values: they are not explained as physics.
#include "checker/explain/explainers.hpp"
#include "checker/explain/repair.hpp"

#include <algorithm>

namespace workbook {

namespace {

CodeReasons reasons_of(const Search& search, const std::vector<Reason>& mistakes) {
  return code_reasons(search.evidence.task, mistakes, search.evidence.toolchain, search.evidence.cache);
}

bool tell(Search& search, CodeReasons found) {
  if (found.reasons.empty()) return false;
  search.reasons = std::move(found.reasons);
  if (found.are_all) search.in_code.clear();
  return true;
}

}  // namespace

bool explain_fixed_mistakes(Search& search) {
  CodeReasons found = reasons_of(search, search.in_code);
  // A rounded π is the reason only where nothing else is wrong.
  if (!found.are_all) std::erase_if(found.reasons, [](const Reason& reason) { return reason.fix == Fix::exact_pi; });
  return tell(search, std::move(found));
}

bool explain_whole_quotients(Search& search) {
  const DiagnosticTask& task = search.evidence.task;
  CodeReasons found = reasons_of(search, whole_quotients(SourceText(task.submission.text), task.reference));
  // Many a quotient of whole numbers is meant so: it is a mistake where all is right without it, or all zero with it.
  if (!found.are_all) std::erase_if(found.reasons, [](const Reason& reason) { return reason.fix == Fix::divisor; });
  return (found.are_all || are_zero(search.answers)) && tell(search, std::move(found));
}

bool explain_spoilt_statement(Search& search) {
  // Values that are the same in a new process do not depend on earlier calls.
  std::erase_if(search.in_code, [](const Reason& reason) { return reason.fix == Fix::not_static; });
  if (std::ranges::none_of(search.in_code, &Reason::is_cause)) return false;
  search.reasons = std::move(search.in_code);
  return true;
}

}  // namespace workbook
