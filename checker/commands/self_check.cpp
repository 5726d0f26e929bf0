#include "checker/commands/commands.hpp"
#include "checker/explain/question.hpp"
#include "checker/explain/repair.hpp"
#include "checker/judging/soundness.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <set>

namespace workbook {

namespace {

/// What is wrong, and the fix; none if all is well.
using Sentences = std::vector<std::string>;

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
    if (!is_there) lines += fmt::format("\n  {}: {}", course.in_course(file), fix);
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
                                 course.in_course(entry.path())));
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
                    course.in_course(notes_file), region, course.in_course(file), marks, region));
  };
  static const std::regex quote(R"(\\snippet\s+(\S+)\s+([^\n]*\S)|\\computed\{([^,}]+),([^}]+)\})");
  for (std::sregex_iterator match(notes.begin(), notes.end(), quote), end; match != end; ++match) {
    if ((*match)[1].matched) require_marks(course.lectures() / (*match)[1].str(), (*match)[2]);
    for (const char* part : {"", " in brief"})
      if ((*match)[3].matched)
        require_marks(course.lectures() / (*match)[3].str() / "worked_examples.cpp", (*match)[4].str() + part);
  }
}

/// Exercises that stand on two cards.
Sentences faults_of_cards(const Course& course) {
  Sentences faults;
  std::map<std::string, std::string> lecture_of;
  for (const Exercise& exercise : course.exercises())
    if (const auto [first, is_new] = lecture_of.emplace(exercise.name(), exercise.lecture()); !is_new)
      faults.push_back(fmt::format("lectures/{}/card.json: the exercise '{}' is on the card of {} too; rename one.",
                                   exercise.lecture(), exercise.name(), first->second));
  return faults;
}

/// Parts of a lecture that are missing, files that belong to no exercise, and lectures that it builds on and that do
/// not exist.
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

/// Hints that are too few or the same, a stub that is not the one its card makes, a contract that declares another
/// function than is judged.
Sentences faults_of_texts(const Course& course, const Exercise& exercise, const ExerciseReference& reference) {
  Sentences faults;
  const fs::path hints_file = course.hints_file(exercise);
  try {
    const std::vector<std::string> hints = read_hints(hints_file);
    if (hints.size() != hints_wanted)
      faults.push_back(fmt::format("{}: {} instead of {}; separate them by lines of three dashes.",
                                   course.in_course(hints_file), plural(hints.size(), "hint"), hints_wanted));
    if (std::set<std::string>(hints.begin(), hints.end()).size() != hints.size())
      faults.push_back(fmt::format("{}: two hints are the same; write another.", course.in_course(hints_file)));
  } catch (const CourseError& problem) {
    faults.emplace_back(problem.what());
  }
  const std::string declared = declared_signature(course, exercise);
  if (declared != reference.signature)
    faults.push_back(fmt::format(
        "{}: declares `{}`, but `{}` is judged; make contract and judging agree, names of the arguments included.",
        course.in_course(course.contract_file(*exercise.card)), declared, reference.signature));
  // Where there are no solutions, the exercises belong to a student, who may have solved them.
  const fs::path stub = course.student_file(exercise);
  if (course.has_solutions() && text_of(stub) != stub_text(exercise, declared))
    faults.push_back(fmt::format("{}: not the stub that the card makes (is it solved?); `{}` puts it back.",
                                 course.in_course(stub), command("reset " + exercise.name())));
  return faults;
}

/// Anchors that a misconception or a property points to and the notes do not have; examples quoted by the notes whose
/// marks are missing; facts of the card that no paragraph teaches.
Sentences faults_of_notes(const Course& course, const Card& card, const LectureReference& reference) {
  const fs::path file = course.notes_file(card);
  const std::string notes = text_of(file);
  const std::string place = course.in_course(file);
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

/// Runs a stub or a solution; its verdict is the one that it should have, without an explanation.
Sentences faults_of_verdict(CheckContext& context, const Exercise& exercise, std::uint64_t seed, const fs::path& file,
                            Verdict wanted) {
  const Course& course = context.course();
  const CheckResult checked = check_exercise(context, check_task(course, exercise, seed, file));
  const std::string shown = course.in_course(file);
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

/// One line, and one for each bug that no case shows.
std::string adequacy_text(const Exercise& exercise, const Adequacy& adequacy) {
  std::string text = fmt::format("{:.2} {:<30} {:>3} of {:>3} bugs found, {} equal in the domain\n", exercise.lecture(),
                                 exercise.name(), adequacy.killed, adequacy.made, adequacy.equal);
  for (const std::string& bug : adequacy.survivors)
    text += fmt::format("   not found: {}. {}\n", bug, adequacy.reason(bug));
  return text;
}

/// Collects what is wrong, each sentence once, and counts what was looked at.
class SelfCheck {
 public:
  SelfCheck(const Course& course, std::vector<Exercise> exercises, const std::vector<std::uint64_t>& seeds)
      : course_(course), context_(course), exercises_(std::move(exercises)), seeds_(seeds) {}

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
    fmt::print("{}", adequacy_);
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
      const std::string judging = course_.in_course(course_.judging_file(exercise));
      for (const std::string& sentence : unsound_parts(judged)) add({fmt::format("{}: {}", judging, sentence)});
      if (is_first) {
        routes_ += judged.routes.size();
        misconceptions_ += judged.misconceptions.size();
        adequacy_ += adequacy_text(exercise, judged.adequacy);
        add(faults_of_texts(course_, exercise, judged));
        if (!question_on(judged))
          add({judging +
               ": no case tells three of its wrong answers apart, as the question after a pass needs; add one."});
      }
      if (!course_.has_solutions()) continue;
      const auto require = [&](const fs::path& file, Verdict wanted) {
        add(faults_of_verdict(context_, exercise, seed, file, wanted));
      };
      if (is_first) require(course_.student_file(exercise), Verdict::not_started);
      require(course_.solution_file(exercise), Verdict::passed);
    }
  }

  void add(const Sentences& sentences) {
    for (const std::string& sentence : sentences) {
      if (std::ranges::find(faults_, sentence) == faults_.end()) faults_.push_back(sentence);
    }
  }

  const Course& course_;
  CheckContext context_;
  const std::vector<Exercise> exercises_;
  const std::vector<std::uint64_t> seeds_;
  std::string adequacy_;
  Sentences faults_;
  std::size_t routes_ = 0;
  std::size_t misconceptions_ = 0;
};

/// "line 7, another sign: return -x"
std::string name_of(const Variant& mutant, const std::string& text) {
  const bool is_gone = mutant.kind == "statement";
  const auto line = static_cast<std::size_t>(mutant.place.line);
  std::string changed = lines_of(is_gone ? text : edited(text, mutant.edits)).at(line - 1);
  changed.erase(0, changed.find_first_not_of(' '));
  changed.erase(changed.find_last_not_of(';') + 1);
  return fmt::format("line {}, {}: {}", line, mutant.words, changed);
}

/// How many there are, and those that no case shows.
nlohmann::json try_mutants(const Course& course, const Toolchain& toolchain, const Exercise& exercise,
                           const ExerciseReference& reference) {
  constexpr std::size_t at_once = 150;  // compiled in well under a minute
  const Submission solution = read_submission(course.solution_file(exercise));
  const Observation no_observation;
  const Judgement no_judgement;
  const DiagnosticTask task{solution, reference, no_observation, no_judgement};
  const std::vector<Variant> all = source_mutants(SourceText(solution.text), reference);
  std::size_t made = 0;
  std::vector<std::string> survivors;
  for (std::size_t first = 0; first < all.size(); first += at_once) {
    std::vector<Variant> mutants = {Variant{}};  // the solution itself, to be sure of the rest
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), std::min(at_once, all.size() - first),
                std::back_inserter(mutants));
    VariantRunner runner(task, mutants, toolchain, course.compiled(),
                         {.compilations = 50,
                          .compiling = std::chrono::minutes(5),
                          .running = std::chrono::minutes(10),
                          .one_variant = std::chrono::seconds(1)});
    if (!mutants.front().edits.empty() || !runner.is_right(0))
      throw std::runtime_error("the solution itself does not pass");
    made += mutants.size() - 1;
    for (std::size_t k = 1; k < mutants.size(); ++k)
      if (runner.is_right(k)) survivors.push_back(name_of(mutants[k], solution.text));
  }
  return {{"made", made}, {"survivors", survivors}};
}

}  // namespace

int self_check(const Course& course, const std::vector<std::string>& names, std::vector<std::uint64_t> seeds) {
  if (!course.has_solutions()) seeds = {course.seed()};
  const std::vector<Exercise> exercises = course.choose(names);
  std::vector<const Card*> cards;
  for (const Card& card : course.cards()) {
    const auto is_of_card = [&](const Exercise& exercise) { return exercise.card == &card; };
    if (names.empty() || std::ranges::any_of(exercises, is_of_card)) cards.push_back(&card);
  }
  return SelfCheck(course, exercises, seeds).run(cards);
}

int self_check_mutants(const Course& course, const std::vector<std::string>& names) {
  if (!course.has_solutions())
    throw UsageError("Mutants are made of solutions, and this copy of the workbook has none.");
  const std::vector<Exercise> exercises = course.choose(names);
  CheckContext context(course);
  for (const Exercise& exercise : exercises) context.reference(check_task(course, exercise));
  const auto begin = [&](std::size_t k) {
    const ExerciseReference& reference = context.reference(check_task(course, exercises[k]));
    const auto try_all = [&] {
      try {
        return try_mutants(course, context.toolchain(), exercises[k], reference).dump();
      } catch (const std::exception& problem) {
        return nlohmann::json{{"problem", problem.what()}}.dump();
      }
    };
    return std::make_unique<ForkedJob>(try_all, std::chrono::minutes(20));
  };
  ProgressBar progress_bar;
  std::vector<std::string> tried(exercises.size()), faults(exercises.size());
  std::size_t made = 0, killed = 0, done = 0;
  run_jobs(exercises.size(), begin, [&](std::size_t k, ForkedJob& job) {
    const Exercise& exercise = exercises[k];
    progress_bar.show(++done, exercises.size(), exercise.name());
    std::string trouble = job.finish();
    const auto found = nlohmann::json::parse(job.output(), nullptr, false);
    if (trouble.empty()) trouble = found.value("problem", "");
    if (!trouble.empty()) {
      faults[k] = fmt::format("{}: its mutants could not be tried: {}.\n",
                              course.in_course(course.solution_file(exercise)), without_full_stop(trouble));
      return;
    }
    Adequacy adequacy = context.reference(check_task(course, exercise)).adequacy;
    adequacy.made = found.at("made");
    adequacy.survivors = found.at("survivors").get<std::vector<std::string>>();
    adequacy.killed = adequacy.made - adequacy.survivors.size();
    adequacy.equal = 0;
    made += adequacy.made;
    killed += adequacy.killed;
    tried[k] = adequacy_text(exercise, adequacy);
    for (const std::string& sentence : unshown_bugs(adequacy))
      faults[k] += fmt::format("{}: {}\n", course.in_course(course.judging_file(exercise)), sentence);
  });
  progress_bar.clear();
  fmt::print("{}{}In all: {} of {} bugs found.\n", fmt::join(tried, ""), fmt::join(faults, ""), killed, made);
  const bool has_fault = !std::ranges::all_of(faults, &std::string::empty);
  return has_fault ? something_failed : all_passed;
}

}  // namespace workbook
