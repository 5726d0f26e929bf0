/// @file
/// A verdict on the terminal.
#pragma once

#include "checker/base/console.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// What of a verdict is shown.
struct Detail {
  bool full = false;                      ///< every failing case by name, long lists and all that the compiler says
  std::optional<std::size_t> case_index;  ///< this case, whether it passed or not; else the first failing one
  bool by_keys = false;                   ///< in the watch, whose keys do what is to be typed elsewhere
};

/// One line for what passed or was not started, and everything that helps for the rest: why, what to do next, the
/// numbers, which other cases fail.
std::string terminal_report(const CheckResult& checked, const Course& course, const Console& console,
                            const Detail& detail = {});

/// "6 of 8 passed, 1 failing, 1 not started."
std::string summary_line(const std::vector<CheckResult>& results);

/// "kinetic_energy.cpp:8:3: …" as editors jump to it, or the sentence alone.
std::string finding_line(const CheckResult& checked, const Finding& finding);

/// Where a paragraph of the notes can be read: the built page if there is one, else its source and the heading.
std::string notes_place(const Course& course, const Exercise& exercise, const std::string& anchor);

}  // namespace workbook
