/// @file
/// The way of one exercise through the checker: read → compile → run → judge → explain. Each stage takes the values of
/// those before it; none runs twice and nothing is written backwards.
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/course/course.hpp"
#include "checker/data/observation.hpp"
#include "checker/judging/diagnosis.hpp"
#include "checker/judging/judge.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

/// Why a function failed: what is so in its code, and what its values tell. A help, never a grade.
struct Explanation {
  std::vector<Finding> findings;
  std::vector<Diagnosis> diagnoses;

  bool is_empty() const { return findings.empty() && diagnoses.empty(); }
};

/// What is to be checked.
struct CheckTask {
  Exercise exercise;
  std::filesystem::path file;
  std::uint64_t seed = 1;
  bool is_elsewhere = false;  ///< the file is not the exercise's own

  /// Verdicts on a file elsewhere, or with another seed, are no progress.
  bool counts_as_progress() const { return !is_elsewhere && seed == 1; }
};

/// One exercise, checked: what every report is made from.
struct CheckResult {
  CheckTask task;
  std::string source;  ///< the file's text as it was judged
  Observation observation;
  Judgement judgement;
  Explanation explanation;
  std::filesystem::path executable;  ///< for the plot; empty if the file did not compile
  const ExerciseReference* reference = nullptr;

  const std::string& name() const { return task.exercise.name(); }
  double points() const { return task.exercise.entry->points; }
  double score() const { return judgement.passed() ? points() : 0.0; }
  bool is_judged() const { return judgement.verdict != Verdict::checker_error; }
  bool is_started() const { return judgement.verdict != Verdict::not_started; }
  /// What to do: the explanation's own advice where there is one.
  std::string next_step() const;
};

/// The exercise's own file with the published seed, or the given ones.
CheckTask check_task(const Course& course, const Exercise& exercise, std::uint64_t seed = 1,
                     const std::optional<std::filesystem::path>& file = {});

/// Never throws for anything that a student's file can cause; trouble of our own comes back as the verdict
/// checker_error.
/// @param on_verdict  hears of the result before a failure is explained, which takes longer than judging
CheckResult check_exercise(const Course& course, const Toolchain& toolchain, const CheckTask& task,
                           const ExerciseReference& reference,
                           const std::function<void(const CheckResult&)>& on_verdict = {});

/// A result without a run: the checker itself failed.
CheckResult failed_check(const CheckTask& task, const std::string& reason);

}  // namespace workbook
