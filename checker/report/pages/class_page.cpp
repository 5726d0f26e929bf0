// The page about a class, from its document.
#include "checker/report/reports.hpp"
#include "checker/templates/templates.hpp"

#include <sodium.h>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace workbook {

namespace {

using nlohmann::ordered_json;

constexpr double share_without_need = 0.5;  // of the points

/// Numbers as a table has room for them.
std::string short_numbers(const ordered_json& value) {
  if (value.is_number()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_array()) return value.dump();
  std::vector<std::string> parts;
  for (const ordered_json& each : value) parts.push_back(short_numbers(each));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

double two_digits(const ordered_json& points) { return std::round(100 * points.get<double>()) / 100; }

}  // namespace

std::string class_page(const ordered_json& document, const std::string& date) {
  const ordered_json& students = document.at("students");
  ordered_json page = {{"date", date}, {"count", plural(students.size(), "student")}};
  for (const char* key : {"title", "sandbox", "problems", "not_judged", "exercises", "misconceptions",
                          "identical_wrong_outputs", "changes"})
    page[key] = document.at(key);
  page["seed"] = document.at("seed").dump();
  const std::vector<std::string> missing = document.at("missing");
  page["missing"] = shortened(fmt::format("{}", fmt::join(missing, ", ")), 2000);
  std::map<std::string, ordered_json> known;  // how a student is named, and the name of the page
  for (const ordered_json& student : students) {
    const std::string id = student.at("id"), name = student.at("name");
    known[id] = {{"who", name.empty() ? id : fmt::format("{} ({})", name, id)}, {"page", student.at("slug")}};
    if (const std::string said = decided_by_hand(student); !said.empty())
      page["by_hand"].push_back({{"who", known[id]["who"]}, {"what", said}});
  }
  const auto linked = [&](const ordered_json& ids) {
    ordered_json links = ordered_json::array();
    for (const ordered_json& id : ids) links.push_back(known.at(id));
    return links;
  };
  for (ordered_json pair : document.value("similar", ordered_json::array())) {
    pair["percent"] = fmt::format("{:.0f} %", 100 * pair.at("share").get<double>());
    for (ordered_json& answer : pair["answers"]) answer["students"] = linked(answer.at("students"));
    page["similar"].push_back(pair);
  }
  for (const ordered_json& each : document.at("learnt_by_heart"))
    page["learnt"].push_back({{"exercise", each.at("exercise")}, {"students", linked(each.at("students"))}});
  for (ordered_json& each : page["misconceptions"]) {
    each["count"] = each.at("students").size();
    each["students"] = linked(each.at("students"));
    each["plot"] = command(
        fmt::format("plot {} --wrong {}", each.at("exercise").get<std::string>(), each.at("name").get<std::string>()));
  }
  for (ordered_json& each : page["exercises"]) {
    ordered_json& fraction = each["difficulty"];
    fraction = fraction.is_null() ? "–" : fmt::format("{:.0f} %", 100 * fraction.get<double>());
    ordered_json& correlation = each["discrimination"];
    correlation = correlation.is_null() ? "–" : fmt::format("{:.2f}", correlation.get<double>());
  }
  // Each row by itself: what a template is filled with takes some fifteen times the memory of what it makes.
  std::string rows;
  std::vector<double> shares;
  std::vector<std::pair<double, ordered_json>> in_need;
  for (const ordered_json& student : students) {
    nlohmann::json cells = nlohmann::json::array();
    ordered_json failing = ordered_json::array();
    for (const ordered_json& mark : student.at("results")) {
      const std::string verdict = mark.at("verdict");
      const bool is_counted = mark.at("points") != 0;
      cells.push_back(is_counted ? look_of(verdict) : nlohmann::json{{"tone", "idle"}, {"mark", "–"}});
      cells.back()["words"] = is_counted ? in_words(verdict) : "not counted";
      if (is_counted && verdict != "passed" && verdict != "not_started") failing.push_back(mark.at("exercise"));
    }
    ordered_json row = known.at(student.at("id"));
    row["score"] = two_digits(student.at("score"));
    row["possible"] = student.at("possible") == 0 ? ordered_json() : student.at("possible");
    row["before"] = student.contains("before") ? fmt::format("{:g}", two_digits(student.at("before"))) : "";
    row["late"] = student.at("days_late") > 0 ? plural(student.at("days_late"), "day") : "";
    if (student.at("possible") > 0 && std::ranges::count(missing, student.at("id").get<std::string>()) == 0) {
      shares.push_back(student.at("score").get<double>() / student.at("possible").get<double>());
      in_need.emplace_back(shares.back(), row);
      in_need.back().second["failing"] = failing;
    }
    row["cells"] = cells;
    rows += rendered_page(page_template("class_page_row.html"), row);
  }
  std::erase_if(in_need, [](const auto& each) { return each.first >= share_without_need; });
  std::ranges::stable_sort(in_need, {}, [](const auto& each) { return each.first; });
  for (const auto& [unused, row] : in_need) page["in_need"].push_back(row);
  page["numbers"] = {
      {{"number", fmt::format("{} of {}", students.size() - missing.size(), students.size())}, {"what", "handed in"}},
      {{"number", shares.empty() ? "–" : fmt::format("{:.0f} %", 100 * boost::math::statistics::median(shares))},
       {"what", "of the points is the median of those"}},
      {{"number", std::to_string(in_need.size())}, {"what", "of them have less than half"}, {"to", "help"}},
      {{"number", std::to_string(document.at("problems").size())}, {"what", "not read"}, {"to", "unread"}},
      {{"number", std::to_string(document.at("not_judged").size())}, {"what", "not judged"}, {"to", "not-judged"}},
      {{"number", std::to_string(document.at("changes").size())}, {"what", "changed"}, {"to", "changes"}}};
  for (ordered_json& each : page["numbers"])
    if (each.at("number") == "0") each.erase("to");
  const std::vector<int> counts = document.at("distribution");
  const int most = std::max(1, *std::ranges::max_element(counts));
  for (std::size_t i = 0; i < counts.size(); ++i)
    page["bins"].push_back({{"range", fmt::format("{} – {} %", 10 * i, 10 * (i + 1))},
                            {"count", counts[i]},
                            {"width", fmt::format("{:.3g}", 100.0 * counts[i] / most)}});
  for (ordered_json& each : page["identical_wrong_outputs"]) {
    each["count"] = each.at("students").size();
    each["students"] = linked(each.at("students"));
    const ordered_json failure = std::exchange(each["first_failure"], nullptr);
    if (failure.is_null()) continue;
    each["case"] = failure.at("case");
    for (const char* key : {"expected", "actual"}) each[key] = shortened(short_numbers(failure.at(key)), 120);
  }
  page["any_unread"] = !document.at("problems").empty() || !missing.empty();
  for (const char* list : {"by_hand", "learnt", "not_judged", "misconceptions", "identical_wrong_outputs", "changes",
                           "in_need", "similar"})
    page[std::string("any_") + list] = !page[list].empty();
  const std::string& script = page_template("class_page.js");
  std::string hash(crypto_hash_sha256_BYTES, '\0');
  crypto_hash_sha256(reinterpret_cast<unsigned char*>(hash.data()),
                     reinterpret_cast<const unsigned char*>(script.data()), script.size());
  return rendered_page(page_template("class_page.html"), page,
                       {{"style", "\n" + page_template("style.css")},
                        {"rows", rows},
                        {"script", script},
                        {"script_hash", base64(hash)}});
}

}  // namespace workbook
