#include "checker/course/inspection.hpp"

#include "checker/course/hints.hpp"
#include "checker/course/stub.hpp"
#include "checker/messages/workbook_in_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t hints_wanted = 3;

std::string shown(const Course& course, const fs::path& file) {
  return file.lexically_relative(course.root()).string();
}

std::string shown_card(const std::string& lecture) { return "lectures/" + lecture + "/card.json"; }

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Text with all white space squeezed out, so that only words are compared.
std::string squeezed(const std::string& text) {
  std::string result;
  std::copy_if(text.begin(), text.end(), std::back_inserter(result),
               [](unsigned char letter) { return std::isspace(letter) == 0; });
  return result;
}

bool is_backup(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.front() == '.' || name.back() == '~';
}

/// Complains about expected files that are not there, and perhaps about others that are.
void compare_folder(const Course& course, const fs::path& folder, const std::set<fs::path>& expected, bool nothing_else,
                    std::vector<std::string>& faults) {
  for (const fs::path& file : expected) {
    if (!fs::is_regular_file(file)) {
      faults.push_back(messages::file_on_card_is_missing(shown(course, file)));
    }
  }
  if (!nothing_else || !fs::is_directory(folder)) return;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory() || is_backup(entry.path()) || expected.contains(entry.path())) continue;
    faults.push_back(messages::file_on_no_card(shown(course, entry.path())));
  }
}

struct Snippet {
  fs::path file;
  std::string region;
};

std::vector<Snippet> snippets_of(const Course& course, const std::string& notes) {
  std::vector<Snippet> snippets;
  const std::regex pattern(R"(\\snippet\s+(\S+)\s+([^\n]+))");
  for (std::sregex_iterator match(notes.begin(), notes.end(), pattern), end; match != end; ++match) {
    std::string region = (*match)[2];
    region.erase(region.find_last_not_of(' ') + 1);
    snippets.push_back({course.lectures() / (*match)[1].str(), region});
  }
  return snippets;
}

std::size_t count_lines_with(const std::string& text, const std::string& mark) {
  std::size_t count = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + mark.size())) ++count;
  return count;
}

}  // namespace

std::vector<std::string> faults_of_files(const Course& course) {
  std::vector<std::string> faults;
  std::map<std::string, std::string> lecture_of;
  for (const Exercise& exercise : course.exercises()) {
    const auto [first, fresh] = lecture_of.emplace(exercise.name(), exercise.lecture());
    if (!fresh) {
      faults.push_back(messages::exercise_on_two_cards(shown_card(exercise.lecture()), exercise.name(), first->second));
    }
  }
  for (const Card& card : course.cards()) {
    const fs::path folder = course.lectures() / card.lecture;
    std::set<fs::path> expected{folder / "card.json", folder / "notes.md", folder / "worked_examples.cpp",
                                folder / "figures.cpp"};
    std::set<fs::path> solutions{course.root() / "solutions" / card.lecture / "judging.cpp"};
    for (const CardExercise& entry : card.exercises) {
      const Exercise exercise{&card, &entry};
      expected.insert({course.student_file(exercise), course.hints_file(exercise)});
      solutions.insert(course.solution_file(exercise));
    }
    // Where there are no solutions, the folder is a student's, who may keep anything there.
    compare_folder(course, folder, expected, course.has_solutions(), faults);
    if (course.has_solutions())
      compare_folder(course, course.root() / "solutions" / card.lecture, solutions, true, faults);
    if (!fs::is_regular_file(course.contract_file(card))) {
      faults.push_back(messages::contract_is_missing(shown(course, course.contract_file(card)), card.lecture));
    }
    for (const std::string& earlier : card.builds_on) {
      const auto known = [&](const Card& each) { return each.lecture == earlier; };
      if (std::none_of(course.cards().begin(), course.cards().end(), known)) {
        faults.push_back(messages::builds_on_unknown(shown_card(card.lecture), earlier));
      }
    }
  }
  return faults;
}

std::vector<std::string> faults_of_hints(const Course& course, const Exercise& exercise) {
  const fs::path file = course.hints_file(exercise);
  if (!fs::exists(file)) return {};  // faults_of_files says so
  try {
    const std::vector<std::string> hints = read_hints(file);
    if (hints.size() != hints_wanted) {
      return {messages::another_number_of_hints(shown(course, file), hints.size(), hints_wanted)};
    }
    if (std::set<std::string>(hints.begin(), hints.end()).size() != hints.size()) {
      return {messages::two_hints_are_the_same(shown(course, file))};
    }
    return {};
  } catch (const HintError& problem) {
    return {problem.what()};
  }
}

std::vector<std::string> faults_of_stub(const Course& course, const Exercise& exercise,
                                        const ExerciseReference& reference) {
  std::vector<std::string> faults;
  const fs::path file = course.student_file(exercise);
  if (fs::exists(file) &&
      text_of(file) != stub_text(exercise.entry->task, exercise.card->contract, reference.signature)) {
    faults.push_back(messages::not_the_stub(shown(course, file), exercise.name()));
  }
  return faults;
}

std::vector<std::string> faults_of_contract(const Course& course, const Exercise& exercise,
                                            const ExerciseReference& reference) {
  std::vector<std::string> faults;
  const fs::path contract = course.contract_file(*exercise.card);
  if (squeezed(text_of(contract)).find(squeezed(reference.signature + ";")) == std::string::npos) {
    faults.push_back(messages::contract_declares_otherwise(shown(course, contract), reference.signature));
  }
  return faults;
}

std::vector<std::string> faults_of_notes(const Course& course, const Card& card, const LectureReference& reference) {
  const fs::path file = course.notes_file(card);
  if (!fs::exists(file)) return {};  // faults_of_files says so
  const std::string notes = text_of(file);
  const std::string place = shown(course, file);
  std::vector<std::string> faults;

  std::map<std::string, std::string> anchors;  // and who points there
  for (const CardExercise& entry : card.exercises) anchors.emplace(entry.notes, messages::the_card_points());
  for (const ExerciseReference& exercise : reference.exercises) {
    for (const Misconception& misconception : exercise.misconceptions)
      anchors.emplace(misconception.notes, messages::misconception_points(exercise.name, misconception.name));
    for (const Property& property : exercise.properties)
      anchors.emplace(property.notes, messages::property_points(exercise.name));
  }
  for (const auto& [anchor, who] : anchors) {
    if (notes.find("{#" + anchor + "}") == std::string::npos) {
      faults.push_back(messages::no_such_anchor(place, anchor, who));
    }
  }
  for (const Snippet& snippet : snippets_of(course, notes)) {
    const std::size_t marks = count_lines_with(text_of(snippet.file), "[" + snippet.region + "]");
    if (marks != 2) {
      faults.push_back(messages::quoted_without_marks(place, snippet.region, shown(course, snippet.file), marks));
    }
  }
  for (const int fact : card.facts) {
    if (notes.find(fmt::format("<!-- fact {} -->", fact)) == std::string::npos) {
      faults.push_back(messages::fact_is_not_taught(place, fact));
    }
  }
  return faults;
}

}  // namespace workbook
