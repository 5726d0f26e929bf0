// Who has handed in what: nobody's file counts for another one, and nobody gets a zero in silence.
#include "tests/grading/made_up_class.hpp"

#include "checker/grading/grading.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <numeric>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

const std::string right = energy_text(right_energy), wrong = energy_text("return 0;");

/// A class that is taken in, and not judged.
class Taken {
 public:
  explicit Taken(const MadeUpClass& of, const std::string& submissions = "submissions",
                 const std::vector<std::string>& roster = {})
      : Taken(of, submissions, entries_of(roster)) {}

  /// @param roster  as a table
  static Taken with_table(const MadeUpClass& of, const std::string& submissions, const std::string& roster) {
    return Taken(of, submissions, workbook::read_roster(write(of.root() / "roster.csv", roster), "+01:00"));
  }

  Taken(const MadeUpClass& of, const std::string& submissions, const std::vector<workbook::Student>& entries)
      : copies_(of.root() / "copies") {
    const workbook::Course course(of.root() / "course.json");
    intake = workbook::take_in(of.root() / submissions, course, entries, copies_);
  }

  workbook::Intake intake;

  const workbook::Student& student(const std::string& id) const {
    for (const workbook::Student& each : intake.students)
      if (each.id == id) return each;
    throw std::runtime_error("no student " + id);
  }

  /// The text that is judged as spring_energy; "": none was taken.
  std::string energy(const std::string& id) const { return text(id, "spring_energy"); }
  std::string text(const std::string& id, const std::string& exercise) const {
    const auto& files = student(id).files;
    const auto file = files.find(exercise);
    if (file == files.end() || !file->second.refusal.empty()) return "";
    return read(copies_ / student(id).slug / (exercise + ".cpp"));
  }

 private:
  static std::vector<workbook::Student> entries_of(const std::vector<std::string>& ids) {
    std::vector<workbook::Student> entries;
    for (const std::string& id : ids) entries.push_back({.id = id});
    return entries;
  }

  fs::path copies_;
};

/// A zip file, as bytes.
std::string zipped(const MadeUpClass& of, const ZipEntries& texts) {
  write_zip(of.root() / "made.zip", texts);
  return read(of.root() / "made.zip");
}

/// Forty source files, of 1 MiB each.
ZipEntries too_much(const std::string& folder) {
  ZipEntries files;
  for (int k = 0; k < 40; ++k)
    files.emplace_back(fmt::format("{}{}/spring_energy.cpp", folder, k),
                       std::string((std::size_t{1} << 20) - 100, ' '));
  return files;
}

/// Whose text is judged for each, or why none is; then what belongs to nobody. Each text ends by saying whose it is.
std::vector<std::string> summary(const Taken& taken) {
  std::vector<std::string> lines;
  for (const workbook::Student& each : taken.intake.students) {
    const std::string text = taken.energy(each.id);
    std::string said = text.empty() ? "" : text.substr(text.rfind("// ") + 3);
    for (const auto& [unused, file] : each.files) said += file.refusal;
    for (const std::string& sentence : each.unread) said += sentence;
    lines.push_back(each.id + ": " + said + each.dispute);
  }
  std::ranges::sort(lines);
  lines.insert(lines.end(), taken.intake.problems.begin(), taken.intake.problems.end());
  return lines;
}

/// In a folder and in a zip file.
void hand_in(const MadeUpClass& all, const ZipEntries& files) {
  for (const auto& [path, text] : files) write(all.submissions() / path, *text);
  write_zip(all.root() / "class.zip", files);
}

/// The same in a folder and in a zip file, by a roster in the given bytes.
void check_class(const ZipEntries& files, const std::string& roster, const std::vector<std::string>& expected) {
  const MadeUpClass all;
  hand_in(all, files);
  for (const std::string submissions : {"submissions", "class.zip"}) {
    CAPTURE(submissions);
    CHECK(fmt::format("{}", fmt::join(summary(Taken::with_table(all, submissions, roster)), "\n")) ==
          fmt::format("{}", fmt::join(expected, "\n")));
  }
}

std::string of(const std::string& whose) { return right + "// " + whose; }

const std::string in_place = "/lectures/01_springs/exercises/spring_energy.cpp", of_a_mac("\0\5\x16\7", 4);

}  // namespace

TEST_SUITE_BEGIN("intake" * doctest::skip(!is_open_to_all()));

TEST_CASE("what is too much of one student in the zip file of a class costs nobody else a file") {
  const MadeUpClass all;
  auto files = too_much("cleo/");
  const std::string too_large = zipped(all, too_much(""));
  files.insert(files.begin(), {{"ada/spring_energy.cpp", right},
                               {"ben/work.zip", too_large},
                               {"ben/spring_energy.cpp", right},
                               {"ben/more.zip", zipped(all, {{"deep.zip", zipped(all, {{"x.cpp", right}})}})},
                               {"__MACOSX/ada/._work.zip", "no zip file"}});
  files.insert(files.end(), {{"dora.zip", zipped(all, {{"spring_energy.cpp", right}})},
                             {"emil/work.zip", "torn"},
                             {"fritz/spring_energy.cpp", right}});
  write_zip(all.root() / "class.zip", files);
  const Taken taken(all, "class.zip");
  CHECK(taken.intake.students.size() == 6);
  CHECK(taken.intake.problems.empty());
  for (const char* id : {"ada", "ben", "dora", "fritz"}) CHECK_MESSAGE(taken.energy(id) == right, id);
  for (const char* id : {"ada", "dora", "fritz"}) CHECK_MESSAGE(taken.student(id).unread.empty(), id);
  REQUIRE(taken.student("ben").unread.size() == 2);
  CHECK(has(taken.student("ben").unread[0], "ben/work.zip"));
  CHECK(has(taken.student("ben").unread[1], "ben/more/deep.zip"));
  CHECK(taken.student("cleo").unread.size() == 1);
  CHECK(has(taken.student("emil").unread.at(0), "emil/work.zip"));
  CHECK(taken.student("emil").is_missing());
}

TEST_CASE("time is shared out as well: what a student's zip files take to unpack counts, whether it is kept or not") {
  const MadeUpClass all;
  ZipEntries files;
  const std::string bomb((std::size_t{1} << 20) + 100, ' ');
  for (int k = 0; k < 300; ++k) files.emplace_back(fmt::format("ada/{}/spring_energy.cpp", k), bomb);
  files.emplace_back("ada/spring_energy.cpp", right);
  files.emplace_back("ben/spring_energy.cpp", right);
  write_zip(all.root() / "class.zip", files);
  const Taken taken(all, "class.zip");
  CHECK(taken.student("ada").unread.size() == 1);
  CHECK(taken.energy("ben") == right);
}

TEST_CASE("a class in one folder of a zip file may hold much code that is no exercise: clones do") {
  const MadeUpClass all;
  ZipEntries files;
  for (const char* id : {"ada", "ben"}) {
    files.emplace_back(fmt::format("week-3-submissions/week-3-{}{}", id, in_place), of(id));
    for (int k = 0; k < 20; ++k)
      files.emplace_back(fmt::format("week-3-submissions/week-3-{}/checker/{}.cpp", id, k),
                         std::string((std::size_t{1} << 20) - 100, ' '));
  }
  write_zip(all.root() / "class.zip", files);
  CHECK(summary(Taken(all, "class.zip", std::vector<std::string>{"ada", "ben"})) ==
        std::vector<std::string>{"ada: ada", "ben: ben"});
}

TEST_CASE("of a class that is taken in again unchanged copies are kept, changed ones written and others removed") {
  const MadeUpClass all;
  for (const char* id : {"same", "changed", "taken_back", "spoilt"}) all.energy(id, right_energy);
  const fs::path of_same = all.root() / "copies/same/spring_energy.cpp";
  const Taken first(all);
  const fs::path second_name = all.root() / "link";  // of the same file, unless a new one is written
  fs::create_hard_link(of_same, second_name);
  all.energy("changed", "return 0;");
  fs::remove(all.submissions() / "taken_back/spring_energy.cpp");
  write(all.submissions() / "spoilt/spring_energy.cpp", std::string(1, '\0'));
  const Taken again(all);
  CHECK(again.energy("same") == right);
  CHECK(fs::equivalent(of_same, second_name));
  CHECK(again.energy("changed") == wrong);
  for (const char* gone : {"copies/taken_back/spring_energy.cpp", "copies/spoilt/spring_energy.cpp", "copies.before"})
    CHECK_FALSE(fs::exists(all.root() / gone));
}

TEST_CASE("submissions that cannot be read as a whole are wrong usage, and nothing is written") {
  MadeUpClass().check_story("unreadable_class");
}

// The layouts of learning systems, written by hand from their documents and importers.

/// As Gradescope's "Export submissions" writes it: symbols of Ruby as keys.
const std::string metadata = R"(---
submission_111:
  :submitters:
  - :name: Ada Lovelace
    :sid: '3034'
    :email: ada@example.org
  - :name: Ben Franklin
    :sid: '3035'
    :email: ben@example.org
  :created_at: 2027-03-01 18:46:33.342312000 Z
  :score: 0.0
  :results:
    tests:
    - output: "a: b\n- c"
submission_222:
  :submitters:
  - :name: Cleo
    :sid:
    :email: cleo@example.org
  :created_at: 2027-03-02 10:00:00.000000000 +01:00
)";

TEST_CASE("Gradescope's export says whose a folder is: one, several, by number, e-mail or name") {
  const MadeUpClass all;
  const std::string above = "assignment_5_export/";
  hand_in(all, {{above + "submission_metadata.yml", metadata},
                {above + "submission_111/spring_energy.cpp", of("two")},
                {above + "submission_222/work/spring_energy.cpp", of("cleo")}});
  for (const char* submissions : {"submissions", "submissions/assignment_5_export", "class.zip"}) {
    CAPTURE(submissions);
    const Taken alone(all, submissions);
    CHECK(summary(alone) == std::vector<std::string>{"3034: two", "3035: two", "cleo@example.org: cleo"});
    CHECK(alone.student("3034").name == "Ada Lovelace");
    CHECK(alone.student("3034").submitted == workbook::read_time("2027-03-01T18:46:33Z"));
    CHECK(alone.student("cleo@example.org").submitted == workbook::read_time("2027-03-02T09:00:00Z"));
    const Taken listed = Taken::with_table(
        all, submissions, "Student ID;Name;E-mail;Aliases\n1;Ada L;;ada@EXAMPLE.org x\n2;Somebody;;\n3;CLEO;;\n");
    const std::vector<std::string> said = summary(listed);
    REQUIRE(said.size() == 4);
    CHECK(std::vector(said.begin(), said.begin() + 3) == std::vector<std::string>{"1: two", "2: ", "3: cleo"});
    CHECK(has(said[3], "Ben Franklin"));
  }
  write(all.submissions() / above / "submission_333/spring_energy.cpp", right);
  CHECK(has(Taken(all).intake.problems.at(0), "submission_333"));
  write(all.submissions() / above / "submission_metadata.yml", "a: [b");
  CHECK_THROWS_AS(Taken{all}, workbook::GradingError);
}

TEST_CASE("who hands in a file called as Gradescope's does not say whose the others' files are") {
  const MadeUpClass all;
  hand_in(all, {{"ada/submission_metadata.yml", metadata},
                {"ada/submission_111/spring_energy.cpp", of("ada")},
                {"ben/spring_energy.cpp", of("ben")}});
  for (const char* submissions : {"submissions", "class.zip"})
    CHECK(summary(Taken(all, submissions)) == std::vector<std::string>{"ada: ada", "ben: ben"});
}

TEST_CASE("what is too much in a folder, too deep, or zipped three times is named, and costs nobody else a file") {
  const MadeUpClass all;
  std::string deep = "ada";
  for (int k = 0; k < 20; ++k) deep += "/d";
  write(all.submissions() / deep / "spring_energy.cpp", wrong);
  write(all.submissions() / "ada/spring_energy.cpp", right);
  for (int k = 0; k < 30; ++k)
    write(all.submissions() / fmt::format("ben/{:02}.zip", k), zipped(all, {{"readme.txt", "x"}}));
  write(all.submissions() / "ben/spring_energy.cpp", right);
  write(all.submissions() / "cleo/1.zip",
        zipped(all, {{"2.zip", zipped(all, {{"3.zip", zipped(all, {{"spring_energy.cpp", wrong}})}})}}));
  fs::create_directories(all.submissions() / "dora");
  write(all.submissions() / "emil/spring_energy.cpp", right);
  const std::vector<std::string> ids = {"ada", "ben", "cleo", "dora", "emil"};
  fs::create_directories(all.root() / "above");
  for (const bool is_wrapped : {false, true}) {
    if (is_wrapped) fs::rename(all.submissions(), all.root() / "above/class");
    const Taken taken(all, is_wrapped ? "above" : "submissions", is_wrapped ? ids : std::vector<std::string>{});
    CHECK(taken.intake.students.size() == ids.size());
    CHECK(taken.intake.problems.empty());
    CHECK(taken.energy("ada") == right);
    CHECK(has(taken.student("ada").unread.at(0), "is a folder in too many others"));
    CHECK(has(taken.student("ben").unread.at(0), "comes after too many other files"));
    CHECK(has(taken.student("cleo").unread.at(0), "'cleo/1/2/3.zip' was not read: it is a zip file in a zip file"));
    CHECK(taken.student("dora").is_missing());
    CHECK(taken.energy("emil") == right);
  }
}

TEST_CASE("one class has the same files and names in the layout of every system") {
  const MadeUpClass all;
  struct Person {
    std::string id, name, canvas, login;
  };
  const std::vector<Person> people = {{"1001", "Zoë Müller", "müllerzoë", "zoe-m"},
                                      {"1002", "Miles O'Brien", "obrienmiles", "OBrien"},
                                      {"1003", "Ana María de la Cruz", "delacruzanamaría", "ana"},
                                      {"1004", "Jean-Luc Picard", "picardjeanluc", "main"}};
  // What each hands in; the last one works in a folder, and hands in a zip file of it where that can be.
  const auto files_of = [](const Person& person) {
    std::map<std::string, std::string> files = {
        {"spring_energy", energy_text(right_energy) + "// " + person.id + "\r\n"}};
    if (person.id != "1001")
      files["spring_force"] =
          force_text(person.id == "1002" ? "return k * x;" : right_force) + "// " + person.id + "\n";
    return files;
  };
  std::map<std::string, ZipEntries> layouts;
  std::map<std::string, std::string> rosters = {
      {"plain", "\ufeffid;name\r\n"},
      {"gradescope", "First Name,Last Name,SID,Email,Role\nLee,T,,t@x.org,Instructor\n"},
      {"moodle", "id,name\n"},
      {"moodle, German",
       "\ufeffID,\"Vollständiger Name\",ID-Nummer,E-Mail-Adresse,Status,Bewertung,Bestwertung,\"Feedback als "
       "Kommentar\"\n"},
      {"moodle, groups", "id,name\n"},
      {"canvas",
       "Student,ID,SIS User ID,SIS Login ID,Section,Week 3 (7)\n,,,,,Manual Posting\n    Points "
       "Possible,,,,,10\n"},
      {"classroom", "\"identifier\",\"github_username\",\"github_id\",\"name\"\n"}};
  std::string yaml = "---\n";
  int number = 0;
  for (const Person& person : people) {
    ++number;
    const std::string& id = person.id;
    std::string moodle = person.name;
    std::erase(moodle, '\'');
    const std::string space = person.name.substr(0, person.name.find(' ')),
                      rest = person.name.substr(person.name.find(' ') + 1);
    yaml += fmt::format("submission_{}:\n  :submitters:\n  - :name: \"{}\"\n    :sid: '{}'\n    :email: x\n", number,
                        person.name, id);
    rosters["plain"] += fmt::format("{};{}\r\n", id, person.name);
    rosters["gradescope"] += fmt::format("{},{},{},{}@x.org,Student\n", space, rest, id, id);
    rosters["moodle"] += fmt::format("{},{}\n", id, person.name);
    rosters["moodle, groups"] += fmt::format("{},\"{}, {}\"\n", id, rest, space);
    rosters["moodle, German"] +=
        fmt::format("Teilnehmer/in90{},{},{},a@x.org,\"Abgegeben\",,\"50,00\",\n", id, person.name, id);
    rosters["canvas"] += fmt::format("\"{}, {}\",77{},{},{},A,\n", rest, space, id, id, person.login);
    rosters["classroom"] += fmt::format("\"{}\",\"{}\",\"5\",\"{}\"\n", id, person.login, person.name);
    int attachment = 500 + 10 * number;
    ZipEntries zipped;
    for (const auto& [exercise, text] : files_of(person)) {
      const std::string file = exercise + ".cpp", place = "/lectures/01_springs/exercises/" + file;
      const std::string group = number < 3 ? "Group 1-" : "Default group-";
      zipped.emplace_back("work/" + file, text);
      layouts["plain"].emplace_back(id + "/" + file, text);
      layouts["gradescope"].emplace_back(fmt::format("assignment_5_export/submission_{}{}", number, place), text);
      for (const char* with : {"moodle", "moodle, German", "moodle, groups"})
        if (number < 4)
          layouts[with].emplace_back(fmt::format("{}{}_90{}_assignsubmission_file_/{}",
                                                 with == std::string("moodle, groups") ? group : "", moodle, id, file),
                                     text);
      if (number < 4)
        layouts["canvas"].emplace_back(
            fmt::format("{}{}_77{}_{}_{}-1.cpp", person.canvas, number == 2 ? "_LATE" : "", id, ++attachment, exercise),
            text);
      layouts["classroom"].emplace_back("week-3-" + person.login + place, text);
    }
    if (number < 4) continue;
    const std::string archive = ::zipped(all, zipped);
    for (const char* with : {"moodle", "moodle, German", "moodle, groups"}) {
      const std::string group = with == std::string("moodle, groups") ? "Default group-" : "";
      layouts[with].emplace_back(fmt::format("{}{}_90{}_assignsubmission_file_/my work.zip", group, moodle, id),
                                 archive);
      layouts[with].emplace_back(
          fmt::format("{}{}_90{}_assignsubmission_onlinetext_/onlinetext.html", group, moodle, id), "<p>");
    }
    layouts["canvas"].emplace_back(fmt::format("{}_77{}_600_my work.zip", person.canvas, id), archive);
  }
  layouts["gradescope"].emplace_back("assignment_5_export/submission_metadata.yml", yaml);
  for (auto& [system, files] : layouts) {
    CAPTURE(system);
    files.emplace_back("__MACOSX/._x.cpp", "of a Mac");
    for (const auto& [path, text] : files) write(all.root() / system / path, *text);
    write_zip(all.root() / (system + ".zip"), files);
    for (const std::string& submissions : {system, system + ".zip"}) {
      CAPTURE(submissions);
      const Taken taken = Taken::with_table(all, submissions, rosters.at(system));
      CHECK(taken.intake.students.size() == people.size());
      CHECK(taken.intake.problems == std::vector<std::string>());
      for (const Person& person : people) {
        // By whatever id the roster has.
        const std::string id = (system == "canvas" ? "77" : "") + person.id;
        CAPTURE(id);
        CHECK(taken.student(id).unread.empty());
        CHECK(taken.student(id).dispute.empty());
        CHECK(taken.student(id).files.size() == files_of(person).size());
        for (const auto& [exercise, text] : files_of(person)) CHECK(taken.text(id, exercise) == text);
      }
    }
    const Outcome graded =
        all.run(fmt::format("grade '{}.zip' --out graded --roster roster.csv --allow-reduced --seed 1", system));
    CHECK(graded.status == 0);
    const auto document = nlohmann::json::parse(read(all.root() / "graded/class.json"));
    std::vector<double> marks;
    for (const auto& student : document.at("students")) marks.push_back(student.at("score"));
    CHECK(fmt::format("{}", fmt::join(marks, " ")) == "2 2 3 3");
  }
}

TEST_CASE("files of other kinds are named where they may be an exercise") {
  const MadeUpClass all;
  write(all.submissions() / "ada/spring_energy.cc", right);
  write(all.submissions() / "ben/Spring_Energy.CPP", right);
  write(all.submissions() / "cleo/work.tar.gz", "no zip file");
  write(all.submissions() / "dora/clone/data/table.gz", "not hers to hand in");
  write_zip(all.submissions() / "emil.zip", {{"work.7z", "no zip file"}, {"spring_energy.cxx", right}});
  write(all.submissions() / "fritz/week 1 - SpringEnergy (2).cpp", right);
  write(all.submissions() / "fritz/main.cpp", right);
  write(all.submissions() / "fritz/clone/src/main.cpp", right);
  const Taken taken(all);
  CHECK(taken.student("fritz").notes ==
        std::vector<std::string>{"'fritz/main.cpp' was not read: no exercise is called so."});
  for (const char* id : {"ada", "ben", "emil", "fritz"})
    CHECK_MESSAGE(has(taken.student(id).files.at("spring_energy").refusal, "should be called spring_energy.cpp"), id);
  for (const char* id : {"cleo", "emil"}) CHECK_MESSAGE(taken.student(id).unread.size() == 1, id);
  CHECK(taken.student("dora").unread.empty());
}

TEST_CASE("times have a zone") {
  const auto noon = workbook::read_time("2027-03-01T12:00:00Z");
  REQUIRE(noon);
  for (const char* text : {"2027-03-01 13:00:00 +0100", "2027-03-01T13:00:00+01:00", "2027-03-01 12:00:00 UTC",
                           "2027-03-01 07:00:00.123 -0500"})
    CHECK_MESSAGE(workbook::read_time(text) == noon, text);
  for (const char* text :
       {"2027-03-01 12:00:00", "2027-02-30T12:00:00Z", "1 March 2027", "2027-03-01T12:00:00Zulu", ""})
    CHECK_MESSAGE(!workbook::read_time(text), text);
}

TEST_CASE("whose a folder or a file is follows from its name as each system writes it, in a folder and in a zip file") {
  MadeUpClass().check_story("whose");
}

TEST_CASE("where a student lies in a folder of his own beside that of his group, nobody is guessed") {
  check_class({{"Ben_2_assignsubmission_file/spring_energy.cpp", of("ben")},
               {"The Quarks_17_assignsubmission_file/spring_energy.cpp", of("quarks")}},
              "id,name,group\n1,Ada,The Quarks\n2,Ben,The Quarks\n",
              {"1: quarks",
               "2: spring_energy.cpp is there twice: 'Ben_2_assignsubmission_file/spring_energy.cpp' and 'The "
               "Quarks_17_assignsubmission_file/spring_energy.cpp'; hand in one.'Ben_2' and 'The Quarks_17' both name "
               "this student; leave only what is theirs."});
}

TEST_CASE("--who says who has handed in what, and judges nothing; the worksheet comes back with marks") {
  MadeUpClass().check_story("who");
}

TEST_CASE("Moodle's worksheet comes back as its language writes numbers, and words of a scale stay the lecturer's") {
  const MadeUpClass all;
  const nlohmann::ordered_json graded = {{"students",
                                          {{{"id", "1327670"},
                                            {"in_gradebooks", true},
                                            {"score", 2.5},
                                            {"possible", 3.0},
                                            {"results", nlohmann::ordered_json::array()}}}}};
  const auto filled = [&](const std::string& table) {
    return *workbook::filled_worksheet(write(all.root() / "sheet.csv", table), graded);
  };
  CHECK(filled("ID,Status,Bewertung,Bestwertung,Feedback als Kommentar\nTeilnehmer/in1327670,x,,\"7,50\",\n") ==
        "ID,Status,Bewertung,Bestwertung,Feedback als Kommentar\r\n"
        "Teilnehmer/in1327670,x,\"6,25\",\"7,50\",All passed.\r\n");
  CHECK(filled("ID,Bewertung,Skala,Feedback als Kommentar\nTeilnehmer/in1327670,,bestanden,\n") ==
        "ID,Bewertung,Skala,Feedback als Kommentar\r\nTeilnehmer/in1327670,,bestanden,All passed.\r\n");
  CHECK(filled("Identifiant,Statut,Note,Note maximale\nParticipant 1327670,x,,\"3,00\"\n") ==
        "Identifiant,Statut,Note,Note maximale\r\nParticipant 1327670,x,\"2,50\",\"3,00\"\r\n");
}

TEST_CASE("parts of a class are of a size, whatever ids have in common") {
  for (const std::uint64_t count : {2, 3, 8}) {
    std::vector<int> sizes(count);
    for (int k = 0; k < 800; ++k) {
      const std::string id = fmt::format("{:04}{:04}", k, k);  // each digit twice: the letters' parities are even
      for (std::uint64_t part = 1; part <= count; ++part)
        sizes[part - 1] += workbook::is_in_part(id, fmt::format("{}/{}", part, count)) ? 1 : 0;
    }
    CHECK(std::accumulate(sizes.begin(), sizes.end(), 0) == 800);
    for (const int size : sizes) CHECK(size > 800 / static_cast<int>(count) / 2);
  }
}

TEST_CASE("files of Canvas are found, or named on their student's page, as students call them") {
  const MadeUpClass all;
  const ZipEntries whole = {{"workbook/CMakeLists.txt", "x"},
                            {"workbook/build/spring_energy.cpp", of("nobody")},
                            {"workbook" + in_place, of("39")},
                            {"workbook/.git/x/spring_energy.cpp", of("nobody")}};
  const ZipEntries folder = {{"Week 3/.DS_Store", "x"},
                             {"__MACOSX/Week 3/._spring_energy.cpp", of_a_mac},
                             {"Week 3/deep/spring_energy.cpp", of("38")}};
  check_class({{"smithjohn_LATE_34_4501_spring_energy-1.cpp", of("34")},
               {"smithjohn_35_4502_spring_energy-2.cpp", of("35")},  // another one of that name
               {"mu\u0308llerzoe\u0308_LATE_36_4503_spring_energy (1).cpp", of("36")},
               {"obrienmiles_37_4504_spring_energy.cpp.txt", of("37")},
               {"picardjeanluc_LATE_38_4505_Week 3.ZIP", zipped(all, folder)},
               {"delacruzana_39_4506_workbook-1.zip", zipped(all, whole)},
               {"kim_41_4508_work.rar", "Rar!"},
               {"lee_42_4509_spring_energy - Copy.Cpp", of("42")},
               {"notes on the marks.pdf", "x"},
               {".DS_Store", "x"},
               {"__MACOSX/._smithjohn_LATE_34_4501_spring_energy-1.cpp", of_a_mac}},
              "\ufeffStudent;ID;SIS User ID;SIS Login ID;Section;Week 3 (7)\r\n    Points Possible;;;;;10\r\n"
              "\"Smith, John\";34;;;A;\r\n\"Smith, John\";35;;;A;\r\n\"Müller, Zoë\";36;;;A;\r\n"
              "\"O'Brien, Miles\";37;;;A;\r\n\"Picard, Jean-Luc\";38;;;A;\r\n\"de la Cruz, Ana\";39;;;A;\r\n"
              "Kim;41;;;A;\r\nLee;42;;;A;\r\n",
              {"34: 34", "35: 35",
               "36: 'mu\u0308llerzoe\u0308_LATE_36_4503_spring_energy (1).cpp' was not read: the file should be called "
               "spring_energy.cpp.",
               "37: 'obrienmiles_37_4504_spring_energy.cpp.txt' was not read: the file should be called "
               "spring_energy.cpp.",
               "38: 38", "39: 39", "41: 'kim_41_4508_work.rar' was not read: it is no zip file.",
               "42: 'lee_42_4509_spring_energy - Copy.Cpp' was not read: the file should be called spring_energy.cpp.",
               "'notes on the marks.pdf' was not read: it should be a student's folder, a zip file or "
               "ID_EXERCISE.cpp."});
}

TEST_CASE("folders and files of Moodle are matched by names that just one student has, in any letters") {
  const MadeUpClass all;
  const ZipEntries files = {
      {"Zoe\u0308 Mu\u0308ller_900001_assignsubmission_file/spring_energy.cpp", of("1")},
      {"Zoe\u0308 Mu\u0308ller_900001_assignsubmission_onlinetext/Texteingabe.html", "<p>"},
      {"John Smith_900002_assignsubmission_file_/Abgabe/spring_energy.cpp", of("2")},
      {"John Smith_900003_assignsubmission_file_/spring_energy.cpp", of("3")},
      {"Ana María_900004_assignsubmission_file_spring_energy.cpp", of("4")},
      {"Ben Ohm_900005_assignsubmission_file_spring_energy (2).cpp", of("5")},
      {"Cleo_900006_assignsubmission_onlinetext_onlinetext.html", "<p>"},
      {"Dora D_900008_assignsubmission_file_/work.ZIP", zipped(all, {{"spring_energy.cpp", of("8")}})}};
  const std::string renamed =
      "'Ben Ohm_900005_assignsubmission_file_spring_energy (2).cpp' was not read: the file should be called "
      "spring_energy.cpp.";
  check_class(files,
              "\ufeffID;\"Vollständiger Name\";ID-Nummer;Status;Bewertung;Bestwertung\r\n"
              "Teilnehmer/in900001;Zoë Müller;1;x;;10\r\nTeilnehmer/in900002;John Smith;2;x;;10\r\n"
              "Teilnehmer/in900003;John Smith;3;x;;10\r\nTeilnehmer/in900004;Ana María;4;x;;10\r\n"
              "Teilnehmer/in900005;Ben Ohm;5;x;;10\r\nTeilnehmer/in900006;Cleo;6;x;;10\r\n"
              "Teilnehmer/in900008;Dora D;8;x;;10\r\n",
              {"1: 1", "2: 2", "3: 3", "4: 4", "5: " + renamed, "6: ", "8: 8"});
  // By their names alone, from a spreadsheet that saves the letters of Windows, or all in two bytes.
  const std::vector<std::string> expected = {
      "1: 1",
      "2: ",
      "3: ",
      "4: 4",
      "5: " + renamed,
      "6: ",
      "8: 8",
      "'John Smith_900002_assignsubmission_file_' was not read: it names no id, and no name of just one student, of "
      "the roster.",
      "'John Smith_900003_assignsubmission_file_' was not read: it names no id, and no name of just one student, of "
      "the roster."};
  const std::string names =
      "id;Vorname;Nachname\r\n1;Zo\xeb;M\xfcller\r\n2;John;Smith\r\n3;John;Smith\r\n4;Ana;Mar\xed"
      "a\r\n5;Ben;Ohm\r\n6;Cleo;\r\n8;Dora;D\r\n";
  std::string wide = "\xff\xfe";
  for (const char letter : names) wide += {letter, '\0'};
  for (const std::string& roster : {"sep=;\r\n" + names, names, wide}) check_class(files, roster, expected);
}

TEST_CASE("what students put into folders of Gradescope is found, and two of one name are not taken for each other") {
  const MadeUpClass all;
  std::string yaml, number = "0";
  for (const auto& [sid, name] : std::vector<std::pair<std::string, std::string>>{
           {"1", "Mu\u0308ller, Zoe\u0308"}, {"2", "John Smith"}, {"3", "John Smith"}, {"", "Ana María"}}) {
    ++number[0];
    yaml += fmt::format(
        "submission_{}:\r\n  :submitters:\r\n  - :name: \"{}\"\r\n    :sid: '{}'\r\n    :email: p{}@x.org\r\n", number,
        name, sid, number);
  }
  const std::string above = "assignment_5_export/";
  check_class(
      {{above + "submission_metadata.yml", yaml},
       {above + ".DS_Store", "x"},
       {above + "submission_1/a/b/c/spring_energy.cpp", of("1")},
       {above + "submission_1/__MACOSX/a/spring_energy.cpp", of("nobody")},
       {above + "submission_2/spring_energy.cpp.txt", of("2")},
       {above + "submission_3/spring_energy.cpp", of("3")},
       {above + "submission_4/my workbook" + in_place, of("4")},
       {above + "submission_4/my workbook/spring_energy copy.cpp", of("nobody")},
       {"__MACOSX/assignment_5_export/._submission_metadata.yml", of_a_mac}},
      "First Name,Last Name,SID,Email,Role\r\nZoë,Müller,1,,Student\r\nJohn,Smith,2,,Student\r\n"
      "John,Smith,33,,Student\r\nAna,María,4,,Student\r\n",
      {"1: 1", "2: 'submission_2/spring_energy.cpp.txt' was not read: the file should be called spring_energy.cpp.",
       "33: ", "4: 4",
       "'submission_3' was not read for John Smith: the roster has no '3', and not just one of that name."});
}

/// Of every student of a roster.
std::string times(const std::string& roster) {
  const MadeUpClass all;
  std::string said;
  for (const auto& entry : workbook::read_roster(write(all.root() / "roster.csv", roster), "+01:00"))
    said += fmt::format("{} ", entry.submitted.value_or(0) - *workbook::read_time("2027-03-03T14:14:00+01:00"));
  return said;
}

TEST_CASE("times of Moodle's worksheet are read in its languages, in the zone in which the assignment is due") {
  const std::string other = "Grade,Maximum grade,",
                    never = fmt::format("{} ", -*workbook::read_time("2027-03-03T13:14:00Z"));
  CHECK(times("Identifier," + other +
              "Last modified (submission)\nParticipant 1,,10,\"Wednesday, 3 March 2027, 2:14 PM\"\n"
              "Participant 2,,10,-\nParticipant 3,,10,\"Wednesday, March 3, 2027, 2:15 PM\"\n") ==
        "0 " + never + "60 ");
  CHECK(
      times("ID;Bewertung;Bestwertung;Zuletzt geändert (Abgabe)\nTeilnehmer/in1;;10;Mittwoch, 3. März 2027, 14:14\n") ==
      "0 ");
  CHECK(times("Identifiant,Note,Note maximale,Dernière modification (travail remis)\n"
              "Participant 1,,10,\"mercredi 3 mars 2027, 14:14\"\n") == "0 ");
  CHECK(times("Identificador,Calificación,Calificación máxima,Última modificación (entrega)\n"
              "Participante 1,,10,\"miércoles, 3 de marzo de 2027, 14:14\"\n") == "0 ");
  CHECK_THROWS_AS(times("Identifier," + other + "Last modified (submission)\nParticipant 1,,10,tomorrow\n"),
                  workbook::GradingError);
}

TEST_CASE("what Gradescope says of the past, in its times and in printouts names nobody") {
  const std::string yaml = R"(---
submission_1:
  :submitters:
  - :name: 'O''Brien, Miles'
    :sid: 0034
    :email: m@x.org
  - {:name: "Zoë \"Z\" Müller", :sid: '007'}
  :created_at: !ruby/object:ActiveSupport::TimeWithZone
    utc: 2027-03-01 18:46:33.342312000 Z
    zone: &1 !ruby/object:ActiveSupport::TimeZone
      name: America/New_York
    time: 2027-03-01 13:46:33.342312000 Z
  :results:
    output: |
      submission_2:
        :submitters:
        - :name: evil
  :history:
  - :id: 5
    :created_at: 2027-02-01 18:46:33 Z
    :submitters:
    - :name: evil
submission_3:
  :submitters: []
)";
  const ZipEntries files = {{"submission_metadata.yml", yaml},
                            {"submission_1/spring_energy.cpp", of("1")},
                            {"submission_3/spring_energy.cpp", of("nobody")}};
  const std::string unnamed = "'submission_3' was not read: submission_metadata.yml names no student for it.";
  check_class(files,
              "First Name,Last Name,SID,Email,Sections,Status,Submission Time\nMiles,O'Brien,34,M@x.org,\"A, B\",,\n"
              "Zoë,Müller,007,z@x.org,A,Missing,\n,,,,,,\n",
              {"007: 1", "34: 1", unnamed});
  const MadeUpClass all;
  for (const auto& [path, text] : files) write(all.submissions() / path, *text);
  const Taken taken(all);
  CHECK(summary(taken) == std::vector<std::string>{"0034: 1", "007: 1", unnamed});
  CHECK(taken.student("007").submitted == workbook::read_time("2027-03-01T18:46:33Z"));
}

TEST_CASE(
    "zip files of Windows have its letters and its separators, and a class may lie in several folders or a zip file") {
  const MadeUpClass all;
  const std::string of_windows = zipped(all, {{"\x9a"
                                               "bung\\Woche 3\\spring_energy.cpp",
                                               of("ada")}});  // Übung, CP437
  const ZipEntries inside = {{"ada.zip", of_windows}, {"Ben\\a b\\spring_energy.cpp", of("ben")}};
  const std::string roster = "id,name\nada,Ada\nben,Ben\n";
  const std::vector<std::string> expected = {"ada: ada", "ben: ben"};
  write(all.submissions() / "export.zip", zipped(all, inside));
  CHECK(summary(Taken::with_table(all, "submissions", roster)) == expected);
  check_class({{"outer/.DS_Store", "x"},
               {"outer/inner/ada.zip", of_windows},
               {"outer/inner/ben/x/spring_energy.cpp", of("ben")},
               {"__MACOSX/outer/._inner", of_a_mac}},
              roster, expected);
  check_class({{"ada.zip", of_windows}}, roster, {"ada: ada", "ben: "});
  write_zip(all.root() / "moodle.zip", {{"Zo\x89 M\x81ller_901_assignsubmission_file_/spring_energy.cpp", of("1")},
                                        {"x_2/spring_energy.cpp", of("2")}});
  CHECK(summary(Taken::with_table(all, "moodle.zip", "id,name\n1,Zoë Müller\n2,\n")) ==
        std::vector<std::string>{"1: 1", "2: 2"});
}

TEST_SUITE_END();
