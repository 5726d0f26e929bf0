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

/// With as many digits as it has, and no others.
std::string number(const ordered_json& value) { return fmt::format("{:.10g}", value.get<double>()); }

std::string text(const ordered_json& of, const char* key) { return of.value(key, ""); }

bool is_excused(const ordered_json& mark) { return mark.at("points") == 0; }

/// As judged, or by hand.
bool is_right(const ordered_json& mark) {
  return mark.at("verdict") == "passed" || (mark.at("score").is_number() && mark.at("score") >= mark.at("points"));
}

/// What the forms of other systems are filled with. Points are also in hundredths, for who takes whole numbers only.
/// Canvas takes digits for its own number of a student. @param about  the student
nlohmann::json form_values(const ordered_json& about, const ordered_json& results, const ordered_json& sandbox) {
  std::vector<std::string> notes = about.value("notes", std::vector<std::string>());
  notes.insert(notes.begin(), "Sandbox: " + sandbox.get<std::string>());
  if (about.contains("by_hand")) notes.push_back("By hand: " + text(about, "by_hand"));
  if (about.at("days_late") > 0)
    notes.push_back(fmt::format("Handed in {} late.", plural(about.at("days_late"), "day")));
  const double score = about.at("score"), possible = about.at("possible");
  nlohmann::json all = nlohmann::json::array(), judged = all;
  std::map<std::string, int> counts;
  std::array<long, 2> hundredths{};
  for (const ordered_json& mark : results) {
    const bool is_judged = mark.at("score").is_number();
    const bool is_skipped = is_excused(mark) || (mark.at("verdict") == "not_started" && !mark.contains("by_hand"));
    const std::string status = !is_judged ? "error" : is_right(mark) ? "pass" : "fail";
    ++counts[status];
    ++counts[is_skipped ? "skipped" : status + " of those left"];
    const long most = std::lround(100 * mark.at("points").get<double>());
    const long earned = is_judged ? std::lround(100 * mark.at("score").get<double>()) : 0;
    std::string message = message_of(mark);
    if (mark.contains("diagnosis") && !mark.at("diagnosis").empty())
      message += " " + printable(text(mark.at("diagnosis").front(), "message"));
    nlohmann::json values = {{"exercise", mark.at("exercise")},
                             {"verdict", mark.at("verdict")},
                             {"message", message},
                             {"points", number(mark.at("points"))},
                             {"score", is_judged ? number(mark.at("score")) : "null"},
                             {"status", status},
                             {"is_judged", is_judged},
                             {"is_excused", is_excused(mark)},
                             {"is_right", is_right(mark)},
                             {"is_skipped", is_skipped},
                             {"is_error", !is_skipped && !is_judged},
                             {"hundredths", std::to_string(earned)},
                             {"most_hundredths", std::to_string(most)},
                             {"is_failure", !is_skipped && status == "fail"}};
    for (nlohmann::json* list : {&all, &judged}) {
      if (list == &judged && !is_judged) continue;
      values["comma"] = list->empty() ? "" : ", ";
      list->push_back(values);
    }
    if (is_judged) hundredths = {hundredths[0] + earned, hundredths[1] + most};
  }
  const std::string id = about.at("id");
  return {{"id", id},
          {"is_number", id.find_first_not_of("0123456789") == std::string::npos},
          {"name", about.at("name")},
          {"decided", about.contains("results") ? decided_by_hand(about) : ""},
          {"days_late", about.at("days_late")},
          {"sandbox", sandbox},
          {"output", fmt::format("{}", fmt::join(notes, "\n"))},
          {"score", number(about.at("score"))},
          {"possible", number(about.at("possible"))},
          {"share", fmt::format("{:.6f}", possible > 0 ? std::min(1.0, score / possible) : 0.0)},
          {"hundredths", std::to_string(hundredths[0])},
          {"most_hundredths", std::to_string(hundredths[1])},
          {"status", counts["error"] > 0  ? "error"
                     : counts["fail"] > 0 ? "fail"
                                          : "pass"},
          {"tests", results.size()},
          {"skipped", counts["skipped"]},
          {"errors", counts["error of those left"]},
          {"failures", counts["fail of those left"]},
          {"results", all},
          {"judged", judged}};
}

}  // namespace

std::string message_of(const ordered_json& mark) {
  const std::string message = mark.at("verdict") == "passed" ? "" : printable(text(mark, "message"));
  if (!mark.contains("by_hand")) return message;
  return fmt::format("{}{}By hand: {}", message, message.empty() ? "" : " ", text(mark, "by_hand"));
}

std::string indented(const ordered_json& document) {
  return document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::map<std::string, std::string> class_exports(const ordered_json& document) {
  std::map<std::string, std::string> texts;
  const auto add = [&](const nlohmann::json& values) {
    for (const char* form : {"grades.csv", "moodle.csv", "canvas.csv", "junit.xml"})
      texts[form] += filled_text(page_template(form), form, values);
  };
  double possible = 0;
  for (const ordered_json& exercise : document.at("exercises")) possible += exercise.at("points").get<double>();
  const std::string title = text(document, "title");
  add({{"heading", true},
       {"title", title.empty() ? "Rigid Body Workbook" : title},
       {"possible", number(possible)},
       {"results", document.at("exercises")}});
  for (const ordered_json& student : document.at("students")) {
    nlohmann::json values = form_values(student, student.at("results"), document.at("sandbox"));
    values["in_class"] = true;
    for (const char* list : {"in_tables", "in_gradebooks"}) values[list] = student.at(list);
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
  std::map<std::string, std::string> texts;
  for (const char* form :
       {"gradescope.json", "autolab.txt", "github_classroom.json", "classroom50.json", "prairielearn.json"}) {
    const fs::path name = form;
    if (name.stem() == "classroom50" && environment("CLASSROOM").empty()) continue;
    texts[name.stem() / (text(about, "slug") + name.extension().string())] =
        filled_text(page_template(form), name, values);
  }
  return texts;
}

}  // namespace workbook
