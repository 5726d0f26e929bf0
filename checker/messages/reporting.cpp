#include "checker/messages/reporting.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string in_words(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::wrong_value:
      return "wrong value";
    case Verdict::non_finite_value:
      return "non finite value";
    case Verdict::wrong_shape:
      return "wrong shape";
    case Verdict::not_started:
      return "not started";
    case Verdict::compile_error:
      return "compile error";
    case Verdict::missing_function:
      return "missing function";
    case Verdict::uncaught_exception:
      return "uncaught exception";
    case Verdict::crashed:
      return "crashed";
    case Verdict::stopped_early:
      return "stopped early";
    case Verdict::time_limit:
      return "time limit";
    case Verdict::memory_limit:
      return "memory limit";
    case Verdict::output_limit:
      return "output limit";
    case Verdict::forbidden_operation:
      return "forbidden operation";
    case Verdict::protocol_violation:
      return "protocol violation";
    case Verdict::inconsistent_value:
      return "inconsistent value";
    case Verdict::rejected_file:
      return "rejected file";
    case Verdict::checker_error:
      break;
  }
  return "checker error";
}

std::string cases_right(std::size_t passed, std::size_t total) {
  return total == 1 ? fmt::format("({} of 1 case right)", passed)
                    : fmt::format("({} of {} cases right)", passed, total);
}

std::string at_line(int line, const std::string& sentence) {
  return line > 0 ? fmt::format("Line {}: {}", line, sentence) : sentence;
}

std::string paragraph(const std::string& notes, const std::string& anchor) {
  return fmt::format("{}, paragraph {}", notes, anchor);
}

std::string why_label() { return "Why"; }
std::string read_label() { return "Read"; }
std::string next_label() { return "Next"; }
std::string again_label() { return "Again"; }
std::string more_label() { return "More"; }
std::string hint_label() { return "Hint"; }

std::string your_code_printed() { return "Your code printed:"; }

std::string the_compiler_says() { return "All that the compiler says:"; }

std::string plot_label() { return "Plot"; }

std::string more_lines(std::size_t count) {
  return count == 1 ? "… and one more line" : fmt::format("… and {} more lines", count);
}

std::string summary(std::size_t total, std::size_t passed, std::size_t wrong, std::size_t not_started,
                    std::size_t errors) {
  std::string line = fmt::format("{} of {} passed", passed, total);
  if (wrong > 0) line += fmt::format(", {} to mend", wrong);
  if (not_started > 0) line += fmt::format(", {} not started", not_started);
  if (errors > 0) line += fmt::format(", {} could not be judged (our fault, not yours)", errors);
  return line + ".";
}

std::string no_such_case(const std::string& exercise, const std::string& name, const std::string& proposal,
                         const std::vector<std::string>& known) {
  if (!proposal.empty()) return fmt::format("{} has no case '{}'. Did you mean '{}'?", exercise, name, proposal);
  return fmt::format("{} has no case '{}'. Its cases are: {}.", exercise, name, fmt::join(known, "; "));
}

std::string case_needs_one_exercise() {
  return fmt::format("--case needs the one exercise that the case belongs to: {}.",
                     command("check EXERCISE --case NAME"));
}

std::string file_needs_one_exercise(const std::string& name) {
  return fmt::format("--file needs the one exercise that the file is for: {}.",
                     command(name + " EXERCISE --file FILE"));
}

std::string nothing_started() { return "No exercise is started, so there was nothing to check."; }

std::string done_so_far(std::size_t done, std::size_t total) { return fmt::format("{} of {}", done, total); }

std::string building() { return "building"; }

}  // namespace workbook::messages
