#include "checker/messages/reporting.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string your_code_printed() { return "Your code printed:"; }

std::string the_compiler_says() { return "All that the compiler says:"; }

std::string plot_label() { return "Plot"; }

std::string building() { return "building"; }

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

}  // namespace workbook::messages
