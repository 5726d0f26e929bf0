#include "checker/course/inspection.hpp"

#include "checker/base/text.hpp"
#include "checker/course/exercise_texts.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace workbook {

namespace {

constexpr std::size_t hints_wanted = 3;

std::string text_of(const fs::path& file) { return read_file(file).value_or(""); }

bool has_anchor(const std::string& notes, const std::string& anchor) {
  return notes.find("{#" + anchor + "}") != std::string::npos;
}

/// Collects what is missing, to be named in one message.
struct MissingParts {
  const Course& course;
  std::string what;
  std::string lines = {};

  void require(const fs::path& file, bool is_there, const std::string& fix) {
    if (!is_there) lines += fmt::format("\n  {}: {}", in_course(course, file), fix);
  }
  void require_file(const fs::path& file, const std::string& fix) { require(file, fs::is_regular_file(file), fix); }
  Sentences message() const {
    if (lines.empty()) return {};
    return {fmt::format("{}: write what is missing, or remove the entry from the card.{}", what, lines)};
  }
};

/// Files of a folder that belong to nothing. Dot-files and editors' backups do not count.
void name_strays(const Course& course, const fs::path& folder, const std::set<fs::path>& known, Sentences& faults) {
  if (!fs::is_directory(folder)) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory() || name.starts_with('.') || name.ends_with('~') || known.contains(entry.path())) continue;
    faults.push_back(fmt::format("{}: no card lists it; add its exercise to the card, or move the file away.",
                                 in_course(course, entry.path())));
  }
}

/// What the notes quote, and what is wrong with its marks: regions of files. A worked example is quoted twice, its
/// lines in brief and the whole of it.
void name_unmarked_quotes(const Course& course, const fs::path& notes_file, const std::string& notes,
                          Sentences& faults) {
  const auto require_marks = [&](const fs::path& file, const std::string& region) {
    const std::string text = text_of(file), mark = "[" + region + "]";
    std::size_t marks = 0;
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += mark.size()) ++marks;
    if (marks == 2) return;
    faults.push_back(
        fmt::format("{}: quotes '{}' of {}, which has {} of the two marks `//! [{}]`; put them around the example.",
                    in_course(course, notes_file), region, in_course(course, file), marks, region));
  };
  static const std::regex quote(R"(\\snippet\s+(\S+)\s+([^\n]*\S)|\\computed\{([^,}]+),([^}]+)\})");
  for (std::sregex_iterator match(notes.begin(), notes.end(), quote), end; match != end; ++match) {
    if ((*match)[1].matched) require_marks(course.lectures() / (*match)[1].str(), (*match)[2]);
    for (const char* part : {"", " in brief"})
      if ((*match)[3].matched)
        require_marks(course.lectures() / (*match)[3].str() / "worked_examples.cpp", (*match)[4].str() + part);
  }
}

}  // namespace

std::string in_course(const Course& course, const fs::path& file) {
  return file.lexically_relative(course.root()).string();
}

Sentences faults_of_cards(const Course& course) {
  Sentences faults;
  std::map<std::string, std::string> lecture_of;
  for (const Exercise& exercise : course.exercises())
    if (const auto [first, is_new] = lecture_of.emplace(exercise.name(), exercise.lecture()); !is_new)
      faults.push_back(fmt::format("lectures/{}/card.json: the exercise '{}' is on the card of {} too; rename one.",
                                   exercise.lecture(), exercise.name(), first->second));
  return faults;
}

Sentences faults_of_lecture(const Course& course, const Card& card) {
  const fs::path folder = course.lectures() / card.lecture;
  MissingParts parts{course, card.lecture};
  parts.require_file(course.contract_file(card), "the contract that the card names");
  parts.require_file(folder / "notes.md", "the notes");
  parts.require_file(folder / "worked_examples.cpp", "the worked examples, as cases of doctest");
  parts.require_file(folder / "figures.cpp", "the program that draws the figures");
  Sentences faults = parts.message();
  for (const std::string& earlier : card.builds_on) {
    if (std::ranges::find(course.cards(), earlier, &Card::lecture) == course.cards().end())
      faults.push_back(fmt::format("lectures/{}/card.json: builds_on names '{}', which is no lecture of the course.",
                                   card.lecture, earlier));
  }
  if (!course.has_solutions()) return faults;  // a student may keep any file there
  const fs::path solutions = course.root() / "solutions" / card.lecture;
  std::set<fs::path> known = {solutions / "shared.hpp"};
  for (const CardExercise& entry : card.exercises) {
    const Exercise exercise{&card, &entry};
    known.insert({course.student_file(exercise), course.hints_file(exercise), course.solution_file(exercise),
                  course.judging_file(exercise), course.derivation_file(exercise)});
  }
  for (const fs::path& each :
       {folder / "exercises", folder / "hints", solutions, solutions / "judging", solutions / "derivations"})
    name_strays(course, each, known, faults);
  return faults;
}

Sentences stray_exercises(const Course& course, const Card& card) {
  std::vector<std::string> names;
  for (const CardExercise& entry : card.exercises) names.push_back(entry.name);
  Sentences remarks;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(course.lectures() / card.lecture / "exercises", problem)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".cpp" || name.starts_with('.') || std::ranges::count(names, name) > 0) continue;
    const std::string meant = did_you_mean(name, names);
    remarks.push_back(fmt::format("{} is no exercise of the course and is not checked.{}",
                                  in_course(course, entry.path()),
                                  meant.empty() ? "" : fmt::format(" Did you mean {}.cpp?", meant)));
  }
  return remarks;
}

Sentences faults_of_parts(const Course& course, const Exercise& exercise) {
  const Card& card = *exercise.card;
  MissingParts parts{course, card.lecture + ", " + exercise.name()};
  parts.require(course.contract_file(card), !declared_signature(course, exercise).empty(),
                fmt::format("the declaration `TYPE {}(...);`", exercise.name()));
  parts.require_file(course.hints_file(exercise), "three hints, weakest first, with lines of three dashes between");
  parts.require(course.notes_file(card), has_anchor(text_of(course.notes_file(card)), exercise.entry->notes),
                fmt::format("a heading with the anchor {{#{}}}, to which the card points", exercise.entry->notes));
  if (course.has_solutions()) {
    parts.require_file(course.student_file(exercise),
                       fmt::format("the stub; `{}` writes it", command("reset " + exercise.name())));
    parts.require_file(course.solution_file(exercise), "the solution");
    parts.require_file(course.judging_file(exercise), "how it is judged");
    parts.require_file(course.derivation_file(exercise), "another route to the same result, and why it is equal");
  }
  return parts.message();
}

Sentences faults_of_texts(const Course& course, const Exercise& exercise, const ExerciseReference& reference) {
  Sentences faults;
  const fs::path hints_file = course.hints_file(exercise);
  try {
    const std::vector<std::string> hints = read_hints(hints_file);
    if (hints.size() != hints_wanted)
      faults.push_back(fmt::format("{}: {} instead of {}; separate them by lines of three dashes.",
                                   in_course(course, hints_file), plural(hints.size(), "hint"), hints_wanted));
    if (std::set<std::string>(hints.begin(), hints.end()).size() != hints.size())
      faults.push_back(fmt::format("{}: two hints are the same; write another.", in_course(course, hints_file)));
  } catch (const CourseError& problem) {
    faults.emplace_back(problem.what());
  }
  const std::string declared = declared_signature(course, exercise);
  if (declared != reference.signature)
    faults.push_back(fmt::format(
        "{}: declares `{}`, but `{}` is judged; make contract and judging agree, names of the arguments included.",
        in_course(course, course.contract_file(*exercise.card)), declared, reference.signature));
  // Where there are no solutions, the exercises belong to a student, who may have solved them.
  const fs::path stub = course.student_file(exercise);
  if (course.has_solutions() && text_of(stub) != stub_text(*exercise.entry, exercise.card->contract, declared))
    faults.push_back(fmt::format("{}: not the stub that the card makes (is it solved?); `{}` puts it back.",
                                 in_course(course, stub), command("reset " + exercise.name())));
  return faults;
}

Sentences faults_of_notes(const Course& course, const Card& card, const LectureReference& reference) {
  const fs::path file = course.notes_file(card);
  const std::string notes = text_of(file);
  const std::string place = in_course(course, file);
  std::map<std::string, std::string> anchors;  // and what points there
  for (const ExerciseReference& exercise : reference.exercises) {
    for (const Misconception& each : exercise.misconceptions)
      anchors.emplace(each.notes, exercise.name + ", " + each.name);
    for (const Property& each : exercise.properties) anchors.emplace(each.notes, exercise.name + ", a property");
  }
  anchors.erase("");  // the anchor of the card
  Sentences faults;
  for (const auto& [anchor, what] : anchors) {
    if (!has_anchor(notes, anchor))
      faults.push_back(fmt::format(
          "{}: no paragraph has the anchor '{}', to which {} points; add {{#{}}} to a heading, or correct the pointer.",
          place, anchor, what, anchor));
  }
  name_unmarked_quotes(course, file, notes, faults);
  for (const int fact : card.facts) {
    if (notes.find(fmt::format("<!-- fact {} -->", fact)) == std::string::npos)
      faults.push_back(fmt::format(
          "{}: no paragraph is marked with `<!-- fact {} -->`, though the card says that the lecture teaches it.",
          place, fact));
  }
  return faults;
}

}  // namespace workbook
