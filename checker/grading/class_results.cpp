#include "checker/grading/grading.hpp"

#include <boost/math/statistics/bivariate_statistics.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace workbook {

using nlohmann::ordered_json;

namespace {

constexpr const char* outputs = "identical_wrong_outputs";
constexpr std::size_t most_with_one_reason = 5;

/// Of passing an exercise with the points of all others; null where one of them is the same for all.
ordered_json correlation(const std::vector<double>& passed, const std::vector<double>& rest) {
  using boost::math::statistics::correlation_coefficient, boost::math::statistics::variance;
  if (passed.size() < 2 || variance(passed) == 0 || variance(rest) * static_cast<double>(rest.size()) < 1e-9)
    return nullptr;
  return std::round(correlation_coefficient(passed, rest) * 1000) / 1000;
}

double rounded(double points) { return std::round(points * 10000) / 10000; }

}  // namespace

ClassResults::ClassResults(const Assignment& assignment, std::uint64_t seed, const std::string& sandbox,
                           const Intake& intake, bool with_missing)
    : assignment_(assignment), with_missing_(with_missing) {
  document_ = {{"format", 1}, {"title", assignment.title()}, {"seed", seed}, {"sandbox", sandbox}};
  for (const char* list : {"problems", "missing", "exercises", "misconceptions", outputs, "learnt_by_heart",
                           "not_judged", "changes", "students"})
    document_[list] = ordered_json::array();
  ordered_json& problems = document_["problems"] = intake.problems;
  for (const Student& student : intake.students) {
    if (student.whole().decides()) continue;
    for (const std::string& sentence : student.unread) problems.push_back(student.id + ": " + sentence);
    if (!student.dispute.empty()) problems.push_back(fmt::format("{} is not judged: {}", student.id, student.dispute));
    if (student.is_missing()) document_["missing"].push_back(student.id);
  }
}

ordered_json ClassResults::add(const Student& student, const std::vector<CheckResult>& results,
                               const std::vector<std::string>& made_from) {
  const Override whole = student.whole();
  const int days_late = assignment_.days_late(student.submitted, whole.due);
  const double factor = assignment_.late_factor(days_late);
  double points = 0, possible = 0;
  ordered_json document = ordered_json::parse(json_report(results, document_.at("seed")));
  document.erase("seed");
  ordered_json marks = ordered_json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const CheckResult& checked = results[i];
    ordered_json& result = document["results"][i];
    result.erase("seconds");  // the same submission gives the same document
    marks.push_back({{"exercise", checked.name()},
                     {"verdict", result["verdict"]},
                     {"score", result["score"]},
                     {"points", checked.points()},
                     {"message", printable(checked.judgement.message)},
                     {"made_from", made_from[i]}});
    if (!checked.by_hand.empty()) marks.back()["by_hand"] = checked.by_hand;
    if (!checked.is_judged()) {
      if (student.dispute.empty())
        document_["not_judged"].push_back(
            fmt::format("{}: {}: {}", student.id, checked.name(), printable(checked.judgement.message)));
      continue;
    }
    if (checked.judgement.passed())
      similar.add(checked.name(), student.id, student.files.at(checked.name()).where, checked.source);
    possible += checked.points();
    points += checked.score();
    const auto among = [&](const char* list, const std::string& name) -> ordered_json& {
      ordered_json& group = groups_[list][{checked.name(), name}];
      group["exercise"] = checked.name();
      group["students"].push_back(student.id);
      return group;
    };
    for (const Reason& reason : checked.reasons) {
      if (reason.kind == ReasonKind::learnt) among("learnt_by_heart", "");
      if (reason.kind == ReasonKind::misconception)
        among("misconceptions", reason.name).update({{"name", reason.name}, {"message", reason.sentence}});
    }
    const bool is_explained =
        std::ranges::any_of(checked.reasons, [](const Reason& each) { return each.is_in_code() || each.is_cause(); });
    if (checked.judgement.verdict == Verdict::wrong_value && !is_explained)
      among(outputs, checked.fingerprint_of_values())["first_failure"] = result["first_failure"];
  }
  const double score = rounded(whole.points.value_or(points * factor));
  ordered_json entry = {{"id", student.id},      {"name", student.name},  {"slug", student.slug},
                        {"score", score},        {"possible", possible},  {"days_late", days_late},
                        {"late_factor", factor}, {"notes", student.notes}};
  if (possible > 0) ++distribution_.at(static_cast<std::size_t>(std::min(9.0, 10 * score / possible)));
  if (!whole.sentence.empty()) entry["by_hand"] = whole.sentence;
  document["student"] = entry;
  document["sandbox"] = document_["sandbox"];
  const bool is_complete = !student.is_missing() && student.unread.empty() && student.dispute.empty();
  entry["in_tables"] = !whole.is_excused && (is_complete || with_missing_ || whole.points);
  // A part of the marks would count as the whole.
  const auto is_judged = [](const ordered_json& mark) { return mark.at("score").is_number(); };
  entry["in_gradebooks"] = entry["in_tables"] && (whole.points || std::ranges::all_of(marks, is_judged));
  if (!student.attempt.empty()) entry["attempt"] = student.attempt;
  entry["results"] = marks;
  document_["students"].push_back(std::move(entry));
  return document;
}

ordered_json ClassResults::exercise_entry(std::size_t number) const {
  int started = 0;
  std::vector<double> passes, rests;
  for (const ordered_json& student : document_.at("students")) {
    double rest = 0;
    for (const ordered_json& mark : student.at("results"))
      if (mark.at("score").is_number()) rest += mark.at("score").get<double>();
    const ordered_json& mark = student.at("results").at(number);
    if (mark.at("score").is_null()) continue;
    started += mark.at("verdict") != "not_started" ? 1 : 0;
    passes.push_back(mark.at("verdict") == "passed" ? 1.0 : 0.0);
    rests.push_back(rest - mark.at("score").get<double>());
  }
  const Exercise& exercise = assignment_.exercises()[number];
  const double passed = std::accumulate(passes.begin(), passes.end(), 0.0);
  return {{"exercise", exercise.name()},
          {"lecture", exercise.lecture()},
          {"points", exercise.entry->points},
          {"judged", passes.size()},
          {"started", started},
          {"passed", static_cast<int>(passed)},
          {"difficulty",
           passes.empty() ? nullptr : ordered_json(rounded(1.0 - passed / static_cast<double>(passes.size())))},
          {"discrimination", correlation(passes, rests)}};
}

ordered_json ClassResults::document() {
  for (std::size_t i = 0; i < assignment_.exercises().size(); ++i) document_["exercises"].push_back(exercise_entry(i));
  document_["distribution"] = distribution_;
  const auto students = [](const ordered_json& each) { return each["students"].size(); };
  for (auto& [list, groups] : groups_) {
    std::vector<ordered_json> largest_first;
    for (auto& [unused, group] : groups)
      if (list != outputs || students(group) > 1) largest_first.push_back(std::move(group));
    std::ranges::stable_sort(largest_first, std::greater<>(), students);
    document_[list] = largest_first;
  }
  document_["similar"] = similar.pairs();
  return std::move(document_);
}

std::vector<std::string> compare_with(const ordered_json& before, ordered_json& now) {
  now["changes"] = before.value("changes", ordered_json::array());  // first: a new key moves all that was there
  std::vector<std::string> lines;
  std::map<std::string, const ordered_json*> known;
  std::vector<std::pair<ordered_json&, const ordered_json&>> in_both;
  const auto name_of_mark = [](const ordered_json& mark) { return mark.at("exercise").get<std::string>(); };
  const auto points = [](const ordered_json& student) {
    return fmt::format("{:g} of {:g}", student.at("score").get<double>(), student.at("possible").get<double>());
  };
  const auto is_unjudged = [](const ordered_json& mark) { return mark.at("verdict") == "checker_error"; };
  const bool is_other_seed = before.at("seed") != now.at("seed");
  std::map<std::string, std::vector<std::string>> by_reason;  // what many have in common is said once
  for (const ordered_json& student : before.at("students")) known[student.at("id")] = &student;
  for (ordered_json& student : now.at("students")) {
    const std::string id = student.at("id");
    if (!known.contains(id)) {
      by_reason["new"].push_back(fmt::format("{}: {} points", id, points(student)));
      continue;
    }
    const ordered_json& old = *known.extract(id).mapped();
    in_both.emplace_back(student, old);
    if (old.at("score") == student.at("score") && old.at("possible") == student.at("possible")) continue;
    std::vector<std::string> reasons;
    const auto by_hand = [](const ordered_json& of) { return of.value("by_hand", ""); };
    const auto decided = [&](const std::string& what, const ordered_json& of) {
      return what + (by_hand(of).empty() ? "no longer decided by hand" : "by hand: " + by_hand(of));
    };
    const bool is_other_attempt = old.value("attempt", "") != student.value("attempt", "");
    if (is_other_attempt) reasons.emplace_back("another attempt");
    if (by_hand(old) != by_hand(student))
      reasons.push_back(decided("", student));
    else if (!is_other_attempt && old.at("late_factor") != student.at("late_factor"))
      reasons.emplace_back("handed in at another time");
    for (const ordered_json& mark : student.at("results")) {
      const std::string exercise = name_of_mark(mark);
      const auto same = std::ranges::find(old.at("results"), exercise, name_of_mark);
      if (same == old.at("results").end()) {
        reasons.push_back(exercise + " is new in the assignment");
      } else if (by_hand(*same) != by_hand(mark)) {
        reasons.push_back(decided(exercise + " ", mark));
      } else if (same->at("verdict") != mark.at("verdict")) {
        const auto words = [&](const ordered_json& of) {
          return is_unjudged(of) ? "not judged" : in_words(of.at("verdict"));
        };
        const char* const why = is_unjudged(*same) || is_unjudged(mark)         ? ""
                                : same->at("made_from") != mark.at("made_from") ? ", with another file"
                                : is_other_seed                                 ? ", with other cases"
                                                                                : ", by another checker";
        reasons.push_back(fmt::format("{} was {} and is {}{}", exercise, words(*same), words(mark), why));
      } else if (same->at("points") != mark.at("points")) {
        if (by_hand(old) == by_hand(student)) reasons.push_back(exercise + " has other points");  // not by an excuse
      } else if (same->at("score") != mark.at("score")) {
        reasons.push_back(exercise + " earns another part of its points");
      }
    }
    if (reasons.empty()) reasons.emplace_back("other exercises in the assignment");
    by_reason[fmt::format("{}", fmt::join(reasons, "; "))].push_back(
        fmt::format("{}: {} points, before {}", id, points(student), points(old)));
  }
  for (const auto& [id, unused] : known) by_reason["no longer in the class"].push_back(id);
  for (const auto& [reason, marks] : by_reason) {
    if (marks.size() > most_with_one_reason)
      lines.push_back(fmt::format("{}: {}. The first: {}.", plural(marks.size(), "student"), reason, marks.front()));
    else
      for (const std::string& mark : marks) lines.push_back(fmt::format("{}: {}.", mark, reason));
  }
  if (!lines.empty()) now["changes"] = lines;
  for (const auto& [student, old] : in_both)
    if (lines.empty() ? old.contains("before") : old.at("score") != student.at("score"))
      student["before"] = old.at(lines.empty() ? "before" : "score");
  return lines;
}

}  // namespace workbook
