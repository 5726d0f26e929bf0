#include "tests/report/made_up.hpp"

namespace workbook::testing {

ReportedExercise& MadeUpCourse::add(const std::string& lecture, const std::string& exercise, Verdict verdict,
                                    double points) {
  if (cards_.empty() || cards_.back().lecture != lecture) {
    cards_.push_back({});
    cards_.back().lecture = lecture;
    cards_.back().title = "Springs";
  }
  entries_.push_back({exercise, points, exercise + "_notes", "The task of " + exercise + "."});
  ReportedExercise reported{.checked = {.exercise = {&cards_.back(), &entries_.back()},
                                        .file = "/home/student/" + exercise + ".cpp",
                                        .reference = nullptr,
                                        .observation = {},
                                        .judgement = {},
                                        .executable = {}},
                            .source = {},
                            .picture = {},
                            .picture_description = {}};
  Judgement& judgement = reported.checked.judgement;
  judgement.verdict = verdict;
  judgement.message = "The message of " + exercise + ".";
  judgement.next_step = "The next step of " + exercise + ".";
  judgement.cases_total = 8;
  judgement.cases_passed = verdict == Verdict::passed ? 8 : 3;
  exercises_.push_back(reported);
  return exercises_.back();
}

ReportedCourse MadeUpCourse::reported() const {
  ReportedCourse course;
  course.student = student;
  course.date = "2001-02-03";
  course.seed = 7;
  course.exercises.assign(exercises_.begin(), exercises_.end());
  course.headings = {{"springs_energy", "The energy of a spring"}};
  course.picture_trouble = picture_trouble;
  return course;
}

MadeUpCourse hostile_course() {
  MadeUpCourse course;
  course.student = hostile;
  const std::string picture =
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="640" height="512"><rect width="640" height="512"/></svg>)";
  for (const Verdict verdict : {Verdict::passed, Verdict::wrong_value, Verdict::compile_error, Verdict::crashed,
                                Verdict::uncaught_exception, Verdict::checker_error}) {
    ReportedExercise& exercise = course.add("01_springs", "a_" + to_string(verdict), verdict);
    Checked& checked = exercise.checked;
    checked.judgement.message = "The function threw an exception: " + hostile;
    checked.judgement.next_step = "Next. " + hostile;
    checked.judgement.diagnoses = {{DiagnosisKind::term, hostile, "Diagnosed. " + hostile, hostile}};
    checked.observation.findings = {{3, "int " + hostile + "\n    ^", "Found. " + hostile}};
    checked.observation.printed = "Printed. " + hostile + std::string(300, 'x');
    checked.observation.refusal_details = "Compiled. " + hostile;
    exercise.source = "// Source. " + hostile + "\r\n" + std::string(300, 'y') + "\033[31m";
    exercise.picture = picture;
    exercise.picture_description = "Pictured. " + hostile;
  }
  course.add("02_more_springs", hostile, Verdict::wrong_value);
  course.add("02_more_springs", "a_name_that_is_much_longer_than_any_name_of_an_exercise_in_this_course_ever_was",
             Verdict::not_started);
  return course;
}

}  // namespace workbook::testing
