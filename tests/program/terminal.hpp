/// @file
/// The checker on a terminal that the test plays.
#pragma once

#include "tests/program/program.hpp"

#include <string>
#include <vector>

namespace workbook::testing {

struct TerminalWindow {
  int columns = 80;
  int rows = 40;
  std::string answer = {};       ///< to the question for device attributes; empty: the terminal keeps silent
  std::string typed_ahead = {};  ///< stands in the terminal before the checker begins
};

/// What one run on a terminal showed.
struct TerminalOutcome {
  int status = -1;
  std::string shown;  ///< standard output and standard error, as the terminal got them
  bool was_asked = false;
  bool echoes_afterwards = false;  ///< the terminal is as it was
};

/// Runs `checker ARGUMENTS` on the course; the environment is `environment` and PATH, nothing else.
TerminalOutcome run_on_terminal(const CourseCopy& course, const std::vector<std::string>& arguments,
                                const TerminalWindow& window, const std::vector<std::string>& environment);

}  // namespace workbook::testing
