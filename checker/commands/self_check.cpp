#include "checker/commands/check_exercise.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/inspection.hpp"
#include "checker/judging/inconsistencies.hpp"
#include "checker/report/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace workbook {

namespace {

/// Collects sentences, each once.
class Faults {
 public:
  void add(const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
      if (std::find(all_.begin(), all_.end(), sentence) == all_.end()) all_.push_back(sentence);
    }
  }
  void add(const std::string& sentence) { add(std::vector<std::string>{sentence}); }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

/// Runs one file and complains unless the verdict is the wanted one.
void require_verdict(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                     const ExerciseReference& reference, const std::filesystem::path& file, Verdict wanted,
                     const std::string& consequence, Faults& faults) {
  if (!std::filesystem::exists(file)) return;  // faults_of_files says so
  const Checked checked = check_exercise(course, toolchain, exercise, reference, file);
  if (checked.judgement.verdict != wanted) {
    faults.add(fmt::format("{}: the verdict is {}, not {}: {} {}", file.lexically_relative(course.root()).string(),
                           to_string(checked.judgement.verdict), to_string(wanted), checked.judgement.message,
                           consequence));
  } else if (!checked.judgement.diagnoses.empty()) {
    faults.add(fmt::format("{}: passes and is accused all the same: {}",
                           file.lexically_relative(course.root()).string(),
                           checked.judgement.diagnoses.front().message));
  }
}

}  // namespace

int self_check(const Course& course, const std::vector<std::uint64_t>& seeds) {
  Faults faults;
  faults.add(faults_of_files(course));
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  std::size_t routes = 0;
  std::size_t misconceptions = 0;
  ProgressBar progress_bar;
  std::size_t done = 0;
  const auto check_lecture = [&](const Card& card) {
    for (const std::uint64_t seed : seeds) {
      progress_bar.show(done++, course.cards().size() * seeds.size(), fmt::format("{}, seed {}", card.lecture, seed));
      const LectureReference reference = course.reference(card.lecture, seed);
      const bool first = seed == seeds.front();
      if (first) faults.add(faults_of_notes(course, card, reference));
      for (const CardExercise& entry : card.exercises) {
        const Exercise exercise{&card, &entry};
        const ExerciseReference& judged = reference.exercise(entry.name);
        for (const std::string& sentence : inconsistencies(judged)) {
          faults.add(fmt::format("solutions/{}/judging.cpp: {}: {}", card.lecture, entry.name, sentence));
        }
        if (first) {
          routes += judged.routes.size();
          misconceptions += judged.misconceptions.size();
          faults.add(faults_of_hints(course, exercise));
          faults.add(faults_of_contract(course, exercise, judged));
        }
        // Where there are no solutions, the exercises belong to a student, who may have solved them.
        if (first && course.has_solutions()) {
          faults.add(faults_of_stub(course, exercise, judged));
          require_verdict(course, toolchain, exercise, judged, course.student_file(exercise), Verdict::not_started,
                          fmt::format("`checker reset {}` puts the stub back.", entry.name), faults);
        }
        if (course.has_solutions()) {
          require_verdict(course, toolchain, exercise, judged, course.solution_file(exercise), Verdict::passed,
                          "Mend the solution or its judging.", faults);
        }
      }
    }
  };
  for (const Card& card : course.cards()) {
    try {
      check_lecture(card);
    } catch (const ReferenceError& problem) {
      faults.add(problem.what());
    }
  }
  progress_bar.clear();

  for (const std::string& sentence : faults.all()) fmt::print("{}\n", sentence);
  if (!faults.all().empty()) {
    fmt::print("{} thing{} to mend.\n", faults.all().size(), faults.all().size() == 1 ? "" : "s");
    return something_failed;
  }
  fmt::print("In order: {} lectures, {} exercises, {} right routes, {} wrong answers, {} seed{}.\n",
             course.cards().size(), course.exercises().size(), routes, misconceptions, seeds.size(),
             seeds.size() == 1 ? "" : "s");
  return all_passed;
}

}  // namespace workbook
