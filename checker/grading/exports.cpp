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

std::string number(const ordered_json& value) {
  return value.is_number() ? fmt::format("{:g}", value.get<double>()) : "";
}

std::string text(const ordered_json& of, const char* key) { return of.value(key, ""); }

bool is_excused(const ordered_json& mark) { return mark.at("points") == 0; }

/// As judged, or by hand.
bool is_right(const ordered_json& mark) {
  return mark.at("verdict") == "passed" || (mark.at("score").is_number() && mark.at("score") >= mark.at("points"));
}

std::string grades_csv(const ordered_json& document) {
  Table table = {{"id", "name", "score", "possible", "days_late"}};
  for (const ordered_json& exercise : document.at("exercises")) table[0].push_back(exercise.at("exercise"));
  table[0].emplace_back("by_hand");
  for (const ordered_json& student : document.at("students")) {
    if (!student.at("in_tables")) continue;
    table.push_back({student.at("id"), student.at("name"), number(student.at("score")), number(student.at("possible")),
                     number(student.at("days_late"))});
    for (const ordered_json& mark : student.at("results"))
      table.back().push_back(is_excused(mark) ? "excused" : number(mark.at("score")));
    table.back().push_back(decided_by_hand(student));
  }
  return write_csv(table);
}

/// What gradebooks take.
Table gradebook(const ordered_json& document, const std::vector<std::string>& heading,
                const std::function<std::vector<std::string>(const std::string& id, const std::string& name)>& row) {
  const std::string title = document.at("title");
  Table table = {heading};
  table[0].push_back(title.empty() ? "Rigid Body Workbook" : title);
  for (const ordered_json& student : document.at("students")) {
    if (!student.at("in_gradebooks")) continue;
    table.push_back(row(student.at("id"), student.at("name")));
    table.back().push_back(number(student.at("score")));
  }
  return table;
}

/// The instructor says at the import which column is which. https://docs.moodle.org/en/Grade_import
std::string moodle_csv(const ordered_json& document) {
  const auto row = [](const std::string& id, const std::string& name) { return std::vector{id, name}; };
  return write_csv(gradebook(document, {"ID number", "Full name"}, row));
}

/// Columns and the second row as lib/gradebook_importer.rb of Canvas demands them. It takes digits in the second column
/// for its own number of a student, and looks for others in the next two.
std::string canvas_csv(const ordered_json& document) {
  const std::vector<std::string> heading = {"Student", "ID", "SIS User ID", "SIS Login ID", "Section"};
  Table table = gradebook(document, heading, [](const std::string& id, const std::string& name) {
    const bool is_number = id.find_first_not_of("0123456789") == std::string::npos;
    const std::string own = is_number ? id : "", other = is_number ? "" : id;
    return std::vector<std::string>{name.empty() ? id : name, own, other, other, ""};
  });
  double possible = 0;
  for (const ordered_json& exercise : document.at("exercises")) possible += exercise.at("points").get<double>();
  table.insert(table.begin() + 1, {"    Points Possible", "", "", "", "", number(possible)});
  return write_csv(table);
}

/// What the forms of other systems are filled with. Numbers are texts, which keep their digits; points are also in
/// hundredths, for who takes whole numbers only. @param about  the student
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
                             {"points", mark.at("points").dump()},
                             {"score", mark.at("score").dump()},
                             {"status", status},
                             {"is_judged", is_judged},
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
  return {{"id", about.at("id")},
          {"sandbox", sandbox},
          {"output", fmt::format("{}", fmt::join(notes, "\n"))},
          {"score", about.at("score").dump()},
          {"possible", about.at("possible").dump()},
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

std::string junit_xml(const ordered_json& document) {
  std::string suites;
  for (const ordered_json& student : document.at("students"))
    suites += filled_text(page_template("junit.xml"), "junit.xml",
                          form_values(student, student.at("results"), document.at("sandbox")));
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n", suites);
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
  return {{"grades.csv", grades_csv(document)},
          {"moodle.csv", moodle_csv(document)},
          {"canvas.csv", canvas_csv(document)},
          {"junit.xml", junit_xml(document)}};
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
