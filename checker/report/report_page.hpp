/// @file
/// One student's results as one page that needs nothing beside it: to hand in, or for an instructor to read.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace workbook {

struct ReportedExercise {
  CheckResult checked;
  std::string picture;              ///< the plot as SVG; empty: none
  std::string picture_description;  ///< what it shows, in words
};

struct ReportedCourse {
  std::string student;  ///< may be empty
  std::string date;     ///< as it is to be read
  std::uint64_t seed = 1;
  std::vector<ReportedExercise> exercises;      ///< in course order
  std::map<std::string, std::string> headings;  ///< of the notes, by anchor
  std::string picture_trouble;                  ///< why there are no plots; empty: there is no trouble
};

/// The page as HTML, made from report_page.html. Whatever came from the student is text on it, never markup. It holds
/// no script, and it asks for no other file.
std::string report_page(const ReportedCourse& reported);

}  // namespace workbook
