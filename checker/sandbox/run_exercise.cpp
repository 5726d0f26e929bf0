#include "checker/sandbox/run_exercise.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace workbook {
namespace {

/// A sequence of calls in as few processes as possible: one, and a new one after each that failed.
class Session {
 public:
  Session(const std::filesystem::path& executable, const RunLimits& limits)
      : executable_(executable),
        profile_(limits.sandbox),
        budget_{Clock::now() + std::chrono::duration_cast<Clock::duration>(limits.time), limits.processor_time.count(),
                limits.output_bytes} {}

  Reply call(const PlannedCall& call) {
    Reply reply;
    if (used_up_) return reply;
    if (budget_.processor_seconds <= 0.0 || Clock::now() >= budget_.deadline) {
      reply.ending = Ending::time_limit;
    } else {
      if (!worker_) worker_.emplace(executable_, profile_, budget_);
      reply = worker_->call(call);
    }
    after(reply);
    return reply;
  }

  /// Ends the process; the next call gets a fresh one. `last`, the reply to the last call, is replaced if something
  /// came after it.
  void finish_process(Reply& last) {
    if (!worker_) return;
    Reply end = worker_->finish();
    after(end);
    worker_.reset();
    if (end.ending == Ending::returned) return;
    end.printed = last.printed;
    last = std::move(end);
  }

 private:
  void after(const Reply& reply) {
    if (worker_ && !worker_->running()) worker_.reset();
    if (reply.ending == Ending::time_limit || reply.ending == Ending::output_limit) used_up_ = true;
  }

  const std::filesystem::path& executable_;
  const SandboxProfile& profile_;
  Budget budget_;
  std::optional<Worker> worker_;
  bool used_up_ = false;
};

}  // namespace

ExerciseRunner::ExerciseRunner(std::filesystem::path executable, RunLimits limits)
    : executable_(std::move(executable)), limits_(std::move(limits)) {}

Observation ExerciseRunner::observe(const std::vector<Case>& cases, const std::vector<std::size_t>& repeats) {
  const Clock::time_point start = Clock::now();
  Observation observation;
  const auto planned = [](const Case& one) { return PlannedCall{one.inputs, one.expected.rows, one.expected.cols}; };
  try {
    Session session(executable_, limits_);
    for (const Case& one : cases) observation.replies.push_back(session.call(planned(one)));
    if (!cases.empty()) session.finish_process(observation.replies.back());
    for (const std::size_t index : repeats)
      observation.repeats.push_back({index, session.call(planned(cases.at(index)))});
    if (!repeats.empty()) session.finish_process(observation.repeats.back().reply);
  } catch (const LaunchError& error) {
    observation = {};
    observation.refusal = Refusal::checker_error;
    observation.refusal_message =
        fmt::format("The checker could not run the compiled function ({}); this is not your mistake.", error.what());
  }
  observation.run_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return observation;
}

std::vector<Reply> ExerciseRunner::evaluate(const std::vector<PlannedCall>& calls) {
  Session session(executable_, limits_);
  std::vector<Reply> replies;
  replies.reserve(calls.size());
  for (const PlannedCall& call : calls) replies.push_back(session.call(call));
  if (!replies.empty()) session.finish_process(replies.back());
  return replies;
}

}  // namespace workbook
