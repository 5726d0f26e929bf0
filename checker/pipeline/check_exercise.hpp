/// @file
/// The way of one exercise through the checker: read → compile → run → judge → explain. Each stage takes the values of
/// those before it; none runs twice and nothing is written backwards.
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/course/course.hpp"
#include "checker/data/observation.hpp"
#include "checker/explain/explain.hpp"
#include "checker/judging/judge.hpp"
#include "checker/source/submission.hpp"

#include <nlohmann/json_fwd.hpp>

namespace workbook {

struct CheckResult;

/// What is to be checked.
struct CheckTask {
  Exercise exercise;
  fs::path file;
  std::uint64_t seed = 1;
  bool is_elsewhere = false;   ///< the file is not the exercise's own
  bool is_other_seed = false;  ///< the cases are not those that count
  /// Of cases whose results students have: who fails is looked at for having learnt these.
  std::optional<std::uint64_t> known_seed = {};
  bool is_explained = true;                             ///< a failure gets its reasons
  bool is_always_drawn = false;                         ///< its values along the plot are asked for also if it passes
  std::function<void(CheckResult& checked)> draw = {};  ///< makes the picture of these, in the process of the check
  std::vector<PlannedCall> further = {};                ///< what it is asked besides, if it passes
  int stage = last_stage;                               ///< how much of them is told of a problem, 1 to last_stage: all

  static constexpr int last_stage = 3;

  /// Verdicts on a file elsewhere, or with another seed, are no progress.
  bool counts_as_progress() const { return !is_elsewhere && !is_other_seed; }
};

/// One exercise, checked: what every report is made from.
struct CheckResult {
  CheckTask task;
  std::string source;  ///< the file's text as it was judged
  Observation observation;
  Judgement judgement;
  std::vector<Reason> reasons;  ///< why it failed, those in the code first
  const ExerciseReference* reference = nullptr;
  std::string picture;              ///< the plot: SVG in base64; empty: none
  std::string picture_description;  ///< what it shows, in words
  std::string weak_sandbox;         ///< what held the function back no further than that; empty: it could reach nothing
  std::optional<double> share;      ///< of the points that it earns, where that is not all or nothing
  std::string by_hand;  ///< what a person has decided about it, in one sentence; such points take the place of others
  std::optional<double> points_by_hand;
  bool is_excused = false;  ///< by hand: it is not counted

  const std::string& name() const { return task.exercise.name(); }
  double points() const { return is_excused ? 0.0 : task.exercise.entry->points; }
  double score() const { return points_by_hand.value_or(points() * share.value_or(judgement.passed() ? 1.0 : 0.0)); }
  bool is_judged() const { return judgement.verdict != Verdict::checker_error || is_excused || points_by_hand; }
  bool is_started() const { return judgement.verdict != Verdict::not_started; }
  /// The case to be shown of a failure, where there are values.
  std::optional<std::size_t> first_failure() const;
  /// The same where two functions returned the same values at all cases.
  std::string fingerprint_of_values() const;
  /// What to do; "" where there are reasons, which say more.
  std::string next_step() const;
};

/// Names of exercises other than this one whose functions a text defines itself.
std::vector<std::string> own_names(const std::string& text, const std::vector<Exercise>& exercises,
                                   const std::string& exercise);

/// The files of the exercises that a text names, and of those that these name: what it may call is among them.
/// @throws RejectedFile
std::vector<Submission> own_functions(const std::string& text, const std::vector<Exercise>& exercises,
                                      const std::function<fs::path(const Exercise&)>& file_of);

/// The task's file with those of earlier exercises whose functions it may call, directly or through another one.
/// @throws RejectedFile
Submission read_with_library(const Course& course, const CheckTask& task);

/// The exercise's own file with the seed of the course, or the given ones.
CheckTask check_task(const Course& course, const Exercise& exercise, std::optional<std::uint64_t> seed = {},
                     const std::optional<fs::path>& file = {});

/// A result without a run: the checker itself failed.
CheckResult failed_check(const CheckTask& task, const std::string& reason);

/// A result without a run: the file was not read, for the reason that the sentence tells the student.
CheckResult rejected_check(const CheckTask& task, const ExerciseReference& reference, const std::string& sentence);

/// A result without its task and reference, as bytes: to be handed to another process, or kept.
std::string written_result(const CheckResult& checked);
/// @throws std::exception if these are no such bytes
CheckResult read_result(std::string_view bytes);

/// The document of `check --json`; its form is described in the README.
std::string json_report(const std::vector<CheckResult>& results, std::uint64_t seed);

/// All that was decided by hand about a student, in the document about one or about a class; "": nothing.
std::string decided_by_hand(const nlohmann::ordered_json& student);

/// What all checks with one seed share: the toolchain, and the reference results, read once per exercise.
class CheckContext {
 public:
  /// @throws ToolchainError
  explicit CheckContext(const Course& course);

  const Course& course() const { return course_; }
  const Toolchain& toolchain() const { return toolchain_; }

  /// @throws ReferenceError
  const ExerciseReference& reference(const CheckTask& task);

  /// Trouble with reference results is remembered, so that the checks of a class meet it once.
  void forget_failures() { failures_.clear(); }

 private:
  const Course& course_;
  Toolchain toolchain_;
  std::map<std::pair<std::string, std::uint64_t>, ExerciseReference> references_;
  std::map<std::pair<std::string, std::uint64_t>, std::string> failures_;  ///< why there are none
};

/// Never throws for anything that a student's file can cause; trouble of our own comes back as the verdict
/// checker_error.
/// @param on_verdict  hears of the result before a failure is explained, which takes longer than judging
CheckResult check_exercise(CheckContext& context, const CheckTask& task,
                           const std::function<void(const CheckResult&)>& on_verdict = {});

// --- in processes of their own: whatever a file does to the checker, it ends that one check and no other

/// One running check. It is ended with this object, with all that it has started.
class CheckJob {
 public:
  CheckJob(CheckContext& context, CheckTask task);

  /// Becomes readable when there is something to collect.
  int descriptor() const { return job_->descriptor(); }
  /// Takes what has come so far. True once the job is over, or its time: then result() does not wait.
  bool collect();
  Clock::time_point begun() const { return job_->begun(); }
  const std::string& name() const { return task_.exercise.name(); }
  /// Time since the verdict, as far as it has been collected.
  Clock::duration explaining() const { return judged_ ? Clock::now() - *judged_ : Clock::duration(0); }

  /// The last whole message that has been collected: the verdict alone, until the result is there, for its explanation
  /// may take a second longer.
  std::optional<CheckResult> last_message() const;

  /// The result; a job that crashed or ran for too long is a checker_error. Waits for the end.
  CheckResult result();

 private:
  const CheckTask task_;
  const ExerciseReference* reference_ = nullptr;  ///< read before the job begins, for others need it too
  std::optional<ForkedJob> job_;
  std::optional<Clock::time_point> judged_;
};

/// Checks all tasks, as many at a time as there are processors, and hands over each result in the order of the tasks.
/// @param meanwhile  is told about every second what has become of one that is running
void check_all(CheckContext& context, const std::vector<CheckTask>& tasks,
               const std::function<void(CheckResult)>& deliver,
               const std::function<void(const CheckJob&)>& meanwhile = DoNothing());

}  // namespace workbook
