// Mistakes in the code that are the reason of wrong values: they are not explained as physics.
#include "checker/explain/explainers.hpp"
#include "checker/explain/repair.hpp"
#include "checker/explain/slips.hpp"

#include <algorithm>

namespace workbook {

namespace {

CodeReasons reasons_of(const Search& search, const std::vector<Reason>& mistakes, std::vector<Variant> fixes) {
  const Evidence& evidence = search.evidence;
  return code_reasons(evidence.task, mistakes, std::move(fixes), evidence.toolchain, evidence.cache);
}

bool tell(Search& search, CodeReasons found) {
  if (found.reasons.empty()) return false;
  search.reasons = std::move(found.reasons);
  if (found.are_all) search.in_code.clear();
  return true;
}

}  // namespace

bool explain_fixed_mistakes(Search& search) {
  const SourceText source(search.evidence.task.submission.text);
  CodeReasons found = reasons_of(search, search.in_code, fixed_variants(source, search.in_code));
  // A rounded π is the reason only where nothing else is wrong.
  if (!found.are_all) std::erase_if(found.reasons, [](const Reason& reason) { return reason.fix == Fix::exact_pi; });
  // What may be meant as it stands is not told where its change does not help.
  if (found.are_tried)
    std::erase_if(search.in_code, [](const Reason& each) {
      return each.weight == Weight::possible && (each.fix == Fix::wider_type || each.fix == Fix::as_double);
    });
  return tell(search, std::move(found));
}

bool explain_slips_of_language(Search& search) {
  const DiagnosticTask& task = search.evidence.task;
  const SourceText source(task.submission.text);
  auto [slips, changed] = slips_of_language(source, task.reference);
  CodeReasons found = reasons_of(search, slips, std::move(changed));
  // A quotient of whole numbers that makes all zero is a mistake anyway.
  if (!found.are_all)
    std::erase_if(found.reasons, [](const Reason& reason) { return reason.fix == Fix::when_all_right; });
  const bool are_values = has_values(search.verdict());
  return (found.are_all || (are_values && are_zero(search.answers))) && tell(search, std::move(found));
}

bool explain_spoilt_statement(Search& search) {
  // Values that are the same in a new process do not depend on earlier calls.
  std::erase_if(search.in_code, [](const Reason& reason) { return reason.fix == Fix::not_static; });
  if (std::ranges::none_of(search.in_code, &Reason::is_cause)) return false;
  search.reasons = std::move(search.in_code);
  return true;
}

}  // namespace workbook
