#include "checker/pipeline/check_exercise.hpp"

#include "checker/source/source_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <set>

namespace workbook {

using nlohmann::json;

// How a mistake is fixed has been tried by then.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Reason, kind, name, sentence, weight, notes, line, column, excerpt)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Judgement, verdict, message, next_step, failing, cases_total, waiting_for)

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
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Observation, refusal_details, replies, repeats, sweep, measured, further,
                                   compile_seconds, run_seconds)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CheckResult, source, observation, judgement, reasons, picture, picture_description,
                                   weak_sandbox)

namespace {

/// Another one for the tests.
std::chrono::seconds longest_check() {
  const std::string seconds = environment("WORKBOOK_CHECK_SECONDS");
  return seconds.empty() ? limits::check : std::chrono::seconds(std::atoi(seconds.c_str()));
}

/// A message: its length in eight bytes, and a result.
std::string message_of(const CheckResult& checked) {
  const std::string bytes = written_result(checked);
  const std::uint64_t size = bytes.size();
  return std::string(reinterpret_cast<const char*>(&size), sizeof size) + bytes;
}

/// An exercise's own file; where the checked file lies elsewhere, the one beside it, if there is one.
fs::path own_file(const Course& course, const CheckTask& task, const Exercise& exercise) {
  const fs::path beside = task.file.parent_path() / (exercise.name() + ".cpp");
  return task.is_elsewhere && fs::exists(beside) ? beside : course.student_file(exercise);
}

/// A file up to its judgement, with what explaining it needs.
struct Judged {
  CheckResult checked = {};
  Submission submission = {};
  Compilation compilation = {};
  std::optional<ExerciseRunner> runner = {};  ///< where it could be compiled

  CompileTask compile_task() const { return {submission, checked.reference->name, checked.reference->signature}; }
};

/// Right at all the cases that students have, and wrong at most others: its results were looked up. A function that
/// fails at few of the others has a mistake that the known cases do not show.
bool is_learnt(Judged& judged, CheckContext& context) {
  const CheckResult& checked = judged.checked;
  const ExerciseReference& drawn = *checked.reference;
  if (!checked.task.known_seed || checked.judgement.verdict == Verdict::time_limit) return false;
  CheckTask task = checked.task;
  task.seed = *task.known_seed;
  const ExerciseReference& known = context.reference(task);
  const Answers answers = answers_of(drawn, checked.observation.replies);
  std::ptrdiff_t others = 0, wrong = 0;
  for (std::size_t i = 0; i < drawn.cases.size(); ++i) {
    if (std::ranges::count(known.cases, drawn.cases[i].inputs, &Case::inputs) > 0) continue;
    ++others;
    wrong += answers[i] && passes(drawn, i, *answers[i]) ? 0 : 1;
  }
  return 2 * wrong > others &&
         judge(known, judged.runner->observe(plan_calls(known.cases), plan_repeats(known))).passed();
}

void explain_failure(Judged& judged, CheckContext& context) {
  const CheckResult& checked = judged.checked;
  const ExerciseReference& reference = *checked.reference;
  const Verdict verdict = checked.judgement.verdict;
  std::vector<Reason>& reasons = judged.checked.reasons;
  reasons = checked.observation.errors;
  if (!judged.runner || verdict == Verdict::checker_error) return;
  if (verdict == Verdict::passed || verdict == Verdict::not_started) {
    reasons = text_mistakes(SourceText(judged.submission.text));
    std::erase_if(reasons, std::mem_fn(&Reason::needs_failure));
    return;
  }
  if (is_learnt(judged, context)) {
    reasons = {{ReasonKind::learnt, "learnt",
                "Your function is right at the cases whose results are in your copy of the workbook, and wrong at most "
                "others: compute the result from the arguments."}};
    return;
  }
  if (!checked.task.is_explained) {
    judged.checked.judgement.next_step =
        "Check the file yourself: the reasons of other failures in this submission took all the time for them.";
    return;
  }
  const Ask ask = [&](const std::vector<PlannedCall>& calls) { return judged.runner->evaluate(calls); };
  reasons = explain({{judged.submission, reference, checked.observation, checked.judgement},
                     judged.compile_task(),
                     judged.compilation,
                     ask,
                     context.toolchain(),
                     context.course().compiled()});
  const Answers answers = answers_of(reference, checked.observation.replies);
  if (checked.task.stage < CheckTask::last_stage)
    hold_back(reasons, checked.task.stage, reference, answers);
  else if (reasons.empty() && has_values(verdict) && !reference.limits.empty())
    reasons = {where_it_fails(reference, answers)};
}

CheckResult missing_file(const CheckTask& task, const ExerciseReference& reference) {
  CheckResult checked;
  checked.task = task;
  checked.reference = &reference;
  checked.observation.replies.assign(reference.cases.size(), Reply{.ending = Ending::not_started});
  checked.judgement = judge(reference, checked.observation);
  checked.judgement.message = "You have not started this exercise: its file is missing.";
  checked.judgement.next_step =
      fmt::format("The file {} is missing: `{}` writes it.", shown_path(task.file), command("reset " + checked.name()));
  return checked;
}

/// What else a function that was judged is asked: data for plots, the report and locked texts. After it, all is data
/// but the runs that explain. @throws LaunchError
void ask_further(Judged& judged) {
  const CheckResult& checked = judged.checked;
  const ExerciseReference& reference = *checked.reference;
  Observation& observation = judged.checked.observation;
  const auto ask = [&](const std::vector<PlannedCall>& calls) {
    return calls.empty() ? std::vector<Reply>() : judged.runner->evaluate(calls);
  };
  std::vector<PlannedCall> sweep, measured;
  for (std::size_t i = 0; i < reference.sweep.x.size(); ++i)
    sweep.push_back({reference.sweep.inputs[i], reference.sweep.expected[i].rows, reference.sweep.expected[i].cols});
  const Value& like = reference.cases.front().expected;
  for (const Measured& real : reference.measured) measured.push_back({real.inputs, like.rows, like.cols});
  if (checked.task.is_always_drawn || checked.judgement.verdict == Verdict::wrong_value) observation.sweep = ask(sweep);
  if (!checked.judgement.passed()) return;
  observation.measured = ask(measured);
  observation.further = ask(checked.task.further);
}

/// read → compile → run → judge. @throws RejectedFile, std::runtime_error
Judged judge_file(CheckContext& context, const CheckTask& task) {
  Judged judged;
  CheckResult& checked = judged.checked;
  checked.task = task;
  checked.reference = &context.reference(task);
  judged.submission = read_with_library(context.course(), task);
  checked.source = judged.submission.text;
  if (const SandboxStrength& sandbox = sandbox_in_use(); sandbox.tier() < SandboxTier::minimal)
    checked.weak_sandbox = fmt::format("Sandbox: {}.", sandbox.sentence());
  judged.compilation = compile(judged.compile_task(), context.toolchain(), context.course().compiled());
  if (judged.compilation.executable) {
    judged.runner.emplace(judged.compilation.program());
    checked.observation =
        judged.runner->observe(plan_calls(checked.reference->cases), plan_repeats(*checked.reference));
    checked.observation.compile_seconds = judged.compilation.seconds;
  } else {
    checked.observation = refused(judged.compilation);
  }
  checked.judgement = judge(*checked.reference, checked.observation);
  return judged;
}

/// A failure may be that of an own function that is linked: if one of these does not pass itself, the exercise waits
/// for it.
void wait_for_own_functions(CheckContext& context, const CheckTask& task, const std::vector<std::string>& linked,
                            Judgement& judgement) {
  std::vector<std::string> waited_for, reasons, commands;
  for (const std::string& name : linked) {
    const Exercise exercise = context.course().find_exercise(name);
    const CheckTask own = check_task(context.course(), exercise, task.seed, own_file(context.course(), task, exercise));
    const Judgement of_own = judge_file(context, own).checked.judgement;
    if (of_own.passed() || of_own.verdict == Verdict::checker_error) continue;  // our own failure says nothing of it
    waited_for.push_back(name);
    reasons.push_back(fmt::format("{} ({})", name, in_words(to_string(of_own.verdict))));
    const std::string file = own.is_elsewhere ? " --file " + shell_quoted(own.file.string()) : "";
    commands.push_back(fmt::format("`{}`", command(fmt::format("check {}{}", name, file))));
  }
  if (reasons.empty()) return;
  judgement.verdict = Verdict::waiting;
  judgement.waiting_for = waited_for;
  judgement.message = fmt::format("Your function calls your own {}; once {}, it can be judged.",
                                  fmt::join(reasons, " and "), reasons.size() == 1 ? "that passes" : "those pass");
  judgement.next_step = fmt::format("First {}.", listed(commands));
}

}  // namespace

std::optional<std::size_t> CheckResult::first_failure() const {
  if (judgement.failing.empty() || reference == nullptr || observation.replies.empty()) return std::nullopt;
  return judgement.failing.front();
}

std::string CheckResult::fingerprint_of_values() const {
  std::string bytes;
  for (const Reply& reply : observation.replies)
    bytes.append(reinterpret_cast<const char*>(reply.value.numbers.data()),
                 reply.value.numbers.size() * sizeof(double));
  return fingerprint(bytes);
}

std::string CheckResult::next_step() const { return reasons.empty() ? judgement.next_step : ""; }

std::vector<std::string> own_names(const std::string& text, const std::vector<Exercise>& exercises,
                                   const std::string& exercise) {
  std::vector<std::string> names;
  std::optional<SourceText> source;
  for (const Exercise& other : exercises) {
    if (other.name() == exercise || text.find(other.name()) == std::string::npos) continue;
    if (!source) source.emplace(text);
    if (defines_function(*source, other.name())) names.push_back(other.name());
  }
  return names;
}

std::vector<Submission> own_functions(const std::string& text, const std::vector<Exercise>& exercises,
                                      const std::function<fs::path(const Exercise&)>& file_of) {
  std::set<std::string, std::less<>> words;
  const auto add_words = [&](const std::string& of) {
    const auto is_in_it = [&](const Exercise& exercise) { return of.find(exercise.name()) != std::string::npos; };
    if (std::ranges::none_of(exercises, is_in_it)) return;  // taking texts apart is what takes time
    const SourceText source(of);
    for (const Token& token : source.tokens()) words.emplace(token.text);
  };
  add_words(text);
  std::vector<Submission> files;
  // From the last to the first: each may name those before it.
  for (auto exercise = exercises.rbegin(); exercise != exercises.rend(); ++exercise) {
    if (!words.contains(exercise->name())) continue;
    const fs::path file = file_of(*exercise);
    if (!fs::exists(file)) continue;
    files.push_back(read_submission(file));
    files.back().own_names = own_names(files.back().text, exercises, exercise->name());
    add_words(files.back().text);
  }
  return files;
}

Submission read_with_library(const Course& course, const CheckTask& task) {
  Submission submission = read_submission(task.file);
  submission.library = own_functions(submission.text, course.exercises_before(task.exercise),
                                     [&](const Exercise& exercise) { return own_file(course, task, exercise); });
  submission.own_names = own_names(submission.text, course.exercises(), task.exercise.name());
  return submission;
}

CheckTask check_task(const Course& course, const Exercise& exercise, std::optional<std::uint64_t> seed,
                     const std::optional<fs::path>& file) {
  const fs::path own = course.student_file(exercise);
  return {exercise, file.value_or(own), seed.value_or(course.seed()), file && *file != own,
          seed && *seed != course.seed()};
}

CheckResult failed_check(const CheckTask& task, const std::string& reason) {
  CheckResult checked;
  checked.task = task;
  checked.observation.refusal = Refusal::checker_error;
  checked.observation.refusal_message = reason;
  checked.judgement = judge({}, checked.observation);
  return checked;
}

CheckResult rejected_check(const CheckTask& task, const ExerciseReference& reference, const std::string& sentence) {
  CheckResult checked = failed_check(task, sentence);
  checked.observation.refusal = Refusal::rejected_file;
  checked.judgement = judge(reference, checked.observation);
  return checked;
}

CheckResult check_exercise(CheckContext& context, const CheckTask& task,
                           const std::function<void(const CheckResult&)>& on_verdict) {
  Judged judged;
  try {
    const ExerciseReference& reference = context.reference(task);
    if (!task.is_elsewhere && !fs::exists(task.file)) return missing_file(task, reference);
    judged = judge_file(context, task);
  } catch (const RejectedFile& reason) {
    return rejected_check(task, context.reference(task), reason.what());
  } catch (const std::exception& problem) {
    return failed_check(task, problem.what());
  }
  CheckResult& checked = judged.checked;
  try {
    // What follows may take all the time of the check: reasons, and own functions.
    const bool takes_long = judged.runner || !judged.compilation.linked.empty();
    if (on_verdict && takes_long && !checked.judgement.passed()) on_verdict(checked);
    if (!checked.judgement.passed())
      wait_for_own_functions(context, task, judged.compilation.linked, checked.judgement);
    if (checked.judgement.verdict == Verdict::waiting) {
      checked.observation.replies.clear();  // values that say nothing of this file
    } else {
      if (judged.runner) ask_further(judged);
      explain_failure(judged, context);
      for (Reason& reason : checked.reasons)
        if (reason.is_in_code())
          reason.notes = paragraph_on_mistake(context.course(), reason.name);
        else if (reason.notes.empty())
          reason.notes = task.exercise.entry->notes;
      if (task.draw && !checked.observation.sweep.empty()) task.draw(checked);
    }
  } catch (const std::exception&) {  // a reason less; what was judged stands
  }
  return checked;
}

std::string written_result(const CheckResult& checked) {
  const std::vector<std::uint8_t> bytes = json::to_cbor(checked);
  return {bytes.begin(), bytes.end()};
}

CheckResult read_result(std::string_view bytes) { return json::from_cbor(bytes).get<CheckResult>(); }

CheckContext::CheckContext(const Course& course)
    : course_(course), toolchain_(read_toolchain(course.toolchain_file())) {
  try_sandbox_once(course.scratch() / "sandbox");  // once for all jobs
}

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
  } catch (const std::exception&) {  // the job says so
  }
  job_.emplace(
      [this, &context](const ForkedJob::Send& send) {
        return message_of(check_exercise(context, task_, [&](const CheckResult& judged) { send(message_of(judged)); }));
      },
      longest_check());
}

bool CheckJob::collect() {
  const bool is_over = job_->collect();
  if (!judged_ && !job_->output().empty()) judged_ = Clock::now();
  return is_over;
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
               const std::function<void(CheckResult)>& deliver, const std::function<void(const CheckJob&)>& meanwhile) {
  std::map<std::size_t, CheckResult> early;
  std::size_t turn = 0;
  run_jobs(
      tasks.size(), [&](std::size_t k) { return std::make_unique<CheckJob>(context, tasks[k]); },
      [&](std::size_t k, CheckJob& job) {
        early.emplace(k, job.result());
        for (; early.contains(turn); ++turn) deliver(std::move(early.extract(turn).mapped()));
      },
      meanwhile);
}

}  // namespace workbook
