// Who is who: a roster, or what a learning system exports of its own.
#include "checker/grading/grading.hpp"

#include <yaml-cpp/yaml.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <set>

namespace workbook {
namespace {

constexpr std::size_t largest_table = std::size_t{16} << 20;

// The headings of a roster of one's own, of Gradescope, of GitHub Classroom and its table of grades, of the gradebook
// of Canvas, and of Moodle's grading worksheet and list of participants in English, German, French and Spanish; in
// small letters and without what stands between them.
using Headings = std::vector<std::string>;
const Headings email_headings = {"email", "emailaddress", "adressedecourriel", "direccióndecorreo"};
const Headings id_number_headings = {"idnumber", "idnummer", "matrikelnummer", "numérod'identification", "númerodeid"};
const Headings identifier_headings = {"identifier", "id", "identifiant", "identificador"};
const Headings login_headings = {"username",         "login",           "anmeldename",
                                 "nomd'utilisateur", "nombredeusuario", "sisloginid",
                                 "githubusername",   "githublogin",     "github"};
const Headings name_headings = {"name",       "fullname",      "student", "studentname", "vollständigername",
                                "nomcomplet", "nombrecompleto"};
const Headings first_name_headings = {"firstname", "vorname", "prénom", "nombre"};
const Headings last_name_headings = {"lastname", "surname", "nachname", "nom", "apellido(s)"};
const Headings time_headings = {"submitted", "submissiontime", "submissiontimestamp"};
const Headings grade_headings = {"grade", "bewertung", "note", "calificación"};
const Headings maximum_headings = {"maximumgrade", "bestwertung", "notemaximale", "calificaciónmáxima"};
const Headings scale_headings = {"scale", "skala", "barème", "escala"};
const Headings status_headings = {"status", "statut", "estado"};
const Headings feedback_headings = {"feedbackcomments", "feedbackalskommentar", "feedbackparcommentaires",
                                    "comentariosderetroalimentación"};

Headings joined(const std::vector<Headings>& all) {
  Headings headings;
  for (const Headings& each : all) headings.insert(headings.end(), each.begin(), each.end());
  return headings;
}
const Headings id_headings = joined({{"id", "sid", "studentid"},
                                     id_number_headings,
                                     {"sisuserid", "rosteridentifier", "identifier"},
                                     login_headings,
                                     email_headings});

std::string plain_heading(std::string heading) {
  std::erase_if(heading, [](char letter) { return std::string_view(" _-").find(letter) != std::string_view::npos; });
  return boost::to_lower_copy(heading);
}

/// A table whose first row names the columns.
class NamedTable {
 public:
  explicit NamedTable(const fs::path& file) : file_(file) {
    const std::optional<std::string> text = read_file(file, largest_table);
    if (!text) throw GradingError(fmt::format("{} cannot be read; check its name.", shown_path(file)));
    try {
      const std::string_view head = std::string_view(*text).substr(0, text->find('\n'));
      for (const char each : {';', '\t'})
        if (std::ranges::count(head, each) > std::ranges::count(head, separator_)) separator_ = each;
      rows = read_csv(*text, separator_);
    } catch (const GradingError& problem) {
      refuse(problem.what());
    }
    if (rows.empty()) refuse("it is empty; the first line should name the columns, one of them id");
    for (auto& row : rows)
      for (std::string& field : row) boost::trim(field);
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw GradingError(fmt::format("{}: {}.", shown_path(file_), reason));
  }

  /// The first of the headings that is there.
  std::optional<std::size_t> column(const Headings& headings) const {
    for (const std::string& heading : headings)
      for (std::size_t at = 0; at < rows.front().size(); ++at)
        if (plain_heading(rows.front()[at]) == heading) return at;
    return std::nullopt;
  }

  std::string field(std::size_t row, std::optional<std::size_t> at) const {
    return at && *at < rows[row].size() ? rows[row][*at] : "";
  }

  /// The first cell under one of the headings that is not empty.
  std::string field(std::size_t row, const Headings& headings) const {
    for (const std::string& heading : headings)
      if (std::string cell = field(row, column({heading})); !cell.empty()) return cell;
    return "";
  }

  Table rows;

 private:
  const fs::path file_;
  char separator_ = ',';
};

/// "Participant 900001", as Moodle's worksheet has it, in any language.
std::string participant_number(const std::string& identifier) {
  return identifier.substr(identifier.find_last_not_of("0123456789") + 1);
}

/// Without names where the students are not to be known.
bool is_worksheet(const NamedTable& table) {
  const auto participant = table.column(identifier_headings);
  if (!participant || !table.column(grade_headings)) return false;
  // In German its numbers are below "ID", as in anybody's own roster.
  const bool is_marked = table.column(joined({maximum_headings, scale_headings})).has_value();
  if (!is_marked && (participant == table.column({"id"}) || !table.column(status_headings))) return false;
  const std::string first = table.rows.size() > 1 ? table.field(1, participant) : "";
  const std::string number = participant_number(first);
  return !number.empty() && number.size() < first.size();
}

/// The id under which a row of the worksheet is graded.
std::string worksheet_id(const NamedTable& table, std::size_t row) {
  const std::string own = table.field(row, id_number_headings);
  return own.empty() ? participant_number(table.field(row, table.column(identifier_headings))) : own;
}

std::string text_at(const YAML::Node& node, const char* key) {
  for (const std::string& name : {std::string(":") + key, std::string(key)})
    if (node.IsMap() && node[name] && node[name].IsScalar()) return node[name].Scalar();
  return "";
}

}  // namespace

std::vector<RosterEntry> read_roster(const fs::path& file) {
  const NamedTable table(file);
  const bool worksheet = is_worksheet(table);
  const auto submitted = table.column(time_headings), role = table.column({"role"});
  const bool is_of_canvas = table.column({"student"}) && table.column({"sisloginid", "section"});
  if (!table.column(id_headings) && !worksheet)
    table.refuse(fmt::format("the first line should name the columns, one of them id; it names '{}'",
                             shortened(printable(fmt::format("{}", fmt::join(table.rows.front(), "', '"))), 200)));
  if (table.rows.size() == 1) table.refuse("it has columns and no row; a line for each student should follow");
  std::vector<RosterEntry> entries;
  std::set<std::string> ids;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const auto refuse_row = [&](const std::string& reason) {
      table.refuse(fmt::format("row {}: {}", row + 1, reason));
    };
    RosterEntry entry{worksheet ? worksheet_id(table, row) : table.field(row, id_headings),
                      table.field(row, name_headings),
                      read_time(table.field(row, submitted)),
                      {}};
    if (entry.name.empty())
      entry.name = boost::trim_copy(table.field(row, first_name_headings) + " " + table.field(row, last_name_headings));
    if (entry.id.empty() && is_of_canvas) continue;  // points possible, and what is posted by hand
    if (std::string who = boost::to_lower_copy(table.field(row, role));
        who == "instructor" || who == "ta" || who == "reader")
      continue;  // whom Gradescope's roster names too
    if (table.rows[row].size() > table.rows.front().size())
      refuse_row(fmt::format("it has {}, and the first line only {}; put quotation marks around a cell with commas",
                             plural(table.rows[row].size(), "cell"), table.rows.front().size()));
    if (entry.id.empty()) refuse_row("the id is missing");
    if (!ids.insert(entry.id).second) refuse_row(fmt::format("the id {} is there twice", printable(entry.id)));
    if (!entry.submitted && !table.field(row, submitted).empty())
      refuse_row("'submitted' should be a time like 2027-03-01T23:59:00Z");
    for (const std::string& heading : joined({{"aliases"}, id_headings})) {
      std::vector<std::string> names;
      const std::string cell = table.field(row, table.column({heading}));
      boost::split(names, cell, [&](char letter) { return heading == "aliases" && (letter == ' ' || letter == ';'); });
      for (const std::string& each : names)
        if (!each.empty() && each != entry.id) entry.aliases.push_back(each);
    }
    if (worksheet) entry.aliases.push_back(participant_number(table.field(row, table.column(identifier_headings))));
    entries.push_back(std::move(entry));
  }
  return entries;
}

Overrides read_overrides(const fs::path& file, const Assignment& assignment) {
  const NamedTable table(file);
  const auto student = table.column({"student", "id"}), exercise = table.column({"exercise"}),
             points = table.column({"points"}), excuse = table.column({"excuse"}), due = table.column({"due"}),
             comment = table.column({"comment"});
  if (!student) table.refuse("the first line should name the columns, one of them student");
  for (const std::string& heading : table.rows.front())
    if (const auto at = table.column({plain_heading(heading)});
        at != student && at != exercise && at != points && at != excuse && at != due && at != comment)
      table.refuse(fmt::format("the column '{}' means nothing", shortened(printable(heading), 100)));
  Overrides overrides;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const auto require = [&](bool is_so, const std::string& reason) {
      if (!is_so) table.refuse(fmt::format("row {}: {}", row + 1, reason));
    };
    const std::string id = table.field(row, student), name = table.field(row, exercise);
    require(!id.empty(), "the student is missing");
    double most = 0;
    for (const Exercise& each : assignment.exercises())
      if (name.empty() || each.name() == name) most += each.entry->points;
    require(most > 0, fmt::format("no exercise that is graded is called '{}'", shortened(printable(name), 100)));
    Override by_hand;
    std::vector<std::string> parts;
    if (std::string text = table.field(row, points); !text.empty()) {
      std::ranges::replace(text, ',', '.');
      double number = -1;
      const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
      require(problem == std::errc() && end == text.data() + text.size() && number >= 0 && number <= most,
              fmt::format("'points' should be a number from 0 to {:g}", most));
      by_hand.points = number;
      parts.push_back(fmt::format("{:g} {}", number, number == 1 ? "point" : "points"));
    }
    const std::string excused = boost::to_lower_copy(table.field(row, excuse)), time = table.field(row, due);
    by_hand.is_excused = excused == "yes" || excused == "x" || excused == "true" || excused == "1";
    require(by_hand.is_excused || excused.empty() || excused == "no" || excused == "false" || excused == "0",
            "'excuse' should be yes or no");
    require(!by_hand.is_excused || !by_hand.points, "who is excused gets no points");
    if (by_hand.is_excused) parts.emplace_back("excused");
    by_hand.due = read_time(time);
    require(time.empty() || by_hand.due, "'due' should be a time like 2027-03-01T23:59:00Z");
    require(time.empty() || name.empty(), "'due' is of the whole: leave the exercise empty");
    if (by_hand.due) parts.push_back("due " + time);
    by_hand.sentence = fmt::format("{}", fmt::join(parts, ", "));
    if (const std::string said = table.field(row, comment); !said.empty())
      by_hand.sentence += (parts.empty() ? "" : ": ") + shortened(printable(said), 1000);
    require(!by_hand.sentence.empty(), "it says nothing");
    require(overrides[id].emplace(name, by_hand).second,
            fmt::format("{}{} is there twice", printable(id), name.empty() ? "" : ", " + name + ","));
  }
  return overrides;
}

std::map<std::string, std::vector<RosterEntry>> read_gradescope(const std::string& text) {
  std::map<std::string, std::vector<RosterEntry>> submitters;
  try {
    for (const auto& submission : YAML::Load(text)) {
      const std::string folder = submission.first.Scalar();
      const YAML::Node& about = submission.second;
      const YAML::Node people = about[":submitters"] ? about[":submitters"] : about["submitters"];
      for (const YAML::Node& person : people) {
        RosterEntry entry{text_at(person, "sid"),
                          text_at(person, "name"),
                          read_time(text_at(about, "created_at")),
                          {text_at(person, "email")}};
        for (const std::string& other : {entry.aliases.front(), entry.name})
          if (entry.id.empty()) entry.id = other;
        if (!entry.id.empty()) submitters[folder.substr(folder.find_first_not_of(':'))].push_back(std::move(entry));
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
  const auto grade = table.column(grade_headings), feedback = table.column(feedback_headings);
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const auto& students = document.at("students");
    const auto found =
        std::ranges::find_if(students, [&](const auto& each) { return each.at("id") == worksheet_id(table, row); });
    if (found == students.end() || !found->at("in_gradebooks")) continue;
    std::string maximum = table.field(row, maximum_headings);
    const bool is_comma = maximum.find(',') != std::string::npos;
    std::ranges::replace(maximum, ',', '.');
    const double possible = found->at("possible"), most = std::atof(maximum.c_str());
    const double scale = most > 0 && possible > 0 ? most / possible : 1;
    table.rows[row].resize(table.rows.front().size());
    if (!table.column(scale_headings)) {  // whose words are the lecturer's
      std::string& cell = table.rows[row][*grade] =
          fmt::format("{:.2f}", scale * found->at("score").template get<double>());
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
