// Who is who: a roster, or what a learning system exports of its own.
#include "checker/grading/grading.hpp"
#include "checker/templates/templates.hpp"

#include <unicode/smpdtfmt.h>
#include <unicode/unistr.h>
#include <yaml-cpp/yaml.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace workbook {
namespace {

constexpr std::size_t largest_table = std::size_t{16} << 20;

using Kinds = std::vector<std::string>;
const Kinds id_columns = {"own id", "id number", "system's id", "login", "email"};

/// The headings of columns of these kinds, in small letters and without what stands between them. Those of Gradescope,
/// GitHub Classroom, Canvas, and Moodle in English, German, French and Spanish are data; any other kind is a heading.
std::vector<std::string> headings_of(const Kinds& kinds) {
  static const auto known = nlohmann::json::parse(page_template("columns.json")).get<std::map<std::string, Kinds>>();
  std::vector<std::string> headings;
  for (const std::string& kind : kinds)
    std::ranges::copy(known.contains(kind) ? known.at(kind) : Kinds{kind}, std::back_inserter(headings));
  return headings;
}

/// A time as Moodle's worksheet has it, "Wednesday, 3 March 2027, 2:14 PM" in any of its languages.
std::optional<std::int64_t> time_of_moodle(const std::string& text, const std::string& zone) {
  const icu::UnicodeString read = icu::UnicodeString::fromUTF8(text);
  for (const std::string& each : headings_of({"forms of times"})) {
    UErrorCode problem = U_ZERO_ERROR;
    icu::SimpleDateFormat form(icu::UnicodeString::fromUTF8(each.substr(3)), icu::Locale(each.substr(0, 2).c_str()),
                               problem);
    form.adoptTimeZone(icu::TimeZone::createTimeZone(zone == "Z" ? "GMT" : ("GMT" + zone).c_str()));
    icu::ParsePosition end(0);
    const UDate time = form.parse(read, end);
    if (U_SUCCESS(problem) && end.getIndex() == read.length()) return static_cast<std::int64_t>(time / 1000);
  }
  return std::nullopt;
}

std::string plain_heading(const std::string& heading) { return boost::to_lower_copy(replaced(heading, "[ _-]", "")); }

/// A table whose first row names the columns.
class NamedTable {
 public:
  explicit NamedTable(const fs::path& file) : file_(file) {
    const std::optional<std::string> bytes = read_file(file, largest_table);
    if (!bytes) throw GradingError(fmt::format("{} cannot be read; check its name.", shown_path(file)));
    // As spreadsheets save tables: in UTF-8, in UTF-16 with its mark, or in the letters of Windows in Western Europe.
    const bool is_wide = bytes->starts_with("\xff\xfe") || bytes->starts_with("\xfe\xff");
    const std::string text =
        replaced(in_utf8(*bytes, is_wide ? "UTF-16" : "windows-1252"), "^(\ufeff)?(sep=.\r?\n)?", "");
    try {
      const std::string_view head = std::string_view(text).substr(0, text.find('\n'));
      char separator = ',';
      for (const char each : {';', '\t'})
        if (std::ranges::count(head, each) > std::ranges::count(head, separator)) separator = each;
      rows = read_csv(text, separator);
    } catch (const GradingError& problem) {
      refuse(problem.what());
    }
    for (auto& row : rows) {
      for (std::string& field : row) boost::trim(field);
      while (row.size() > rows.front().size() && row.back().empty()) row.pop_back();
    }
    std::erase_if(rows, [](const auto& row) { return std::ranges::all_of(row, &std::string::empty); });
    if (rows.empty()) refuse("it is empty; the first line should name the columns, one of them id");
    std::ranges::transform(rows.front(), std::back_inserter(headings_), plain_heading);
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw GradingError(fmt::format("{}: {}.", shown_path(file_), reason));
  }

  /// The first that is there.
  std::optional<std::size_t> column(const Kinds& kinds) const {
    for (const std::string& heading : headings_of(kinds))
      for (std::size_t at = 0; at < headings_.size(); ++at)
        if (headings_[at] == heading) return at;
    return std::nullopt;
  }

  /// The first cell in one of the columns that is not empty.
  std::string field(std::size_t row, const Kinds& kinds) const {
    for (const std::string& heading : headings_of(kinds))
      if (const auto at = column({heading}); at && *at < rows[row].size() && !rows[row][*at].empty())
        return rows[row][*at];
    return "";
  }

  /// Refuses the table, naming the row, where something is not so.
  void require(std::size_t row, bool is_so, const std::string& reason) const {
    if (!is_so) refuse(fmt::format("row {}: {}", row + 1, reason));
  }

  Table rows;

 private:
  const fs::path file_;
  std::vector<std::string> headings_;
};

/// "Participant 900001", as Moodle's worksheet has it, in any language.
std::string participant_number(const std::string& identifier) {
  return identifier.substr(identifier.find_last_not_of("0123456789") + 1);
}

/// Without names where the students are not to be known.
bool is_worksheet(const NamedTable& table) {
  return table.column({"participant"}) && table.column({"grade"}) && table.column({"maximum", "scale"}) &&
         table.rows.size() > 1 && search(table.field(1, {"participant"}), "\\D\\d+$");
}

/// The id under which a row of the worksheet is graded.
std::string worksheet_id(const NamedTable& table, std::size_t row) {
  const std::string own = table.field(row, {"id number"});
  return own.empty() ? participant_number(table.field(row, {"participant"})) : own;
}

}  // namespace

std::string in_quotes(const std::string& name) { return fmt::format("'{}'", shortened(printable(name), 200)); }

std::string in_utf8(const std::string& bytes, const char* letters) {
  if (icu::UnicodeString::fromUTF8(bytes).indexOf(char16_t{0xFFFD}) < 0) return bytes;
  std::string text;
  return icu::UnicodeString(bytes.data(), static_cast<std::int32_t>(bytes.size()), letters).toUTF8String(text);
}

std::vector<Student> read_roster(const fs::path& file, const std::string& zone) {
  const NamedTable table(file);
  const bool worksheet = is_worksheet(table);
  const bool is_of_canvas = table.column({"sisloginid"}).has_value();
  if (!table.column(id_columns) && !worksheet)
    table.refuse(fmt::format("the first line should name the columns, one of them id; it names '{}'",
                             shortened(printable(fmt::format("{}", fmt::join(table.rows.front(), "', '"))), 200)));
  std::vector<Student> entries;
  std::set<std::string> ids;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const auto field = [&](const Kinds& kinds) { return table.field(row, kinds); };
    const std::string time = field({"time"}), role = boost::to_lower_copy(field({"role"}));
    Student entry{.id = worksheet ? worksheet_id(table, row) : field(id_columns),
                  .name = field({"name"}),
                  .submitted = read_time(time),
                  .group = field({"group"}),
                  .entry = field({"folder"})};
    if (entry.name.empty()) entry.name = boost::trim_copy(field({"first name"}) + " " + field({"last name"}));
    if (worksheet && !entry.submitted) entry.submitted = time_of_moodle(time, zone);
    if (entry.id.empty() && is_of_canvas) continue;  // points possible, and what is posted by hand
    if (role == "instructor" || role == "ta" || role == "reader") continue;  // whom Gradescope's roster names too
    table.require(row, table.rows[row].size() <= table.rows.front().size(),
                  fmt::format("it has {}, and the first line only {}; put quotation marks around a cell with commas",
                              plural(table.rows[row].size(), "cell"), table.rows.front().size()));
    table.require(row, !entry.id.empty(), "the id is missing");
    table.require(row, ids.insert(entry.id).second, fmt::format("the id {} is there twice", printable(entry.id)));
    table.require(row, entry.submitted || time.empty() || (worksheet && time == "-"),
                  in_quotes(time) + " should be a time like 2027-03-01T23:59:00Z");
    boost::split(entry.aliases, field({"aliases"}), boost::is_any_of(" ;"));
    for (const std::string& heading : headings_of(id_columns)) entry.aliases.push_back(field({heading}));
    std::erase_if(entry.aliases, [&](const std::string& alias) { return alias.empty() || alias == entry.id; });
    if (worksheet) entry.aliases.push_back(participant_number(field({"participant"})));
    entries.push_back(std::move(entry));
  }
  if (entries.empty()) table.refuse("it has columns and no row; a line for each student should follow");
  return entries;
}

Overrides read_overrides(const fs::path& file, const Assignment& assignment) {
  const NamedTable table(file);
  const Kinds whose = {"student", "id"}, others = {"exercise", "points", "excuse", "due", "comment"};
  if (!table.column(whose)) table.refuse("the first line should name the columns, one of them student");
  for (const std::string& heading : table.rows.front())
    if (std::ranges::count(whose, plain_heading(heading)) + std::ranges::count(others, plain_heading(heading)) == 0)
      table.refuse(fmt::format("the column {} means nothing", in_quotes(heading)));
  Overrides overrides;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const std::string id = table.field(row, whose), name = table.field(row, {"exercise"});
    table.require(row, !id.empty(), "the student is missing");
    double most = 0;
    for (const Exercise& each : assignment.exercises())
      if (name.empty() || each.name() == name) most += each.entry->points;
    table.require(row, most > 0, "no exercise that is graded is called " + in_quotes(name));
    Override by_hand;
    std::vector<std::string> parts;
    std::string points = table.field(row, {"points"});
    std::ranges::replace(points, ',', '.');
    table.require(row, search(points, "^(\\d+(\\.\\d+)?)?$") && std::atof(points.c_str()) <= most,
                  fmt::format("'points' should be a number from 0 to {:g}", most));
    if (!points.empty()) {
      by_hand.points = std::atof(points.c_str());
      parts.push_back(fmt::format("{:g} {}", *by_hand.points, by_hand.points == 1 ? "point" : "points"));
    }
    const std::string excused = boost::to_lower_copy(table.field(row, {"excuse"})), time = table.field(row, {"due"});
    by_hand.is_excused = !!search(excused, "^(yes|x|true|1)$");
    table.require(row, by_hand.is_excused || search(excused, "^(no|false|0)?$"), "'excuse' should be yes or no");
    table.require(row, !by_hand.is_excused || !by_hand.points, "who is excused gets no points");
    if (by_hand.is_excused) parts.emplace_back("excused");
    by_hand.due = read_time(time);
    table.require(row, time.empty() || by_hand.due, "'due' should be a time like 2027-03-01T23:59:00Z");
    table.require(row, time.empty() || name.empty(), "'due' is of the whole: leave the exercise empty");
    if (by_hand.due) parts.push_back("due " + time);
    by_hand.sentence = fmt::format("{}", fmt::join(parts, ", "));
    if (const std::string said = table.field(row, {"comment"}); !said.empty())
      by_hand.sentence += (parts.empty() ? "" : ": ") + shortened(printable(said), 1000);
    table.require(row, !by_hand.sentence.empty(), "it says nothing");
    table.require(row, overrides[id].emplace(name, by_hand).second,
                  fmt::format("{}{} is there twice", printable(id), name.empty() ? "" : ", " + name + ","));
  }
  return overrides;
}

std::map<std::string, std::vector<Student>> read_gradescope(const std::string& text) {
  std::map<std::string, std::vector<Student>> submitters;
  // Its keys are symbols of Ruby, ":name".
  const auto part = [](const YAML::Node& node, const std::string& key) {
    return node[":" + key] ? node[":" + key] : node[key];
  };
  const auto at = [&](const YAML::Node& node, const char* key) -> std::string {
    const YAML::Node value = part(node, key);
    if (value && value.IsMap() && value["utc"]) return value["utc"].Scalar();  // a time may be an object of Ruby
    return value && value.IsScalar() ? value.Scalar() : "";
  };
  try {
    for (const auto& submission : YAML::Load(text)) {
      for (const YAML::Node& person : part(submission.second, "submitters")) {
        const std::string email = at(person, "email"), name = at(person, "name");
        Student entry{.id = at(person, "sid"),
                      .name = name,
                      .submitted = read_time(at(submission.second, "created_at")),
                      .aliases = {email}};
        for (const std::string& other : {email, name})
          if (entry.id.empty()) entry.id = other;
        if (!entry.id.empty()) submitters[submission.first.Scalar()].push_back(std::move(entry));
      }
    }
  } catch (const std::exception& problem) {
    throw GradingError(
        fmt::format("{} cannot be read ({}). Nothing was graded.", gradescope_metadata, printable(problem.what())));
  }
  if (submitters.empty())
    throw GradingError(fmt::format("{} names no student. Nothing was graded.", gradescope_metadata));
  return submitters;
}

std::optional<std::string> filled_worksheet(const fs::path& roster, const nlohmann::ordered_json& document) {
  NamedTable table(roster);
  if (!is_worksheet(table)) return std::nullopt;
  const auto grade = table.column({"grade"}), feedback = table.column({"feedback"});
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const auto& students = document.at("students");
    const auto found =
        std::ranges::find_if(students, [&](const auto& each) { return each.at("id") == worksheet_id(table, row); });
    if (found == students.end() || !found->at("in_gradebooks")) continue;
    std::string maximum = table.field(row, {"maximum"});
    const bool is_comma = maximum.find(',') != std::string::npos;
    std::ranges::replace(maximum, ',', '.');
    const double possible = found->at("possible"), score = found->at("score"), most = std::atof(maximum.c_str());
    const double scale = most > 0 && possible > 0 ? most / possible : 1;
    table.rows[row].resize(table.rows.front().size());
    if (!table.column({"scale"})) {  // whose words are the lecturer's
      std::string& cell = table.rows[row][*grade] = fmt::format("{:.2f}", scale * score);
      if (is_comma) std::ranges::replace(cell, '.', ',');
    }
    std::vector<std::string> said;
    if (found->contains("by_hand")) said.push_back(found->at("by_hand"));
    for (const auto& mark : found->at("results"))
      if (const std::string message = message_of(mark); !message.empty())
        said.push_back(mark.at("exercise").template get<std::string>() + ": " + message);
    if (feedback) table.rows[row][*feedback] = said.empty() ? "All passed." : fmt::format("{}", fmt::join(said, " "));
  }
  return write_csv(table.rows);
}

}  // namespace workbook
