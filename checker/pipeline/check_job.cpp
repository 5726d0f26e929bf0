#include "checker/pipeline/check_exercise.hpp"

#include "checker/base/text.hpp"

#include <nlohmann/json.hpp>

#include <cstring>

namespace workbook {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, line, excerpt, sentence, name, column)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Judgement, verdict, message, next_step, failing, cases_total, waiting_for)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Explanation, findings, diagnoses)

/// Between processes numbers travel bit by bit: NaN and infinity as well.
static void to_json(json& part, const Reply& reply) {
  part = {static_cast<int>(reply.ending), reply.value.rows, reply.value.cols, reply.value.numbers, reply.printed};
}
static void from_json(const json& part, Reply& reply) {
  reply.ending = static_cast<Ending>(part.at(0).get<int>());
  reply.value = {part.at(1), part.at(2), part.at(3)};
  reply.printed = part.at(4);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Repeat, case_index, reply)
// What reports show of an observation; the rest has done its work by then.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Observation, refusal_details, replies, repeats, compile_seconds, run_seconds)

static void to_json(json& part, const CheckResult& checked) {
  part = {{"source", checked.source},
          {"observation", checked.observation},
          {"judgement", checked.judgement},
          {"explanation", checked.explanation},
          {"executable", checked.executable.string()}};
}
static void from_json(const json& part, CheckResult& checked) {
  checked.source = part.at("source");
  checked.observation = part.at("observation");
  checked.judgement = part.at("judgement");
  checked.explanation = part.at("explanation");
  checked.executable = part.at("executable").get<std::string>();
}

namespace {

constexpr std::chrono::seconds longest_check{180};  // the limits of its parts together are shorter

/// A message: its length in eight bytes, and a result.
std::string message_of(const CheckResult& checked) {
  const std::string bytes = written_result(checked);
  const std::uint64_t size = bytes.size();
  return std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes;
}

}  // namespace

std::string written_result(const CheckResult& checked) {
  const std::vector<std::uint8_t> bytes = json::to_cbor(checked);
  return {bytes.begin(), bytes.end()};
}

CheckResult read_result(std::string_view bytes) { return json::from_cbor(bytes).get<CheckResult>(); }

CheckContext::CheckContext(const Course& course)
    : course_(course), toolchain_(read_toolchain(course.toolchain_file())) {}

const ExerciseReference& CheckContext::reference(const CheckTask& task) {
  const auto lecture = std::pair(task.exercise.lecture(), task.seed);
  const auto key = std::pair(task.exercise.name(), task.seed);
  if (const auto failed = failures_.find(lecture); failed != failures_.end()) throw ReferenceError(failed->second);
  if (!references_.contains(key)) {
    try {
      references_.emplace(key, course_.reference(lecture.first, task.seed, key.first).exercises.front());
    } catch (const std::exception& problem) {
      failures_.emplace(lecture, problem.what());
      throw ReferenceError(problem.what());
    }
  }
  return references_.at(key);
}

CheckJob::CheckJob(CheckContext& context, CheckTask task) : task_(std::move(task)) {
  try {
    reference_ = &context.reference(task_);
  } catch (const std::exception& problem) {
    problem_ = problem.what();
  }
  job_.emplace(
      [this, &context](const ForkedJob::Send& send) {
        if (!reference_) return message_of(failed_check(task_, problem_));
        return message_of(check_exercise(context.course(), context.toolchain(), task_, *reference_,
                                         [&](const CheckResult& judged) { send(message_of(judged)); }));
      },
      longest_check);
}

std::optional<CheckResult> CheckJob::last_message() const {
  std::string_view rest = job_->output();
  std::optional<std::string_view> last;
  for (std::uint64_t size = 0; rest.size() >= sizeof size;) {
    std::memcpy(&size, rest.data(), sizeof size);
    rest.remove_prefix(sizeof size);
    if (rest.size() < size) break;
    last = rest.substr(0, size);
    rest.remove_prefix(size);
  }
  if (!last) return std::nullopt;
  CheckResult checked = read_result(*last);
  checked.task = task_;
  checked.reference = reference_;
  return checked;
}

CheckResult CheckJob::result() {
  const std::string trouble = job_->finish();
  try {
    if (const auto message = last_message()) return *message;  // what ends an explanation does not change the verdict
    throw std::runtime_error(trouble.empty() ? "it says nothing" : trouble);
  } catch (const std::exception& problem) {
    return failed_check(task_, fmt::format("The check of {} was not completed: {}.", task_.exercise.name(),
                                           without_full_stop(problem.what())));
  }
}

void check_all(CheckContext& context, const std::vector<CheckTask>& tasks,
               const std::function<void(CheckResult)>& deliver) {
  std::map<std::size_t, CheckResult> early;
  std::size_t turn = 0;
  run_jobs(
      tasks.size(), [&](std::size_t k) { return std::make_unique<CheckJob>(context, tasks[k]); },
      [&](std::size_t k, CheckJob& job) {
        early.emplace(k, job.result());
        for (; early.contains(turn); ++turn) deliver(std::move(early.extract(turn).mapped()));
      });
}

}  // namespace workbook
