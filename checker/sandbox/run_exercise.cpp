#include "checker/sandbox/run_exercise.hpp"

#include "checker/base/printable.hpp"
#include "checker/messages/starting.hpp"
#include "checker/sandbox/worker_process.hpp"

#include <optional>

namespace workbook {
namespace {

Budget full_budget(const RunLimits& limits) {
  Budget budget;
  budget.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(limits.time);
  budget.processor_seconds = limits.processor_time.count();
  budget.output_bytes = limits.output_bytes;
  return budget;
}

/// A sequence of calls in as few processes as possible: one, and a new one after each that failed.
class Session {
 public:
  Session(Sandbox& sandbox, Budget& budget) : sandbox_(sandbox), budget_(budget) {}

  Reply call(const std::vector<Value>& inputs, int rows, int cols) {
    if (used_up_) return {};
    if (budget_.processor_seconds <= 0.0 || Clock::now() >= budget_.deadline) return out_of_time();
    if (!worker_) worker_.emplace(sandbox_, budget_);
    Reply reply = worker_->call(inputs, rows, cols);
    after(reply);
    return reply;
  }

  /// Ends the process; the next call gets a fresh one. `last`, the reply to the last call, is replaced if something
  /// came after it.
  void finish_process(Reply& last) {
    if (!worker_) return;
    const Reply shutdown_timeout = worker_->finish();
    if (shutdown_timeout.ending != Ending::returned) last = shutdown_timeout;
    after(shutdown_timeout);
    worker_.reset();
  }

 private:
  void after(const Reply& reply) {
    if (worker_ && !worker_->running()) worker_.reset();
    if (reply.ending == Ending::time_limit || reply.ending == Ending::output_limit) used_up_ = true;
  }

  Reply out_of_time() {
    used_up_ = true;
    Reply reply;
    reply.ending = Ending::time_limit;
    return reply;
  }

  Sandbox& sandbox_;
  Budget& budget_;
  std::optional<Worker> worker_;
  bool used_up_ = false;
};

}  // namespace

ExerciseRunner::ExerciseRunner(const std::filesystem::path& executable, RunLimits limits)
    : limits_(limits), sandbox_(executable, limits.sandbox) {}

Observation ExerciseRunner::observe(const std::vector<Case>& cases, const std::vector<std::size_t>& repeats) {
  const Clock::time_point start = Clock::now();
  Observation observation;
  Budget budget = full_budget(limits_);
  const auto ask = [](Session& session, const Case& one) {
    return session.call(one.inputs, one.expected.rows, one.expected.cols);
  };
  try {
    Session session(sandbox_, budget);
    for (const Case& one : cases) observation.replies.push_back(ask(session, one));
    if (!cases.empty()) session.finish_process(observation.replies.back());
    for (const std::size_t index : repeats) observation.repeats.push_back({index, ask(session, cases.at(index))});
    if (!repeats.empty()) session.finish_process(observation.repeats.back().reply);
  } catch (const LaunchError& error) {
    observation = {};
    observation.refusal = Refusal::checker_error;
    observation.refusal_message = messages::cannot_run(error.what());
  }
  observation.printed = printable(budget.printed);
  observation.run_seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return observation;
}

std::vector<Reply> ExerciseRunner::evaluate(const std::vector<PlannedCall>& calls) {
  Budget budget = full_budget(limits_);
  Session session(sandbox_, budget);
  std::vector<Reply> replies;
  replies.reserve(calls.size());
  for (const PlannedCall& call : calls) replies.push_back(session.call(call.inputs, call.rows, call.cols));
  if (!replies.empty()) session.finish_process(replies.back());
  return replies;
}

}  // namespace workbook
