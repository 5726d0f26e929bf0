/// @file
/// What an instructor says of a class: what is graded, who is in it; and the tables that spreadsheets exchange.
#pragma once

#include "checker/course/course.hpp"
#include "checker/judging/judge.hpp"

#include <deque>

namespace workbook {

/// A file of the instructor's cannot be used: file, place and reason in one sentence.
struct GradingError : UsageError {
  using UsageError::UsageError;
};

using Table = std::vector<std::vector<std::string>>;

/// Rows of an RFC 4180 text: fields in quotation marks may hold commas, line ends and doubled quotation marks.
/// @throws GradingError naming the row, where a quotation mark is not closed or a line ends as none should
Table read_csv(std::string_view text, char separator = ',');

/// The same, written. What a spreadsheet would take for a formula gets an apostrophe in front.
std::string write_csv(const Table& table);

/// Seconds since 1970 of "2027-03-01T23:59:00Z" or "2027-03-01 23:59:00.12 +0100". Without a zone nothing is read, so
/// that none is guessed, and no day that its month does not have.
std::optional<std::int64_t> read_time(const std::string& text);

/// What is graded, and what it is worth.
class Assignment {
 public:
  /// All exercises of the course with the points of their cards, nothing due; or what the file says.
  /// @throws GradingError
  Assignment(const Course& course, const std::optional<fs::path>& file);
  Assignment(const Assignment&) = delete;  // exercises() points into it
  Assignment& operator=(const Assignment&) = delete;

  const std::string& title() const { return title_; }
  /// In the order of the course, with the points of the assignment.
  const std::vector<Exercise>& exercises() const { return exercises_; }

  /// As the file has it; "" if nothing is due.
  const std::string& due_text() const { return due_text_; }
  /// Days begun after the due date; 0 where there is none, or no time is known.
  /// @param own_due  of this student
  int days_late(const std::optional<std::int64_t>& submitted, const std::optional<std::int64_t>& own_due = {}) const;
  /// What is left of the points after so many days: all, where the file does not say what lateness costs.
  double late_factor(int days) const;

  /// What an exercise earns of its points. @param misconceptions  that were recognised. @param hints  that have been
  /// shown
  double share(const Judgement& judgement, const ExerciseReference& reference,
               const std::vector<std::string>& misconceptions, std::size_t hints) const;
  /// What wrong answers with these misconceptions earn, by "NAME" or "EXERCISE/NAME".
  const std::map<std::string, double>& misconceptions() const { return misconceptions_; }
  bool has_hint_cost() const { return hint_cost_ > 0; }
  /// What a student is told about the points, apart from lateness.
  std::vector<std::string> rules(bool hints_are_known) const;

 private:
  std::string title_;
  std::deque<CardExercise> entries_;
  std::vector<Exercise> exercises_;
  std::string due_text_;
  std::optional<std::int64_t> due_;
  struct Late {
    double per_day = 0.0;
    int latest_day = 0;
  };
  std::optional<Late> late_;
  double hint_cost_ = 0.0;
  /// What wrong values earn for the cases at which they are right: nothing, the share of the cases, or that of the
  /// groups of cases that are right in full.
  enum class Partial { none, cases, groups };
  double earned(const Judgement& judgement, const ExerciseReference& reference,
                const std::vector<std::string>& misconceptions) const;

  Partial partial_ = Partial::none;
  std::map<std::string, double> misconceptions_;
};

}  // namespace workbook
