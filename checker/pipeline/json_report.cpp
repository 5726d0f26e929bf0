// A result as programs read it.
#include "checker/pipeline/check_exercise.hpp"

#include <nlohmann/json.hpp>

namespace workbook {

namespace {

using nlohmann::ordered_json;

/// The case at which it first failed: what went in, what should have come out, and what did.
ordered_json first_failure(const CheckResult& checked) {
  if (!checked.first_failure()) return nullptr;
  const ExerciseReference& reference = *checked.reference;
  const std::size_t index = *checked.first_failure();
  const Case& failed = reference.cases[index];
  ordered_json inputs = ordered_json::object();
  for (std::size_t i = 0; i < reference.arguments.size(); ++i)
    inputs[reference.arguments[i].name] = json_of(failed.inputs[i], reference.arguments[i].kind);
  // A value of another shape than the contract's is told by its shape alone.
  const std::optional<Value> actual = answers_of(reference, checked.observation.replies)[index];
  return {{"case", failed.name},
          {"number", index + 1},
          {"inputs", inputs},
          {"expected", json_of(failed.expected, reference.result_kind)},
          {"actual", actual ? json_of(*actual, reference.result_kind) : nlohmann::json(nullptr)},
          {"tolerance", failed.tolerance}};
}

ordered_json result_of(const CheckResult& checked) {
  const Judgement& judgement = checked.judgement;
  ordered_json failing = ordered_json::array();
  for (const std::size_t i : judgement.failing) failing.push_back(i + 1);
  ordered_json result = {
      {"lecture", checked.task.exercise.lecture()},
      {"exercise", checked.name()},
      {"verdict", to_string(judgement.verdict)},
      // Our own failures get no score (null), not 0.
      {"score", checked.is_judged() ? ordered_json(checked.score()) : ordered_json(nullptr)},
      {"points", checked.points()},
      {"cases", {{"passed", judgement.cases_passed()}, {"total", judgement.cases_total}, {"failing", failing}}},
      {"message", judgement.message},
      {"diagnosis", ordered_json::array()},
      {"first_failure", first_failure(checked)},
      {"findings", ordered_json::array()}};
  for (const Reason& reason : checked.reasons)
    if (reason.is_in_code())
      result["findings"].push_back({{"name", reason.name},
                                    {"line", reason.line},
                                    {"column", reason.column},
                                    {"excerpt", reason.excerpt},
                                    {"message", reason.sentence},
                                    {"notes", reason.notes}});
    else
      result["diagnosis"].push_back({{"kind", to_string(reason.kind)},
                                     {"name", reason.name},
                                     {"message", reason.sentence},
                                     {"notes", reason.notes}});
  for (std::size_t index = 0; index < checked.observation.replies.size(); ++index)
    if (const std::string& text = checked.observation.replies[index].printed; !text.empty())
      result["printed"].push_back({{"case", index + 1}, {"text", text}});
  for (std::size_t k = 0; k < checked.observation.measured.size(); ++k) {
    const Reply& reply = checked.observation.measured[k];
    const bool has_result = reply.ending == Ending::returned;
    const Measured& real = checked.reference->measured[k];
    result["measured"].push_back(
        {{"name", real.name},
         {"result", has_result ? json_of(reply.value, checked.reference->result_kind) : nlohmann::json(nullptr)},
         {"errors", real.errors}});
  }
  if (const std::string next = checked.next_step(); !next.empty()) result["next"] = next;
  if (checked.task.exercise.entry->is_problem()) result["stage"] = checked.task.stage;
  if (!checked.by_hand.empty()) result["by_hand"] = checked.by_hand;
  if (!checked.weak_sandbox.empty()) result["sandbox"] = checked.weak_sandbox;
  if (!judgement.waiting_for.empty()) result["waiting_for"] = judgement.waiting_for;
  if (!checked.observation.refusal_details.empty()) result["details"] = checked.observation.refusal_details;
  result["seconds"] = {{"compile", checked.observation.compile_seconds}, {"run", checked.observation.run_seconds}};
  return result;
}

}  // namespace

std::string json_report(const std::vector<CheckResult>& results, std::uint64_t seed) {
  ordered_json document = {{"format", 2}, {"seed", seed}, {"results", ordered_json::array()}};
  for (const CheckResult& checked : results) document["results"].push_back(result_of(checked));
  // What the student printed may hold bytes that are no text; they are replaced, not fatal.
  return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string decided_by_hand(const ordered_json& student) {
  std::vector<std::string> sentences;
  if (student.contains("by_hand")) sentences.push_back(student.at("by_hand"));
  for (const ordered_json& mark : student.at("results"))
    if (mark.contains("by_hand"))
      sentences.push_back(
          fmt::format("{}: {}", mark.at("exercise").get<std::string>(), mark.at("by_hand").get<std::string>()));
  return fmt::format("{}", fmt::join(sentences, "; "));
}

}  // namespace workbook
