#include "checker/report/reports.hpp"
#include "checker/templates/templates.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace workbook {

namespace {

using nlohmann::json;

constexpr std::size_t most_steps = 5;
constexpr std::size_t longest_text = std::size_t{48} << 10;  // of one printout or file, in bytes

std::string shortened_end(const std::string& text) {
  return text.size() <= longest_text ? text : cut(text, longest_text) + "\n… (the rest is too long to be shown here)";
}

struct Score {
  double points = 0.0;
  double possible = 0.0;

  void add(const CheckResult& checked) {
    if (checked.is_judged()) possible += checked.points();
    points += checked.score();
  }
  std::string text() const {
    return possible == 0 ? "Not counted"
                         : fmt::format("{:g} of {:g} point{}", points, possible, possible == 1 ? "" : "s");
  }
};

/// Where to read, as the lecture calls it.
std::string place_of(const std::string& anchor, const ReportedExercise& exercise, const ReportedCourse& course) {
  if (anchor.empty()) return "";
  const auto heading = course.headings.find(anchor);
  return fmt::format("the notes of lecture {}, “{}”", exercise.checked.task.exercise.lecture().substr(0, 2),
                     heading == course.headings.end() ? anchor : heading->second);
}

/// "kinetic_energy.cpp:8:3", without the folders of the machine that made the page.
std::string place_of(const Reason& reason, const CheckResult& checked) {
  if (reason.line <= 0) return "";
  return fmt::format("{}:{}:{}", checked.task.file.filename().string(), reason.line, std::max(reason.column, 1));
}

/// The file in pieces, of which those are marked that are lines with a reason.
json marked_source(const CheckResult& checked) {
  std::set<int> at_fault;
  for (const Reason& reason : checked.reasons) at_fault.insert(reason.line);
  json pieces = json::array();
  std::istringstream lines(shortened_end(checked.source));
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    const bool is_marked = at_fault.contains(number);
    if (pieces.empty() || is_marked || pieces.back().at("is_marked") != is_marked)
      pieces.push_back({{"is_marked", is_marked}, {"text", ""}});
    pieces.back()["text"] = pieces.back().at("text").get<std::string>() + line + "\n";
  }
  return pieces;
}

json entry_of(const ReportedExercise& exercise, const ReportedCourse& course) {
  const CheckResult& checked = exercise.checked;
  const Judgement& judgement = checked.judgement;
  const bool passed = judgement.passed();
  const bool is_judged = checked.is_judged();
  Score score;
  score.add(checked);
  json entry = {
      {"name", checked.name()},
      {"started", checked.is_started()},
      {"passed", passed},
      {"verdict", is_judged ? in_words(to_string(judgement.verdict)) : "could not be judged"},
      {"look", look_of(to_string(judgement.verdict))},
      {"score", is_judged ? score.text() : ""},
      {"cases",
       judgement.cases_total == 0 ? "" : fmt::format("{} of {}", judgement.cases_passed(), judgement.cases_total)},
      {"message", passed ? "" : judgement.message},
      {"by_hand", checked.by_hand},
      {"sandbox", checked.weak_sandbox},
      {"next", passed ? "" : checked.next_step()},
      {"measured", json::array()},
      {"findings", json::array()},
      {"diagnoses", json::array()},
      {"case", ""},
      {"failing", ""},
      {"printed", shortened_end(printed(checked.observation))},
      {"compiler", shortened_end(checked.observation.refusal_details)},
      {"has_source", checked.is_started() && !checked.source.empty()},
      {"source", checked.is_started() ? marked_source(checked) : json()},
      {"answer",
       exercise.answered_right ? (*exercise.answered_right ? "answered correctly" : "answered wrong at first") : ""},
      {"picture", checked.picture.empty() ? "" : checked.name()},
      {"description", checked.picture_description}};
  for (const std::string& sentence : on_real_data(checked)) entry["measured"].push_back("The function " + sentence);
  for (const Reason& reason : checked.reasons)
    if (reason.is_in_code())
      entry["findings"].push_back(
          {{"place", place_of(reason, checked)}, {"sentence", reason.sentence}, {"excerpt", reason.excerpt}});
    else
      entry["diagnoses"].push_back({{"message", reason.sentence}, {"read", place_of(reason.notes, exercise, course)}});
  const auto failing = checked.first_failure();
  if (!failing) return entry;
  const Answers answers = answers_of(*checked.reference, checked.observation.replies);
  const auto lines = describe_case(*checked.reference, *failing, answers[*failing], {.most_rows = 24});
  entry["case"] = fmt::format("{}", fmt::join(lines, "\n"));
  if (judgement.failing.size() > 1) entry["failing"] = failing_cases(checked);
  return entry;
}

/// A reason says more than the general advice for its verdict.
std::string step_of(const ReportedExercise& exercise, const ReportedCourse& course) {
  const CheckResult& checked = exercise.checked;
  if (checked.reasons.empty()) return checked.next_step();
  const auto told = std::ranges::find_if_not(checked.reasons, &Reason::is_in_code);
  if (told == checked.reasons.end()) {
    const Reason& reason = checked.reasons.front();
    return place_of(reason, checked) + (reason.line > 0 ? ": " : "") + reason.sentence;
  }
  const std::string place = place_of(told->notes, exercise, course);
  return told->sentence + (place.empty() ? "" : " Read " + place + ".");
}

/// What is worth doing first: fix in course order, then start what is not started.
json steps_of(const ReportedCourse& course) {
  json steps = json::array();
  std::size_t failing = 0;
  json start;
  for (const ReportedExercise& exercise : course.exercises) {
    const CheckResult& checked = exercise.checked;
    const std::string& name = checked.name();
    if (!checked.is_started()) {
      if (start.is_null())
        start = {{"name", name}, {"text", "Start it. " + checked.task.exercise.entry->task}, {"link", false}};
    } else if (checked.is_judged() && !checked.is_excused && !checked.judgement.passed() && ++failing <= most_steps) {
      steps.push_back({{"name", name}, {"text", step_of(exercise, course)}, {"link", true}});
    }
  }
  if (failing > most_steps)
    steps.push_back({{"name", ""}, {"text", fmt::format("Then the other {} failing below.", failing - most_steps)}});
  if (!start.is_null()) steps.push_back(start);
  return steps;
}

}  // namespace

std::string report_page(const ReportedCourse& course) {
  Score score;
  Score lecture_score;
  json lectures = json::array();
  std::vector<CheckResult> results;
  for (const ReportedExercise& exercise : course.exercises) {
    score.add(exercise.checked);
    results.push_back(exercise.checked);
    const Card& card = *exercise.checked.task.exercise.card;
    const std::string heading = card.lecture.substr(0, card.lecture.find('_')) + "  " + card.title;
    if (lectures.empty() || lectures.back()["heading"] != heading) {
      lectures.push_back({{"heading", heading}, {"exercises", json::array()}, {"any_started", false}});
      lecture_score = {};
    }
    json& lecture = lectures.back();
    lecture_score.add(exercise.checked);
    lecture["score"] = lecture_score.text();
    lecture["exercises"].push_back(entry_of(exercise, course));
    lecture["any_started"] = lecture["any_started"] || exercise.checked.is_started();
  }
  Score counted = score;
  if (course.counted) counted.points = *course.counted;
  const auto is_left = [](const CheckResult& checked) { return !checked.judgement.passed(); };
  const json page = {{"student", course.student},
                     {"date", course.date},
                     {"seed", course.seed ? std::to_string(*course.seed) : ""},
                     {"score", counted.text()},
                     {"summary", summary_line(results)},
                     {"picture_trouble", course.picture_trouble},
                     {"notes", course.notes},
                     {"all_passed", std::ranges::none_of(results, is_left)},
                     {"steps", steps_of(course)},
                     {"lectures", lectures}};
  std::string text =
      rendered_page(page_template("report_page.html"), page, {{"style", "\n" + page_template("style.css")}});
  // Pictures are much larger than all the rest, and are no text that needs to be escaped.
  for (const CheckResult& checked : results) {
    const std::string before = ";base64,", name = checked.name();
    if (!checked.picture.empty())
      text.replace(text.find(before + name + '"') + before.size(), name.size(), checked.picture);
  }
  return text;
}

json look_of(const std::string& verdict) {
  if (verdict == "passed") return {{"tone", "good"}, {"mark", "✓"}};
  if (verdict == "not_started") return {{"tone", "idle"}, {"mark", "·"}};
  if (verdict == "checker_error") return {{"tone", "unclear"}, {"mark", "!"}};
  return {{"tone", "bad"}, {"mark", "✗"}};
}

}  // namespace workbook
