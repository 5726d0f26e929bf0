#include "checker/course/assignment.hpp"

#include <nlohmann/json.hpp>

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace workbook {

using nlohmann::json;

Table read_csv(std::string_view text, char separator) {
  Table table;
  std::string field;
  std::vector<std::string> row;
  bool is_quoted = false;
  const auto end_row = [&] {
    if (!row.empty() || !field.empty()) {
      row.push_back(std::exchange(field, {}));
      table.push_back(std::exchange(row, {}));
    }
  };
  for (std::size_t at = text.starts_with("\ufeff") ? 3 : 0; at < text.size(); ++at) {
    const char letter = text[at];
    if (is_quoted) {
      if (letter != '"')
        field += letter;
      else if (at + 1 < text.size() && text[at + 1] == '"')
        field += text[++at];
      else
        is_quoted = false;
    } else if (letter == '"') {
      is_quoted = true;
    } else if (letter == separator) {
      row.push_back(std::exchange(field, {}));
    } else if (letter == '\n') {
      end_row();
    } else if (letter == '\r' && (at + 1 == text.size() || text[at + 1] != '\n')) {
      throw GradingError(
          fmt::format("row {} ends with a carriage return alone; save it with other line ends", table.size() + 1));
    } else if (letter != '\r') {
      field += letter;
    }
  }
  if (is_quoted) throw GradingError(fmt::format("row {} has a quotation mark that is not closed", table.size() + 1));
  end_row();
  return table;
}

namespace {

/// A text that no spreadsheet takes for a formula, whether its cells end at commas or at semicolons: an apostrophe in
/// front of what could begin one, at the beginning of the cell or of what another reader takes for the next.
std::string without_formulas(const std::string& cell) {
  std::string safe;
  bool is_beginning = true;
  for (std::size_t at = 0; at < cell.size(); ++at) {
    const auto stands_here = [&](std::string_view sign) { return cell.compare(at, sign.size(), sign) == 0; };
    // The wide forms are U+FF1D, U+FF0B, U+FF0D and U+FF20.
    constexpr std::array<std::string_view, 9> signs = {"=",      "+",      "-",      "@",     "\t",
                                                       "\uff1d", "\uff0b", "\uff0d", "\uff20"};
    if (is_beginning && std::ranges::any_of(signs, stands_here)) safe += '\'';
    const bool is_separator = std::string_view(",;\t\n").find(cell[at]) != std::string_view::npos;
    is_beginning = is_separator || (is_beginning && (cell[at] == ' ' || cell[at] == '"'));
    safe += cell[at];
  }
  return safe;
}

}  // namespace

std::string write_csv(const Table& table) {
  std::string text;
  for (const auto& row : table) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::string field = without_formulas(printable(row[i]));
      if (field.find_first_of("\",;\n") != std::string::npos) {
        for (std::size_t at = 0; (at = field.find('"', at)) != std::string::npos; at += 2) field.insert(at, "\"");
        field = fmt::format("\"{}\"", field);
      }
      text += (i == 0 ? "" : ",") + field;
    }
    text += "\r\n";
  }
  return text;
}

std::optional<std::int64_t> read_time(const std::string& text) {
  std::string plain = text;  // without parts of a second
  if (const std::size_t point = plain.find('.'); point != std::string::npos)
    plain.erase(point, plain.find_first_not_of("0123456789", point + 1) - point);
  for (const char* format :
       {"%Y-%m-%dT%H:%M:%S%z", "%Y-%m-%d %H:%M:%S %z", "%Y-%m-%d %H:%M:%S%z", "%Y-%m-%d %H:%M:%S UTC"}) {
    std::tm time{};
    const char* const end = ::strptime(plain.c_str(), format, &time);
    if (end == nullptr || *end != '\0') continue;
    const std::tm read = time;
    const std::int64_t seconds = ::timegm(&time) - read.tm_gmtoff;  // makes 3 March of 31 February
    if (time.tm_mon == read.tm_mon && time.tm_mday == read.tm_mday && time.tm_sec == read.tm_sec) return seconds;
  }
  return std::nullopt;
}

namespace {

constexpr double seconds_per_day = 86400;
constexpr double most_of_a_wrong_answer = 0.75;  // one case of hundreds may be all that shows that it is wrong

std::string text_of(const fs::path& file) {
  const std::optional<std::string> text = read_file(file, std::size_t{16} << 20);
  if (!text) throw GradingError(fmt::format("{} cannot be read; check its name.", shown_path(file)));
  return *text;
}

/// Every key must be known: a misspelt one would change grades in silence.
void require_known(const json& object, const std::string& place, const std::set<std::string>& known) {
  if (!object.is_object()) throw std::runtime_error(place + " should be an object");
  for (const auto& [key, unused] : object.items())
    if (!known.contains(key))
      throw std::runtime_error(fmt::format("{} has the key '{}', which means nothing; known are {}", place,
                                           printable(key), fmt::join(known, ", ")));
}

double number_between(const json& object, const char* key, double least, double most) {
  const json& value = object.at(key);
  if (!value.is_number() || !(value.get<double>() >= least) || !(value.get<double>() <= most))
    throw std::runtime_error(fmt::format("'{}' should be a number from {:g} to {:g}", key, least, most));
  return value.get<double>();
}

}  // namespace

Assignment::Assignment(const Course& course, const std::optional<fs::path>& file) {
  std::map<std::string, double> points;
  std::vector<std::string> names;
  const std::string text = file ? text_of(*file) : "";
  if (file) try {
      const json document = json::parse(text);
      require_known(document, "the file",
                    {"title", "exercises", "due", "late", "hint_cost", "partial", "misconceptions"});
      title_ = document.value("title", "");
      for (const json& each : document.value("exercises", json::array())) {
        const std::string name = each.is_object() ? each.at("name").get<std::string>() : each.get<std::string>();
        if (each.is_object()) require_known(each, "an exercise", {"name", "points"});
        for (const Exercise& exercise : course.find(name)) {
          if (std::ranges::count(names, exercise.name()) > 0)
            throw std::runtime_error(fmt::format("'exercises' names {} twice", exercise.name()));
          names.push_back(exercise.name());
          if (each.contains("points")) points[exercise.name()] = number_between(each, "points", 0.001, 1000);
        }
      }
      if (document.contains("due")) {
        due_text_ = document.at("due");
        due_ = read_time(due_text_);
        if (!due_) throw std::runtime_error("'due' should be a time like 2027-03-01T23:59:00Z");
      }
      if (document.contains("late")) {
        const json& late = document.at("late");
        require_known(late, "'late'", {"per_day", "days"});
        late_ = {number_between(late, "per_day", 0, 1), static_cast<int>(number_between(late, "days", 0, 10000))};
      }
      if (document.contains("hint_cost")) hint_cost_ = number_between(document, "hint_cost", 0, 1);
      const json partial = document.value("partial", json(false));
      if (!partial.is_boolean() && partial != "groups")
        throw std::runtime_error("'partial' should be true, false or \"groups\"");
      partial_ = partial == "groups" ? Partial::groups : partial == true ? Partial::cases : Partial::none;
      const json shares = document.value("misconceptions", json::object());
      for (const auto& [name, unused] : shares.items())
        misconceptions_[name] = number_between(shares, name.c_str(), 0, most_of_a_wrong_answer);
    } catch (const std::exception& problem) {
      const std::string reason = replaced(problem.what(), R"(^\[json\.[^\]]*\] )", "");  // what is wrong alone
      throw GradingError(fmt::format("{}: {}.", shown_path(*file), printable(without_full_stop(reason))));
    }
  for (const Exercise& exercise : course.exercises()) {
    if (!names.empty() && std::ranges::count(names, exercise.name()) == 0) continue;
    entries_.push_back(*exercise.entry);
    if (points.contains(exercise.name())) entries_.back().points = points.at(exercise.name());
    exercises_.push_back({exercise.card, &entries_.back()});
  }
}

int Assignment::days_late(const std::optional<std::int64_t>& submitted,
                          const std::optional<std::int64_t>& own_due) const {
  const std::optional<std::int64_t> due = own_due ? own_due : due_;
  if (!due || !submitted || *submitted <= *due) return 0;
  return static_cast<int>(std::ceil(static_cast<double>(*submitted - *due) / seconds_per_day));
}

double Assignment::late_factor(int days) const {
  if (days <= 0 || !late_) return 1.0;
  return days > late_->latest_day ? 0.0 : std::max(0.0, 1.0 - late_->per_day * days);
}

double Assignment::earned(const Judgement& judgement, const ExerciseReference& reference,
                          const std::vector<std::string>& misconceptions) const {
  if (judgement.passed()) return 1.0;
  // A crash, a call that is forbidden or a value that changes is no part of an answer.
  if (judgement.verdict != Verdict::wrong_value && judgement.verdict != Verdict::non_finite_value) return 0.0;
  double most = 0.0;
  for (const std::string& name : misconceptions)
    for (const std::string& key : {name, reference.name + "/" + name})
      if (misconceptions_.contains(key)) most = std::max(most, misconceptions_.at(key));
  if (partial_ == Partial::cases)
    most = std::max(most, static_cast<double>(judgement.cases_passed()) / static_cast<double>(judgement.cases_total));
  if (partial_ == Partial::groups) {
    std::array<int, 3> all{}, wrong{};  // ordinary, special and generated
    const auto group = [&](std::size_t index) {
      const Group of = reference.cases.at(index).group;
      return of == Group::special ? 1 : of == Group::generated ? 2 : 0;
    };
    for (std::size_t i = 0; i < reference.cases.size(); ++i) ++all[group(i)];
    for (const std::size_t i : judgement.failing) ++wrong[group(i)];
    double groups = 0, right = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      groups += all[k] > 0 ? 1 : 0;
      right += all[k] > 0 && wrong[k] == 0 ? 1 : 0;
    }
    if (all[0] > 0 && wrong[0] == 0) most = std::max(most, right / groups);
  }
  return std::min(most, most_of_a_wrong_answer);
}

double Assignment::share(const Judgement& judgement, const ExerciseReference& reference,
                         const std::vector<std::string>& misconceptions, std::size_t hints) const {
  return earned(judgement, reference, misconceptions) * std::max(0.0, 1.0 - hint_cost_ * static_cast<double>(hints));
}

std::vector<std::string> Assignment::rules(bool hints_are_known) const {
  std::vector<std::string> sentences;
  if (partial_ == Partial::cases)
    sentences.push_back(
        fmt::format("Values that are right at some of the cases earn that part of the points, at most {:g} %.",
                    100 * most_of_a_wrong_answer));
  if (partial_ == Partial::groups)
    sentences.emplace_back(
        "Values that are right at all ordinary cases, but not at all special or all varied ones, earn a part of the "
        "points for each of these groups that is right in full.");
  if (!misconceptions_.empty()) sentences.emplace_back("Some mistakes that are recognised earn a part of the points.");
  if (has_hint_cost())
    sentences.push_back(fmt::format("Each hint that was shown costs {:g} % of what its exercise earns{}",
                                    100 * hint_cost_,
                                    hints_are_known ? "." : "; no progress file was handed in, so none is counted."));
  return sentences;
}

}  // namespace workbook
