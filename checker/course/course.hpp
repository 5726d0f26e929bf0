/// @file
/// The course as the checker sees it: where everything lies, which exercises there are, and how far the student is.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/base/text.hpp"
#include "checker/data/reference_results.hpp"

#include <array>
#include <map>
#include <set>

namespace workbook {

namespace fs = std::filesystem;

/// The names are the keys of card.json, here and below.
struct CardExercise {
  std::string name;
  double points = 1.0;
  std::string notes;   ///< anchor of its paragraph
  std::string task;    ///< what to write, in a line or two
  int difficulty = 0;  ///< of a problem, 1 to 3: its statement gives the physics, the formula is to be found; else 0
  int minutes = 0;     ///< that it takes about; of an exercise ten for each point, where the card does not say

  bool is_problem() const { return difficulty > 0; }
};

struct Card {
  std::string lecture;  ///< the folder's name, "03_inertia_tensor"; not on the card
  std::string title;
  std::string summary;
  std::vector<std::string> slides;
  std::vector<std::string> builds_on;
  std::string contract;    ///< header without folder and ending, "inertia_tensor"
  std::vector<int> facts;  ///< numbers of the facts of the slides that it teaches
  std::vector<CardExercise> exercises;
};

/// The course, or a text of it, cannot be used: file, place and reason in one sentence.
struct CourseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// So the file that says where everything is.
struct CourseFileError : CourseError {
  using CourseError::CourseError;
};

/// What was typed means nothing; the sentence says what to type, or what was perhaps meant.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One exercise with its lecture.
struct Exercise {
  const Card* card = nullptr;
  const CardExercise* entry = nullptr;

  const std::string& name() const { return entry->name; }
  const std::string& lecture() const { return card->lecture; }
};

/// Made from the file course.json that the build writes, and from the cards: every folder of lectures/ with a card is a
/// lecture, in the order of their names.
class Course {
 public:
  /// @throws CourseFileError, CourseError
  explicit Course(const fs::path& course_file);

  const std::vector<Card>& cards() const { return cards_; }
  // In course order, all exercises, and those before one, whose functions it may call.
  std::vector<Exercise> exercises() const;
  std::vector<Exercise> exercises_before(const Exercise& exercise) const;

  // What names stand for. @throws UsageError with a proposal
  /// One exercise, or all of a lecture ("03_inertia_tensor", "03", "3", "inertia_tensor").
  std::vector<Exercise> find(const std::string& name) const;
  /// Those of all the names together, each once; without names the whole course.
  std::vector<Exercise> choose(const std::vector<std::string>& names) const;
  Exercise find_exercise(const std::string& name) const;
  /// By name, number or topic; it may have no exercise yet.
  const Card& find_lecture(const std::string& name) const;

  const fs::path& root() const { return root_; }
  /// The file as sentences name it: from the top level on.
  std::string in_course(const fs::path& file) const { return file.lexically_relative(root_).string(); }
  fs::path lectures() const { return root_ / "lectures"; }
  fs::path student_file(const Exercise& exercise) const { return part(exercise, "lectures", "exercises", ".cpp"); }
  fs::path hints_file(const Exercise& exercise) const { return part(exercise, "lectures", "hints", ".md"); }
  // Students do not get these:
  fs::path solution_file(const Exercise& exercise) const { return part(exercise, "solutions", "", ".cpp"); }
  /// What the cases of a lecture find of typical bugs, as an author has recorded it.
  fs::path adequacy_file(const std::string& lecture) const {
    return root_ / "solutions" / lecture / "judging/adequacy.json";
  }
  fs::path judging_file(const Exercise& exercise) const { return part(exercise, "solutions", "judging", ".cpp"); }
  fs::path derivation_file(const Exercise& exercise) const { return part(exercise, "solutions", "derivations", ".md"); }
  /// But solution and derivation in one, which a right function opens.
  fs::path locked_file(const Exercise& exercise) const { return part(exercise, "lectures", "handed_out", ".locked"); }
  fs::path contract_file(const Card& card) const { return root_ / "include" / "rigid" / (card.contract + ".hpp"); }
  fs::path notes_file(const Card& card) const { return lectures() / card.lecture / "notes.md"; }
  const fs::path& toolchain_file() const { return toolchain_file_; }
  bool has_solutions() const { return fs::exists(root_ / "solutions"); }

  const Build& build() const { return build_; }

  /// Builds a target of which a file comes, if one of the sources, files or folders, is newer than that file.
  /// Returns "" or, where that fails, which file says why and what the compiler says first.
  std::string trouble_to_build(const std::string& target, const std::filesystem::path& file,
                               const std::vector<std::filesystem::path>& sources) const;

  /// What the program may write: compiled workers, plots, reference results of other seeds.
  const fs::path& scratch() const { return scratch_; }
  fs::path compiled() const { return scratch_ / "compiled"; }
  fs::path plots() const { return scratch_ / "plots"; }
  void use_scratch(const fs::path& folder) { scratch_ = folder; }

  /// The student's progress, kept apart from the build so that a fresh build does not forget it.
  fs::path progress_file() const { return root_ / ".workbook" / "progress.json"; }

  const fs::path& notes_folder() const { return notes_; }
  /// The page of a lecture there, if the notes have been built.
  std::optional<fs::path> notes_page(const std::string& lecture) const;

  /// Where the reference results of a lecture are: in the copies that students get, beside the lecture; else in the
  /// build, as soon as they have been needed.
  fs::path reference_file(const std::string& lecture) const;

  /// The seed of the cases that count: 1, or what a handed-out copy was drawn with.
  std::uint64_t seed() const { return seed_; }

  /// Reference results of a lecture, or of its exercise `only`. Where there are solutions, they are made from them on
  /// first need and when a solution has changed.
  /// @throws ReferenceError if they are not there, cannot be made or cannot be read, or lack an exercise of the card.
  LectureReference reference(const std::string& lecture, std::uint64_t seed, const std::string& only = "") const;

  /// Builds the reference results of this lecture, and the program that makes them, if anything is newer. @throws
  /// ReferenceError
  void make_reference(const std::string& lecture) const;

  /// Tries typical bugs at all cases of the exercise and at the points of a record, if one is named; that takes up to
  /// minutes. Returns the file of the new record; make_reference() comes before. @throws ReferenceError
  fs::path prove_adequacy(const Exercise& exercise, int seeds, const fs::path& record) const;

  /// What rounding does to these results and to other routes: a line each, part of the tolerance, exercise and case,
  /// between tabs. Builds what it needs; make_reference() comes before. @throws ReferenceError
  std::string rounding(const std::string& lecture) const;

  /// Results at the random cases alone, which take a moment. @throws ReferenceError
  LectureReference random_cases(const std::string& lecture, std::uint64_t seed) const;

  /// From now on takes the results of a lecture from this file, for whichever seed. Returns the seed that they were
  /// made with. @throws ReferenceError, UsageError
  std::uint64_t use_reference(const fs::path& file);

 private:
  fs::path part(const Exercise& exercise, const char* of, const char* folder, const char* ending) const {
    return root_ / of / exercise.lecture() / folder / (exercise.name() + ending);
  }
  fs::path reference_program(const std::string& lecture) const { return reference_ / ("reference_" + lecture); }
  std::vector<fs::path> sources_of_reference(const std::string& lecture) const;
  void run_reference_program(const std::string& lecture, const fs::path& file,
                             const std::vector<std::string>& options) const;

  fs::path root_;
  fs::path reference_;
  fs::path toolchain_file_;
  fs::path scratch_;
  fs::path notes_;
  Build build_;
  std::vector<Card> cards_;
  std::map<std::string, fs::path> given_;  ///< by lecture: reference results to be used
  std::uint64_t seed_ = 1;
};

// --- the texts that belong to an exercise: its hints, its place in the notes, its stub

/// The hints of a file, weakest first, which are separated by lines of three dashes.
/// @throws CourseError if it is missing or holds none.
std::vector<std::string> read_hints(const fs::path& file);

/// The headings of a lecture's notes by their anchors: "steiner" → "The theorem of Steiner". Empty if the file cannot
/// be read: a heading is a help, and the anchor does as well.
std::map<std::string, std::string> read_headings(const fs::path& notes);

/// Anchor of the paragraph of the notes that a comment names for this mistake: <!-- mistakes: NAME NAME … -->; "" if
/// there is none.
std::string paragraph_on_mistake(const Course& course, const std::string& name);

/// The title of the lecture's first worked example that calls the function; "" if none does.
std::string example_that_calls(const Course& course, const Exercise& exercise);

/// An exercise's declaration in the contract, on one line and without the semicolon:
/// "Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r)". "" if the contract does not declare it.
std::string declared_signature(const Course& course, const Exercise& exercise);

/// A text from checker/course/skeletons with its fields, "@NAME@", filled in. @throws std::runtime_error
std::string from_skeleton(const std::string& name, const std::map<std::string, std::string>& fields = {});

/// The text of the stub: where the task is to be read, so that a correction of it never touches a student's file; the
/// contract's header, the function with its TODO.
std::string stub_text(const Exercise& exercise, const std::string& signature);

/// Has the student begun, as far as can be seen without compiling: the file is there and no longer says "not started".
bool is_begun(const fs::path& file);

// --- what the student has done so far. Survives restarts; a damaged file is set aside, never fatal

/// Today's date, "2026-11-22"; WORKBOOK_TODAY sets another one.
std::string current_day();

/// An exercise that was written once more.
struct Review {
  std::string day;      ///< of the last verdict
  std::string verdict;  ///< the first one; "" as long as there is none
};

/// What is known of an exercise.
struct Practice {
  std::string verdict;  ///< "passed", "wrong_value"; "" if it was never checked
  std::string source;   ///< fingerprint of the file that was judged
  std::string values;   ///< fingerprint of the wrong values, if it failed with any
  int wrong_tries = 0;  ///< texts that failed with values
  std::size_t hints_shown = 0;
  std::string passed_on;  ///< the day when it first passed; "" if it has not
  std::vector<Review> reviews;
  std::optional<bool> answered_right;  ///< the first answer to its question
};

class Progress {
 public:
  /// Reads the file; a missing one is an empty progress. A damaged one is renamed to FILE.damaged and warning() says
  /// so.
  explicit Progress(fs::path file) : file_(std::move(file)) { read(); }

  /// Remembers a verdict ("passed", "wrong_value") on a text and writes the file, under another name first, so that it
  /// is never half written. What another checker has written meanwhile is kept. If it cannot be written, warning() says
  /// so and the check goes on.
  /// @param values  fingerprint of what a failing function returned
  /// @return true if another text has just returned the same wrong values
  bool remember(const std::string& exercise, const std::string& verdict, const std::string& source,
                const std::string& values = "");

  void forget(const std::string& exercise);

  Practice of(const std::string& exercise) const {
    return known_.contains(exercise) ? known_.at(exercise) : Practice{};
  }

  /// How many other texts returned wrong values before. @param source  the file's fingerprint
  int wrong_tries_before(const std::string& exercise, const std::string& source) const;

  /// What was checked last: exercise, verdict and day; "" where there is none.
  const std::array<std::string, 3>& last() const { return last_; }

  /// True if the exercise passed and its file has not changed since. @param source  the file's fingerprint
  bool passed(const std::string& exercise, const std::string& source) const {
    return of(exercise).verdict == "passed" && of(exercise).source == source;
  }

  void remember_hints(const std::string& exercise, std::size_t count);
  /// Only the first answer counts.
  void remember_answer(const std::string& exercise, bool is_right);
  void begin_review(const std::string& exercise);
  /// Of the review that was begun last only the first verdict counts.
  void remember_review(const std::string& exercise, const std::string& verdict);

  /// One sentence, or "" if all is well.
  const std::string& warning() const { return warning_; }

 private:
  void read();
  template <class Change>
  void change(const Change& something);

  fs::path file_;
  std::map<std::string, Practice> known_;
  std::array<std::string, 3> last_;
  std::string warning_;
};

/// Which exercises of the course pass as their files stand now, in course order.
struct ProgressSummary {
  std::vector<Exercise> exercises;
  std::set<std::string> passed;  ///< their names

  bool passes(const Exercise& exercise) const { return passed.contains(exercise.name()); }
  /// Those of a lecture; "": of the course.
  std::size_t count_passed(const std::string& lecture = "") const;
  /// The first exercise that does not pass, or nullptr if all do.
  const Exercise* next() const;
};
ProgressSummary summary_of(const Course& course, const Progress& progress);

}  // namespace workbook
