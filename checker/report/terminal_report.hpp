/// @file
/// A verdict on the terminal.
#pragma once

#include "checker/pipeline/check_exercise.hpp"
#include "checker/report/console.hpp"

#include <string>
#include <vector>

namespace workbook {

/// What of a verdict is shown.
struct Detail {
  bool full = false;      ///< all that the compiler says, not only its first error
  bool one_case = false;  ///< judgement.first_failure is a case that was asked for by name: show it even if it passed
};

/// One line for what passed or was not started, and everything that helps for the rest: what failed, why, where to
/// read, what to do next.
std::string terminal_report(const Course& course, const Checked& checked, const Console& console,
                            const Detail& detail = {});

/// "6 of 8 passed, 1 wrong, 1 not started."
std::string summary_line(const std::vector<Checked>& results);

/// Where a paragraph of the notes can be read: the built page if there is one, else its source.
std::string notes_place(const Course& course, const std::string& lecture, const std::string& anchor);

}  // namespace workbook
