/// @file
/// A class is graded: what was handed in, what has been judged, and what came of it.
#pragma once

#include "checker/course/assignment.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <map>
#include <set>

namespace workbook {

// --- what a class has handed in: whatever lies there, only files with the names of exercises are read, each for one
// student, and copied to fixed names

/// What a person has decided about one exercise of a student, or about the whole. A row of overrides.csv.
struct Override {
  std::optional<double> points;  ///< in place of what was earned; those of the whole also of what lateness leaves
  bool is_excused = false;       ///< it is not counted
  std::optional<std::int64_t> due = {};  ///< of the whole only
  std::string sentence = {};             ///< all this and the comment, as it is shown

  bool decides() const { return points || is_excused; }
};

/// What was found for one exercise. Of files in several of these places those in the last one count.
struct HandedIn {
  enum Place { under_another_name, anywhere, in_place };  ///< in place: where the workbook has it

  Place place = anywhere;
  std::string where;         ///< in the submissions, as it may be shown
  std::string refusal = {};  ///< one sentence; "": it was copied
};

/// As a roster or a learning system names them, and what they have handed in.
struct Student {
  std::string id = {};    ///< once taken in, as it may be shown
  std::string name = {};  ///< of the roster; may be empty
  std::string slug = {};  ///< names this student's files: letters, digits, "-", "_" and "."
  fs::path copies = {};   ///< the folder with copies of what was handed in
  std::optional<std::int64_t> submitted = {};
  std::vector<std::string> aliases = {};       ///< other names that learning systems use: e-mail, login, number
  std::map<std::string, HandedIn> files = {};  ///< by exercise
  /// By exercise, as the progress file says that was handed in; nothing: there is none that can be read.
  std::optional<std::map<std::string, std::size_t>> hints = {};
  std::vector<std::string> notes = {};   ///< what else is to be said of the submission
  std::vector<std::string> unread = {};  ///< what was not read, so that points may be missing
  std::string group = {};                ///< that hands in together
  std::string entry = {};                ///< the top-level entry that is theirs, perhaps with others; a table may say
  /// Another such entry names this student as well: one sentence. Nothing is judged then: one may be somebody else's.
  std::string dispute = {};
  std::map<std::string, Override> by_hand = {};  ///< by exercise; "": the whole
  std::string attempt = {};                      ///< which of several counts
  std::vector<Student> attempts = {};  ///< in their order, where they are told apart; then there is no more yet
  std::int64_t order = 0;              ///< of an attempt

  Override whole() const { return by_hand.contains("") ? by_hand.at("") : Override{}; }
  bool is_missing() const { return files.empty() && dispute.empty(); }
};

/// A table with a heading: a column with an id is needed; name, submitted, aliases and what else names a student are
/// read. The gradebook of Canvas, the grading worksheet of Moodle and the roster of GitHub Classroom are such tables.
/// @param zone  of times that say none, as Moodle's: "Z", "+01:00". @throws GradingError
std::vector<Student> read_roster(const fs::path& file, const std::string& zone = "Z");

/// A name of somebody else's choice, in a sentence.
std::string in_quotes(const std::string& name);

/// Text in other letters than UTF-8 is taken for one in those that ICU calls so.
std::string in_utf8(const std::string& bytes, const char* letters);

/// The file in an export of Gradescope that says whose each folder is; a folder may be that of several students.
inline constexpr const char* gradescope_metadata = "submission_metadata.yml";
/// By folder. @throws GradingError
std::map<std::string, std::vector<Student>> read_gradescope(const std::string& text);

/// A grading worksheet of Moodle with marks, in parts of its maximum grade, and comments; nothing for other rosters.
std::optional<std::string> filled_worksheet(const fs::path& roster, const nlohmann::ordered_json& document);

/// By student and exercise; "": the whole. @throws GradingError
using Overrides = std::map<std::string, std::map<std::string, Override>>;
Overrides read_overrides(const fs::path& file, const Assignment& assignment);

struct Intake {
  std::vector<Student> students;
  std::vector<std::string> problems;  ///< what belongs to no student, and was not read
  std::vector<std::string> late;      ///< students whose files Canvas marks as late, and no table says when they came
};

/// Is the student of that id in one of several equal parts of the class, "2/8"? Any machine tells it by the id.
/// @throws GradingError where that is no part
bool is_in_part(const std::string& id, const std::string& part);

/// Takes in a folder per student, files called ID_EXERCISE.cpp, and zip files of both.
/// @param copies  DIR/SLUG/EXERCISE.cpp is written there, but nothing if the submissions cannot be read
/// @param by_attempts  in a student's folder, folders called as a time ("2027-03-01T12-00-00Z") or "attempt 2" hold an
///                     attempt each; in an export of Gradescope, so does every submission
/// @throws GradingError, std::runtime_error
Intake take_in(const fs::path& submissions, const Course& course, const std::vector<Student>& roster,
               const fs::path& copies, const std::string& part = "1/1", bool by_attempts = false);

/// Makes one attempt of a student the submission. @param why  "the last one"
void take_attempt(Student& student, std::size_t number, const std::string& why);

/// A file among the submissions, in a folder or in a zip file.
struct Found {
  std::string path;          ///< of a folder with "/" at its end
  std::string text = {};     ///< of one from a zip file
  std::string refusal = {};  ///< goes on after "it"; "": it can be read
  bool is_unread = false;    ///< the refusal speaks of more than a source file: a zip file in this one, or a student
  fs::path file = {};        ///< where it lies, if that is no zip file
};

/// Is the text of a file of that name read? Others may have to be named.
using NeedsText = std::function<bool(const std::string& name)>;
/// By the name, whatever the letters.
bool is_zip(const fs::path& file);
/// Is a file of that name read or, where it cannot be right, named?
bool is_handed_in(const std::string& name);

/// Reads, in a process of its own and in a sandbox, what is handed in; what is zipped once more as well.
/// @param is_class  the first part of a path is a student, and what is too much of one student costs no other
/// @throws RejectedFile
std::vector<Found> read_zip(const fs::path& file, bool is_class, const NeedsText& needs_text);

// --- what has been judged, in a file that only grows: a program that is killed loses nothing but what it was doing

class Journal {
 public:
  enum class Access { write, read };

  /// To write, opens the file for this program alone, and drops what was written by halves.
  /// @param forgotten  results with this verdict are left out
  /// @throws GradingError if another one grades there, std::runtime_error
  explicit Journal(fs::path file, Access access = Access::write, const std::string& forgotten = "");

  bool has(const std::string& key) const { return places_.contains(key); }

  /// The result under the key, if it was made from exactly this content.
  std::optional<CheckResult> find(const std::string& key, const std::string& content);

  /// Safe from the end of this program at once, and from that of the machine a second later or after sync(): waiting
  /// for the disk after each result would keep processors idle. @throws std::runtime_error
  void append(const std::string& key, const std::string& content, CheckResult checked);

  /// That of the cases of the last run; nothing if it is not known.
  std::optional<std::uint64_t> seed() const;
  /// @throws std::runtime_error
  void remember_seed(std::uint64_t seed);

  /// Copies the results that this journal lacks. @throws std::runtime_error
  void merge(const Journal& other);

  /// All is on disk when it returns. @throws std::runtime_error
  void sync();

  std::size_t damaged() const { return damaged_; }

 private:
  struct Place {
    std::int64_t offset = 0;
    std::size_t size = 0;
  };

  std::string line_at(const Place& place) const;
  void write(const std::string& key, const std::string& line);

  fs::path file_;
  Descriptor descriptor_;
  std::map<std::string, Place> places_;
  std::map<std::string, std::pair<std::string, CheckResult>> passed_;  ///< read once: many hand in the same
  std::int64_t end_ = 0;
  Clock::time_point synced_ = Clock::now();
  std::size_t damaged_ = 0;
};

// --- what came of a class: one document, from which every table and page is made

/// Right answers that have more in common than those of people who think alike: a reason to read both, and no proof.
class SimilarAnswers {
 public:
  /// What everybody has, and is nobody's: the stub, and code of the course.
  void take_off(const std::string& exercise, const std::string& text);
  /// @param place  of what was handed in: several students may have handed in one file together
  void add(const std::string& exercise, const std::string& student, const std::string& place, const std::string& text);
  /// The most similar first, each with the share of the shorter answer that both have, both students and both texts.
  nlohmann::ordered_json pairs() const;

 private:
  struct Answer {
    std::string text;
    std::vector<std::uint32_t> prints;                         ///< without those of the course
    std::map<std::string, std::vector<std::string>> students;  ///< by place
  };
  std::map<std::string, std::set<std::uint32_t>> of_course_;      ///< by exercise
  std::map<std::string, std::map<std::string, Answer>> answers_;  ///< by exercise and fingerprint of the text
};

/// Collects the results of one student after the other, and keeps of each only what the class is told.
class ClassResults {
 public:
  /// @param with_missing  tables have rows also of students of whom nothing was found, or not all was read
  ClassResults(const Assignment& assignment, std::uint64_t seed, const std::string& sandbox, const Intake& intake,
               bool with_missing);

  /// @param results  in the order of the assignment's exercises. @param made_from  fingerprints of what was judged
  /// @return the document about this student, who is not told the seed: other runs may take it again
  nlohmann::ordered_json add(const Student& student, const std::vector<CheckResult>& results,
                             const std::vector<std::string>& made_from);

  /// The document about the class: class.json. Nothing is added afterwards.
  nlohmann::ordered_json document();

  SimilarAnswers similar;

 private:
  nlohmann::ordered_json exercise_entry(std::size_t number) const;

  const Assignment& assignment_;
  const bool with_missing_;
  nlohmann::ordered_json document_;
  /// Students with the same misconception, or with the same wrong values for the same unknown reason, or with results
  /// learnt by heart: by the name of the list, the exercise and what they have in common.
  std::map<std::string, std::map<std::pair<std::string, std::string>, nlohmann::ordered_json>> groups_;
  std::array<int, 10> distribution_{};
};

/// Whose mark is another one than before, and why; the document notes these lines, or those of the last run with any.
std::vector<std::string> compare_with(const nlohmann::ordered_json& before, nlohmann::ordered_json& now);

/// What a learning system tells the student of one result: nothing of one that passed, but what was decided by hand.
std::string message_of(const nlohmann::ordered_json& mark);

// --- in the forms that other programs read
/// Texts by the names of their files.
std::map<std::string, std::string> class_exports(const nlohmann::ordered_json& document);
/// What systems with an autograder read of the student whom a document is about, by "gradescope/SLUG.json".
std::map<std::string, std::string> student_exports(const nlohmann::ordered_json& student);

// --- no student's code is run by an administrator

/// Who grades into a folder: this user; or where that is root the owner that the folder has from an earlier run, or
/// else an unused user id.
uid_t grading_user(const fs::path& folder);

/// Where this program runs as root: hands the folder over to the user who grades, and becomes that user for good.
/// @param needed  must be readable to everybody
/// @param starts_other_users  see become_user(); not needed where namespaces keep processes apart
/// @throws GradingError if that cannot be
void give_up_root(const fs::path& folder, const std::vector<fs::path>& needed, bool starts_other_users);

}  // namespace workbook
