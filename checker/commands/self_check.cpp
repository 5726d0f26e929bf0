#include "checker/commands/commands.hpp"
#include "checker/course/inspection.hpp"
#include "checker/judging/inconsistencies.hpp"
#include "checker/messages/workbook_in_order.hpp"
#include "checker/pipeline/check_exercise.hpp"
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

/// Runs one file, a stub or a solution, and complains unless the verdict is the one that it should have.
void require_verdict(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                     const ExerciseReference& reference, const std::filesystem::path& file, Verdict wanted,
                     Faults& faults) {
  if (!std::filesystem::exists(file)) return;  // faults_of_files says so
  const Checked checked = check_exercise(course, toolchain, exercise, reference, file);
  const std::string shown = file.lexically_relative(course.root()).string();
  if (checked.judgement.verdict != wanted) {
    faults.add(wanted == Verdict::passed
                   ? messages::solution_is_judged_otherwise(shown, checked.judgement)
                   : messages::stub_is_judged_otherwise(shown, checked.judgement, exercise.name()));
  } else if (!checked.judgement.diagnoses.empty()) {
    faults.add(messages::passes_and_is_accused(shown, checked.judgement.diagnoses.front().message));
  }
}

}  // namespace

int self_check(const Course& course, const std::vector<std::uint64_t>& seeds) {
  Faults faults;
  faults.add(faults_of_files(course));
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  messages::Extent extent{.lectures = course.cards().size(),
                          .exercises = course.exercises().size(),
                          .routes = 0,
                          .misconceptions = 0,
                          .seeds = seeds.size()};
  ProgressBar progress_bar;
  std::size_t done = 0;
  const auto check_lecture = [&](const Card& card) {
    for (const std::uint64_t seed : seeds) {
      progress_bar.show(done++, course.cards().size() * seeds.size(), messages::lecture_and_seed(card.lecture, seed));
      const LectureReference reference = course.reference(card.lecture, seed);
      const bool first = seed == seeds.front();
      if (first) faults.add(faults_of_notes(course, card, reference));
      for (const CardExercise& entry : card.exercises) {
        const Exercise exercise{&card, &entry};
        const ExerciseReference& judged = reference.exercise(entry.name);
        for (const std::string& sentence : inconsistencies(judged)) {
          faults.add(messages::judging_is_inconsistent(card.lecture, entry.name, sentence));
        }
        if (first) {
          extent.routes += judged.routes.size();
          extent.misconceptions += judged.misconceptions.size();
          faults.add(faults_of_hints(course, exercise));
          faults.add(faults_of_contract(course, exercise, judged));
        }
        // Where there are no solutions, the exercises belong to a student, who may have solved them.
        if (first && course.has_solutions()) {
          faults.add(faults_of_stub(course, exercise, judged));
          require_verdict(course, toolchain, exercise, judged, course.student_file(exercise), Verdict::not_started,
                          faults);
        }
        if (course.has_solutions()) {
          require_verdict(course, toolchain, exercise, judged, course.solution_file(exercise), Verdict::passed, faults);
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
    fmt::print("{}\n", messages::to_mend(faults.all().size()));
    return something_failed;
  }
  fmt::print("{}\n", messages::in_order(extent));
  return all_passed;
}

}  // namespace workbook
