#include "checker/judging/judgement.hpp"

namespace workbook {

std::string to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::wrong_value:
      return "wrong_value";
    case Verdict::non_finite_value:
      return "non_finite_value";
    case Verdict::wrong_shape:
      return "wrong_shape";
    case Verdict::not_started:
      return "not_started";
    case Verdict::compile_error:
      return "compile_error";
    case Verdict::missing_function:
      return "missing_function";
    case Verdict::uncaught_exception:
      return "uncaught_exception";
    case Verdict::crashed:
      return "crashed";
    case Verdict::stopped_early:
      return "stopped_early";
    case Verdict::time_limit:
      return "time_limit";
    case Verdict::memory_limit:
      return "memory_limit";
    case Verdict::output_limit:
      return "output_limit";
    case Verdict::forbidden_operation:
      return "forbidden_operation";
    case Verdict::protocol_violation:
      return "protocol_violation";
    case Verdict::inconsistent_value:
      return "inconsistent_value";
    case Verdict::rejected_file:
      return "rejected_file";
    case Verdict::checker_error:
      return "checker_error";
  }
  return "checker_error";
}

std::string to_string(DiagnosisKind kind) {
  switch (kind) {
    case DiagnosisKind::misconception:
      return "misconception";
    case DiagnosisKind::term:
      return "term";
    case DiagnosisKind::property:
      return "property";
    case DiagnosisKind::dimension:
      return "dimension";
    case DiagnosisKind::transform:
      return "transform";
  }
  return "transform";
}

}  // namespace workbook
