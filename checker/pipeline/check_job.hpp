/// @file
/// Checks in processes of their own: whatever a file does to the checker, it ends that one check and no other.
#pragma once

#include "checker/base/forked_job.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace workbook {

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
  std::map<std::pair<std::string, std::uint64_t>, std::string> failures_;  ///< why a lecture has none
};

/// One running check. It is ended with this object, with all that it has started.
class CheckJob {
 public:
  CheckJob(CheckContext& context, CheckTask task);

  /// Becomes readable when there is something to collect.
  int descriptor() const { return job_->descriptor(); }
  /// Takes what has come so far. True once the job is over.
  bool collect() { return job_->collect(); }
  const CheckTask& task() const { return task_; }
  ForkedJob::Clock::time_point begun() const { return job_->begun(); }

  /// The verdict alone, as soon as it has been collected and until the result is there: its explanation may take a
  /// second longer.
  std::optional<CheckResult> verdict();

  /// The result; a job that crashed or ran for too long is a checker_error. Waits for the end.
  CheckResult result();

 private:
  /// The last whole message that has come.
  std::optional<CheckResult> last_message();

  const CheckTask task_;
  const ExerciseReference* reference_ = nullptr;  ///< read before the job begins, for others need it too
  std::string problem_;                           ///< why there is none
  std::optional<ForkedJob> job_;
};

/// Checks all tasks, as many at a time as there are processors, and hands over each result in the order of the tasks.
void check_all(CheckContext& context, const std::vector<CheckTask>& tasks,
               const std::function<void(CheckResult)>& deliver);

}  // namespace workbook
