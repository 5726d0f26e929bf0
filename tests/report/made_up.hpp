/// @file
/// A made-up student's page, without any process.
#pragma once

#include "checker/report/report_page.hpp"

#include <deque>
#include <string>

namespace workbook::testing {

/// Text that would take over the page if anything of it were taken for markup or for the template.
inline const std::string hostile =
    "</pre></style><script>document.title='taken'</script>{{mustache}}{{{style}}}{{#lectures}}"
    "\"'><img src=x onerror=\"document.title='taken'\"><!-- &lt;b&gt; <svg onload=alert(1)>";

/// Exercises of made-up lectures, ready for the page.
class MadeUpCourse {
 public:
  /// Adds an exercise to the lecture, "01_springs"; the lecture's title is "Springs".
  ReportedExercise& add(const std::string& lecture, const std::string& exercise, Verdict verdict, double points = 1.0);

  /// It refers to the cards kept here, and is of use as long as they are.
  ReportedCourse reported() const;

  std::string student = "Ada";
  std::string picture_trouble;

 private:
  std::deque<Card> cards_;
  std::deque<CardExercise> entries_;
  std::deque<ReportedExercise> exercises_;
};

/// Every verdict in a page, with hostile text wherever a student's text can go.
MadeUpCourse hostile_course();

}  // namespace workbook::testing
