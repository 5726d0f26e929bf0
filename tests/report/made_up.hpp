/// @file
/// A made-up student's page, without any process.
#pragma once

#include "checker/report/reports.hpp"

#include <deque>
#include <string>

namespace workbook::testing {

/// Text that would take over the page if anything of it were taken for markup or for the template.
inline const std::string hostile =
    "</pre></style><script>document.title='taken'</script>{{mustache}}{{{style}}}{{#lectures}}"
    "\"'><img src=x onerror=\"document.title='taken'\"><!-- &lt;b&gt; <svg onload=alert(1)>";

/// Exercises of made-up lectures. It must live as long as its page is made.
struct MadeUpCourse {
  /// Adds an exercise to the lecture, "01_springs"; every lecture is called "Springs".
  ReportedExercise& add(const std::string& lecture, const std::string& exercise, Verdict verdict, double points = 1.0) {
    if (cards.empty() || cards.back().lecture != lecture) {
      cards.emplace_back().lecture = lecture;
      cards.back().title = "Springs";
    }
    entries.push_back({exercise, points, exercise + "_notes", "The task of " + exercise + "."});
    CheckResult& checked = page.exercises.emplace_back().checked;
    checked.task = {{&cards.back(), &entries.back()}, "/home/student/" + exercise + ".cpp"};
    checked.judgement = {verdict, "The message of " + exercise + ".", "The next step of " + exercise + ".", {}, 8};
    if (verdict != Verdict::passed) checked.judgement.failing = {0, 2, 3, 5, 6};
    return page.exercises.back();
  }

  std::deque<Card> cards;
  std::deque<CardExercise> entries;
  ReportedCourse page = {"Ada", "2001-02-03", 7, {}, {{"springs_energy", "The energy of a spring"}}, ""};
};

/// Every verdict in a page, with hostile text wherever a student's text can go.
inline void fill_with_hostile_text(MadeUpCourse& course) {
  course.page.student = hostile;
  for (const Verdict verdict : {Verdict::passed, Verdict::wrong_value, Verdict::compile_error, Verdict::crashed,
                                Verdict::uncaught_exception, Verdict::checker_error}) {
    ReportedExercise& exercise = course.add("01_springs", "a_" + to_string(verdict), verdict);
    exercise.checked.picture = base64(
        R"(<svg xmlns="http://www.w3.org/2000/svg" width="640" height="512"><rect width="640" height="512"/></svg>)");
    exercise.checked.picture_description = "Pictured. " + hostile;
    CheckResult& checked = exercise.checked;
    checked.source = "// Source. " + hostile + "\r\n" + std::string(300, 'y') + "\033[31m";
    checked.judgement.message = "The function threw an exception: " + hostile;
    checked.judgement.next_step = "Next. " + hostile;
    checked.reasons = {{.name = "made_up",
                        .sentence = "Found. " + hostile,
                        .line = 3,
                        .column = 5,
                        .excerpt = "int " + hostile + "\n    ^"}};
    if (verdict == Verdict::checker_error) checked.reasons.clear();  // then the next step is told
    if (verdict == Verdict::wrong_value)
      checked.reasons.push_back({ReasonKind::term, hostile, "Diagnosed. " + hostile, Weight::cause, hostile});
    checked.observation.replies.resize(1);
    checked.observation.replies[0].printed = "Printed. " + hostile + std::string(300, 'x');
    checked.observation.refusal_details = "Compiled. " + hostile;
  }
  course.add("02_more_springs", hostile, Verdict::wrong_value);
  course.add("02_more_springs", "a_name_that_is_much_longer_than_any_name_of_an_exercise_in_this_course_ever_was",
             Verdict::not_started);
}

}  // namespace workbook::testing
