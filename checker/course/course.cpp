#include "checker/course/course.hpp"

#include "checker/base/child_process.hpp"
#include "checker/course/did_you_mean.hpp"
#include "checker/messages/course_files.hpp"
#include "checker/messages/reference_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace workbook {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t published_seed = 1;

/// The results must fit the card: every exercise there, nothing else.
void require_exercises_of(const Card& card, const LectureReference& results, const fs::path& file) {
  for (const CardExercise& exercise : card.exercises) {
    const auto same_name = [&](const ExerciseReference& each) { return each.name == exercise.name; };
    if (std::none_of(results.exercises.begin(), results.exercises.end(), same_name)) {
      throw ReferenceError(messages::results_lack_exercise(file.string(), exercise.name, card.lecture));
    }
  }
}

}  // namespace

Course::Course(const fs::path& course_file) {
  std::ifstream in(course_file);
  if (!in) throw CourseError(messages::course_file_is_missing(course_file.string()));
  std::vector<std::string> lectures;
  try {
    const auto document = nlohmann::json::parse(in);
    const auto path = [&](const char* key) { return fs::path(document.at(key).get<std::string>()); };
    root_ = path("root");
    reference_ = path("reference");
    toolchain_file_ = path("toolchain");
    scratch_ = path("scratch");
    notes_ = path("notes");
    build_ = path("build");
    lectures = document.at("lectures").get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception& problem) {
    throw CourseError(messages::course_file_is_not_usable(course_file.string(), problem.what()));
  }
  for (const std::string& lecture : lectures) cards_.push_back(read_card(root_ / "lectures", lecture));
}

std::vector<Exercise> Course::exercises() const {
  std::vector<Exercise> all;
  for (const Card& card : cards_) {
    for (const CardExercise& entry : card.exercises) all.push_back({&card, &entry});
  }
  return all;
}

std::vector<Exercise> Course::find(const std::string& name) const {
  std::vector<Exercise> of_lecture;
  std::vector<std::string> known;
  for (const Exercise& exercise : exercises()) {
    // An exercise may be called like the topic of a lecture; then the exercise is meant.
    if (name == exercise.name()) return {exercise};
    const std::string& lecture = exercise.lecture();
    const std::size_t separator = lecture.find('_');
    const std::string number = lecture.substr(0, separator);
    const std::string topic = separator == std::string::npos ? lecture : lecture.substr(separator + 1);
    if (name == lecture || name == number || name == topic) of_lecture.push_back(exercise);
    known.push_back(exercise.name());
    known.push_back(lecture);
    known.push_back(topic);
  }
  if (of_lecture.empty()) throw UnknownName(messages::no_such_exercise_or_lecture(name, did_you_mean(name, known)));
  return of_lecture;
}

std::vector<Exercise> Course::choose(const std::vector<std::string>& names) const {
  if (names.empty()) return exercises();
  std::vector<Exercise> all;
  for (const std::string& name : names) {
    for (const Exercise& exercise : find(name)) {
      const bool already =
          std::any_of(all.begin(), all.end(), [&](const Exercise& each) { return each.entry == exercise.entry; });
      if (!already) all.push_back(exercise);
    }
  }
  return all;
}

Exercise Course::find_exercise(const std::string& name) const {
  std::vector<std::string> known;
  for (const Exercise& exercise : exercises()) {
    if (exercise.name() == name) return exercise;
    known.push_back(exercise.name());
  }
  throw UnknownName(messages::no_such_exercise(name, did_you_mean(name, known)));
}

fs::path Course::student_file(const Exercise& exercise) const {
  return lectures() / exercise.lecture() / "exercises" / (exercise.name() + ".cpp");
}

fs::path Course::hints_file(const Exercise& exercise) const {
  return lectures() / exercise.lecture() / "exercises" / (exercise.name() + ".hints.md");
}

fs::path Course::solution_file(const Exercise& exercise) const {
  return root_ / "solutions" / exercise.lecture() / (exercise.name() + ".cpp");
}

fs::path Course::contract_file(const Card& card) const {
  return root_ / "include" / "rigid" / (card.contract + ".hpp");
}

fs::path Course::notes_file(const Card& card) const { return lectures() / card.lecture / "notes.md"; }

bool Course::has_solutions() const { return fs::exists(root_ / "solutions"); }

std::optional<fs::path> Course::notes_page(const std::string& lecture) const {
  const fs::path page = notes_ / ("lecture_" + lecture + ".html");
  if (!fs::exists(page)) return std::nullopt;
  return page;
}

fs::path Course::reference_file(const std::string& lecture) const { return reference_ / (lecture + ".json"); }

LectureReference Course::reference(const std::string& lecture, std::uint64_t seed) const {
  fs::path file = reference_file(lecture);
  if (seed != published_seed) {
    const fs::path program = reference_ / ("reference_" + lecture);
    if (!fs::exists(program)) throw ReferenceError(messages::only_published_seed(published_seed));
    file = scratch_ / "reference" / fmt::format("{}-seed-{}.json", lecture, seed);
    std::error_code ignored;
    if (!fs::exists(file) || fs::last_write_time(file, ignored) < fs::last_write_time(program, ignored)) {
      fs::create_directories(file.parent_path());
      Launch launch;
      const std::string program_name = program.string();
      launch.program = program_name.c_str();
      launch.arguments = {"--lecture", lecture, "--seed", std::to_string(seed), "--out", file.string()};
      const FinishedProgram finished = run_program(launch, std::chrono::seconds(120), 1 << 16);
      if (finished.out_of_time || finished.end.signal != 0 || finished.end.exit_status != 0) {
        throw ReferenceError(messages::making_results_failed(program_name, seed, finished.output));
      }
    }
  }
  LectureReference results = read_reference_results(file);
  const auto card =
      std::find_if(cards_.begin(), cards_.end(), [&](const Card& each) { return each.lecture == lecture; });
  require_exercises_of(*card, results, file);
  return results;
}

}  // namespace workbook
