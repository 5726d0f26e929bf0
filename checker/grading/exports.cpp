// The class document in the forms that other programs read.
#include "checker/grading/grading.hpp"

#include <fmt/chrono.h>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace workbook {

using nlohmann::ordered_json;

namespace {

std::string xml(const std::string& text) {
  std::string escaped = printable(text);
  for (const auto& [letter, entity] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    boost::replace_all(escaped, letter, entity);
  return escaped;
}

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

std::string junit_xml(const ordered_json& document) {
  const std::string head = fmt::format("    <properties><property name=\"sandbox\" value=\"{}\"/></properties>\n",
                                       xml(document.at("sandbox")));
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const ordered_json& student : document.at("students")) {
    std::string cases;
    int failures = 0, errors = 0, skipped = 0;
    for (const ordered_json& mark : student.at("results")) {
      const std::string verdict = mark.at("verdict"), message = xml(message_of(mark));
      std::string inside;
      if (is_excused(mark) || (verdict == "not_started" && !mark.contains("by_hand"))) {
        ++skipped;
        inside = "<skipped/>";
      } else if (mark.at("score").is_null()) {
        ++errors;
        inside = fmt::format("<error type=\"{}\" message=\"{}\"/>", verdict, message);
      } else if (!is_right(mark)) {
        ++failures;
        inside = fmt::format("<failure type=\"{}\" message=\"{}\"/>", verdict, message);
      }
      cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n", xml(student.at("id")),
                           xml(mark.at("exercise")), inside);
    }
    text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\">\n{}",
                        xml(student.at("id")), student.at("results").size(), failures, errors, skipped, head + cases);
    text += "  </testsuite>\n";
  }
  return text + "</testsuites>\n";
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

ordered_json gradescope_results(const ordered_json& student) {
  std::vector<std::string> notes = student.at("student").at("notes");
  notes.insert(notes.begin(), "Sandbox: " + student.at("sandbox").get<std::string>());
  const std::size_t days_late = student.at("student").at("days_late");
  if (student.at("student").contains("by_hand")) notes.push_back("By hand: " + text(student.at("student"), "by_hand"));
  if (days_late > 0) notes.push_back(fmt::format("Handed in {} late.", plural(days_late, "day")));
  ordered_json tests = ordered_json::array();
  for (const ordered_json& result : student.at("results")) {
    ordered_json test = {{"name", result.at("exercise")},
                         {"max_score", result.at("points")},
                         {"output", message_of(result)},
                         {"output_format", "text"}};
    if (result.at("score").is_number()) {
      test["score"] = result.at("score");
      test["status"] = is_right(result) ? "passed" : "failed";
    }
    tests.push_back(std::move(test));
  }
  return {{"score", student.at("student").at("score")},
          {"output", fmt::format("{}", fmt::join(notes, "\n"))},
          {"output_format", "text"},
          {"tests", tests}};
}

/// The last line that a grader prints for Autolab. https://docs.autolabproject.com/lab/
ordered_json autolab_scores(const ordered_json& student) {
  ordered_json scores = ordered_json::object();
  for (const ordered_json& result : student.at("results"))
    if (result.at("score").is_number()) scores[result.at("exercise").get<std::string>()] = result.at("score");
  return {{"scores", scores}};
}

/// What a runner hands to autograding-grading-reporter of GitHub Classroom, there in base64.
ordered_json github_classroom_result(const ordered_json& student) {
  ordered_json tests = ordered_json::array();
  std::string status = "pass";
  for (const ordered_json& result : student.at("results")) {
    const bool is_judged = result.at("score").is_number(), has_passed = is_right(result);
    const std::string of_test = !is_judged ? "error" : has_passed ? "pass" : "fail";
    if (!has_passed && status != "error") status = of_test;
    tests.push_back({{"name", result.at("exercise")},
                     {"status", of_test},
                     {"score", is_judged ? result.at("score") : ordered_json(0)},
                     {"message", message_of(result)},
                     {"line_no", 0}});
  }
  return {{"version", 1}, {"status", status}, {"max_score", student.at("student").at("possible")}, {"tests", tests}};
}

/// result.json of Classroom 50, schemas/result-v1.schema.json there, whose runner says in its environment what is
/// graded. Points are whole numbers, so that ours are given in hundredths.
ordered_json classroom50_result(const ordered_json& student) {
  ordered_json document = {{"schema", "classroom50/result/v1"},
                           {"classroom", environment("CLASSROOM")},
                           {"assignment", environment("ASSIGNMENT")},
                           {"assignment_type", environment("ASSIGNMENT_TYPE")},
                           {"owner", environment("OWNER")},
                           {"submission", environment("SUBMISSION_TAG")},
                           {"commit", environment("COMMIT_URL")},
                           {"release", environment("RELEASE_URL")},
                           {"review", environment("REVIEW_URL")},
                           {"datetime", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))}};
  const auto hundredths = [](const ordered_json& points) { return std::lround(100 * points.get<double>()); };
  long score = 0, most = 0;
  ordered_json tests = ordered_json::array();
  for (const ordered_json& result : student.at("results")) {
    if (!result.at("score").is_number()) continue;
    score += hundredths(result.at("score"));
    most += hundredths(result.at("points"));
    tests.push_back({{"test-name", result.at("exercise")},
                     {"passed", is_right(result)},
                     {"score", hundredths(result.at("score"))},
                     {"max-score", hundredths(result.at("points"))},
                     {"message", message_of(result)}});
  }
  document["score"] = score;
  document["max-score"] = most;
  document["tests"] = tests;
  return document;
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
  std::map<std::string, std::string> texts = {{"gradescope", indented(gradescope_results(student))},
                                              {"autolab", autolab_scores(student).dump() + "\n"},
                                              {"github_classroom", indented(github_classroom_result(student))}};
  if (!environment("CLASSROOM", "").empty()) texts.emplace("classroom50", indented(classroom50_result(student)));
  return texts;
}

}  // namespace workbook
