// The class document in the forms that other programs read.
#include "checker/grading/grading.hpp"
#include "checker/templates/templates.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace workbook {

using nlohmann::ordered_json;

namespace {

/// What the forms of other systems are filled with. Points are also in hundredths, for who takes whole numbers only.
/// Canvas takes digits for its own number of a student. @param about  the student
nlohmann::json form_values(const ordered_json& about, const ordered_json& results, const ordered_json& sandbox) {
  std::vector<std::string> notes = about.value("notes", std::vector<std::string>());
  notes.insert(notes.begin(), "Sandbox: " + sandbox.get<std::string>());
  if (about.contains("by_hand")) notes.push_back("By hand: " + about.value("by_hand", ""));
  if (about.at("days_late") > 0)
    notes.push_back(fmt::format("Handed in {} late.", plural(about.at("days_late"), "day")));
  const double score = about.at("score"), possible = about.at("possible");
  nlohmann::json all = nlohmann::json::array(), judged = all;
  std::map<std::string, int> statuses, outcomes;  // for GitHub and JUnit, which knows what is skipped
  long hundredths = 0, most_hundredths = 0;
  for (const ordered_json& mark : results) {
    const bool is_judged = mark.at("score").is_number(), is_excused = mark.at("points") == 0;
    const bool is_right = mark.at("verdict") == "passed" || (is_judged && mark.at("score") >= mark.at("points"));
    const std::string status = !is_judged ? "error" : is_right ? "pass" : "fail";
    const bool is_skipped = is_excused || (mark.at("verdict") == "not_started" && !mark.contains("by_hand"));
    const std::string outcome = is_skipped ? "skipped" : status;
    ++statuses[status];
    ++outcomes[outcome];
    std::string message = message_of(mark);
    if (mark.contains("diagnosis") && !mark.at("diagnosis").empty())
      message += " " + printable(mark.at("diagnosis").front().value("message", ""));
    nlohmann::json values = {{"message", message},
                             {"status", status},
                             {"is_judged", is_judged},
                             {"is_excused", is_excused},
                             {"is_right", is_right},
                             {"outcome_" + outcome, true},
                             {"hundredths", is_judged ? std::lround(100 * mark.at("score").get<double>()) : 0},
                             {"most_hundredths", std::lround(100 * mark.at("points").get<double>())}};
    for (const char* same : {"exercise", "verdict", "points", "score"}) values[same] = mark.at(same);
    all.push_back(values);
    if (!is_judged) continue;
    judged.push_back(values);
    hundredths += values.at("hundredths").get<long>();
    most_hundredths += values.at("most_hundredths").get<long>();
  }
  const std::string id = about.at("id");
  nlohmann::json values = about;
  values.update({{"is_number", id.find_first_not_of("0123456789") == std::string::npos},
                 {"decided", about.contains("results") ? decided_by_hand(about) : ""},
                 {"sandbox", sandbox},
                 {"output", fmt::format("{}", fmt::join(notes, "\n"))},
                 {"share", fmt::format("{:.6f}", possible > 0 ? std::min(1.0, score / possible) : 0.0)},
                 {"hundredths", hundredths},
                 {"most_hundredths", most_hundredths},
                 {"status", statuses["error"] > 0  ? "error"
                            : statuses["fail"] > 0 ? "fail"
                                                   : "pass"},
                 {"tests", results.size()},
                 {"skipped", outcomes["skipped"]},
                 {"errors", outcomes["error"]},
                 {"failures", outcomes["fail"]},
                 {"results", all},
                 {"judged", judged}});
  return values;
}

}  // namespace

std::string message_of(const ordered_json& mark) {
  const std::string message = mark.at("verdict") == "passed" ? "" : printable(mark.value("message", ""));
  if (!mark.contains("by_hand")) return message;
  return fmt::format("{}{}By hand: {}", message, message.empty() ? "" : " ", mark.value("by_hand", ""));
}

std::map<std::string, std::string> class_exports(const ordered_json& document) {
  std::map<std::string, std::string> texts;
  const auto add = [&](const nlohmann::json& values) {
    for (const auto& [form, text] : filled_forms({"grades.csv", "moodle.csv", "canvas.csv", "junit.xml"}, values))
      texts[form] += text;
  };
  double possible = 0;
  for (const ordered_json& exercise : document.at("exercises")) possible += exercise.at("points").get<double>();
  add({{"heading", true},
       {"title", document.at("title")},
       {"possible", possible},
       {"results", document.at("exercises")}});
  for (const ordered_json& student : document.at("students")) {
    nlohmann::json values = form_values(student, student.at("results"), document.at("sandbox"));
    values["in_class"] = true;
    add(values);
  }
  add({{"end", true}});
  return texts;
}

std::map<std::string, std::string> student_exports(const ordered_json& student) {
  const ordered_json& about = student.at("student");
  nlohmann::json values = form_values(about, student.at("results"), student.at("sandbox"));
  // The runner of Classroom 50 says in its environment what is graded.
  for (const char* name : {"CLASSROOM", "ASSIGNMENT", "ASSIGNMENT_TYPE", "OWNER", "SUBMISSION_TAG", "COMMIT_URL",
                           "RELEASE_URL", "REVIEW_URL"})
    values[name] = environment(name);
  values["now"] = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
  std::vector<const char*> forms = {"gradescope.json", "autolab.txt", "github_classroom.json", "prairielearn.json"};
  if (!environment("CLASSROOM").empty()) forms.push_back("classroom50.json");
  std::map<std::string, std::string> texts;
  for (const auto& [form, text] : filled_forms(forms, values))
    texts[form.stem() / (about.value("slug", "") + form.extension().string())] = text;
  return texts;
}

}  // namespace workbook
