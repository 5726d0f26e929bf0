#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/inspection.hpp"
#include "checker/judging/soundness.hpp"
#include "checker/pipeline/check_exercise.hpp"
#include "checker/report/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook {

namespace {

/// Runs a stub or a solution; its verdict is the one that it should have, without an explanation.
Sentences faults_of_verdict(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                            const ExerciseReference& reference, const std::filesystem::path& file, Verdict wanted) {
  const CheckResult checked = check_exercise(course, toolchain, check_task(course, exercise, 1, file), reference);
  const std::string shown = file.lexically_relative(course.root()).string();
  if (checked.judgement.verdict != wanted)
    return {fmt::format("{}: the verdict is {}, not {}: {} {}", shown, to_string(checked.judgement.verdict),
                        to_string(wanted), checked.judgement.message,
                        wanted == Verdict::passed
                            ? "Correct the solution or its judging."
                            : fmt::format("`{}` puts the stub back.", command("reset " + exercise.name())))};
  if (wanted == Verdict::passed && !checked.explanation.is_empty())
    return {fmt::format("{}: passes, and a fault is explained all the same.", shown)};
  return {};
}

/// Collects what is wrong, each sentence once, and counts what was looked at.
class SelfCheck {
 public:
  SelfCheck(const Course& course, std::vector<Exercise> exercises, const std::vector<std::uint64_t>& seeds)
      : course_(course),
        toolchain_(read_toolchain(course.toolchain_file())),
        exercises_(std::move(exercises)),
        seeds_(seeds) {}

  int run(const std::vector<const Card*>& cards) {
    add(faults_of_cards(course_));
    std::size_t done = 0;
    ProgressBar progress_bar;
    for (const Card* card : cards) {
      const std::size_t before = faults_.size();
      check_parts(*card);
      for (const std::uint64_t seed : seeds_) {
        progress_bar.show(done++, cards.size() * seeds_.size(), fmt::format("{}, seed {}", card->lecture, seed));
        if (faults_.size() > before) continue;  // without all its parts a lecture cannot be built
        try {
          check_lecture(*card, seed);
        } catch (const ReferenceError& problem) {
          add({problem.what()});
        }
      }
    }
    progress_bar.clear();
    for (const std::string& line : adequacy_) fmt::print("{}\n", line);
    for (const std::string& sentence : faults_) fmt::print("{}\n", sentence);
    if (!faults_.empty()) {
      fmt::print("{} to fix.\n", plural(faults_.size(), "fault"));
      return something_failed;
    }
    fmt::print("In order: {}, {}, {}, {}, {}.\n", plural(cards.size(), "lecture"),
               plural(exercises_.size(), "exercise"), plural(routes_, "right route"),
               plural(misconceptions_, "wrong answer"), plural(seeds_.size(), "seed"));
    return all_passed;
  }

 private:
  std::vector<Exercise> exercises_of(const Card& card) const {
    std::vector<Exercise> all;
    std::ranges::copy_if(exercises_, std::back_inserter(all), [&](const Exercise& each) { return each.card == &card; });
    return all;
  }

  void check_parts(const Card& card) {
    add(faults_of_lecture(course_, card));
    if (card.exercises.empty())
      add({fmt::format("lectures/{}/card.json: no exercise yet; `{}` adds one.", card.lecture,
                       command("new exercise NAME --lecture " + card.lecture + " --signature '...'"))});
    for (const Exercise& exercise : exercises_of(card)) add(faults_of_parts(course_, exercise));
  }

  void check_lecture(const Card& card, std::uint64_t seed) {
    const bool is_first = seed == seeds_.front();
    const LectureReference reference = course_.reference(card.lecture, seed);
    if (is_first) add(faults_of_notes(course_, card, reference));
    for (const Exercise& exercise : exercises_of(card)) {
      const ExerciseReference& judged = reference.exercise(exercise.name());
      for (const std::string& sentence : unsound_parts(judged))
        add({fmt::format("solutions/{}/{}.judging.cpp: {}", card.lecture, exercise.name(), sentence)});
      if (is_first) {
        routes_ += judged.routes.size();
        misconceptions_ += judged.misconceptions.size();
        add_adequacy(card, judged);
        add(faults_of_texts(course_, exercise, judged));
      }
      if (!course_.has_solutions()) continue;
      const auto require = [&](const std::filesystem::path& file, Verdict wanted) {
        add(faults_of_verdict(course_, toolchain_, exercise, judged, file, wanted));
      };
      if (is_first) require(course_.student_file(exercise), Verdict::not_started);
      require(course_.solution_file(exercise), Verdict::passed);
    }
  }

  void add_adequacy(const Card& card, const ExerciseReference& judged) {
    const Adequacy& adequacy = judged.adequacy;
    adequacy_.push_back(fmt::format("{:.2} {:<30} {:>3} of {:>3} bugs found, {} equal in the domain", card.lecture,
                                    judged.name, adequacy.killed, adequacy.made, adequacy.equal));
    for (const std::string& bug : adequacy.survivors)
      adequacy_.push_back(fmt::format("   not found: {}. {}", bug, adequacy.reason(bug)));
  }

  void add(const Sentences& sentences) {
    for (const std::string& sentence : sentences) {
      if (std::ranges::find(faults_, sentence) == faults_.end()) faults_.push_back(sentence);
    }
  }

  const Course& course_;
  const Toolchain toolchain_;
  const std::vector<Exercise> exercises_;
  const std::vector<std::uint64_t> seeds_;
  Sentences adequacy_;  // one line per exercise, and its bugs that no case shows
  Sentences faults_;
  std::size_t routes_ = 0;
  std::size_t misconceptions_ = 0;
};

}  // namespace

int self_check(const Course& course, const std::vector<std::string>& names, const std::vector<std::uint64_t>& seeds) {
  const std::vector<Exercise> exercises = course.choose(names);
  std::vector<const Card*> cards;
  for (const Card& card : course.cards()) {
    const auto is_of_card = [&](const Exercise& exercise) { return exercise.card == &card; };
    if (names.empty() || std::ranges::any_of(exercises, is_of_card)) cards.push_back(&card);
  }
  return SelfCheck(course, exercises, seeds).run(cards);
}

}  // namespace workbook
