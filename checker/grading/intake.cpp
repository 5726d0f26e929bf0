#include "checker/grading/grading.hpp"

#include <unicode/normalizer2.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <set>

namespace workbook {
namespace {

constexpr std::size_t most_sentences = 1000;
constexpr std::size_t most_entries = 20'000;  // looked at in one student's folder
constexpr int deepest = 16;
const fs::path progress_file = ".workbook/progress.json";
constexpr const char* source_file = "(?i)\\.(cpp|cc|cxx|c|cpp\\.txt)$";
constexpr const char* archive_file = "(?i)\\.(tar|gz|tgz|xz|bz2|7z|rar)$";

/// Canvas and Moodle write before the name of what was handed in whose it is, and numbers of their own.
Match by_system(const std::string& name) {
  return search(name,
                "^(?:LATE_)?(anon_[A-Za-z0-9]+|[^A-Z_ -]+(?:_LATE)?_\\d+|.+(?=_assignsubmission_))"
                "_(?:\\d\\d+|assignsubmission_[a-z]+)(?:_(.*))?$");
}

/// The words of a person's name as they are compared: in small letters, with accents in one form (a Mac writes them as
/// signs of their own), and without what learning systems leave out of the names of files.
std::vector<std::string> words_of(const std::string& name) {
  UErrorCode problem = U_ZERO_ERROR;
  const icu::Normalizer2* const form = icu::Normalizer2::getNFKCCasefoldInstance(problem);
  if (U_FAILURE(problem)) throw std::runtime_error(fmt::format("ICU cannot compare names ({}).", u_errorName(problem)));
  std::string plain;
  form->normalize(icu::UnicodeString::fromUTF8(name), problem).toUTF8String(plain);
  std::vector<std::string> words;
  for (const Match& word : search_all(replaced(plain, "[&<>\"`|':\\\\/]|\u2019", ""), "[^ _,]+"))
    words.push_back(word[0]);
  return words;
}

std::string plain_name(const std::string& name) { return fmt::format("{}", fmt::join(words_of(name), " ")); }

/// A name in one word, as Canvas writes it.
std::string one_word(const std::string& name) {
  return replaced(fmt::format("{}", fmt::join(words_of(name), "")), "-", "");
}

/// The folder into which Gradescope's export puts all students.
bool is_export(const std::string& folder) { return folder.starts_with("assignment_") && folder.ends_with("_export"); }

std::string top_entry(const std::string& path) { return path.substr(0, path.find('/')); }

std::string unread(const std::string& shown, const std::string& reason) {
  return fmt::format("{} was not read: {}.", in_quotes(shown), reason);
}

class Collector {
 public:
  Collector(const Course& course, const std::vector<Student>& roster, fs::path copies, std::string part,
            bool by_attempts)
      : copies_(std::move(copies)),
        before_(copies_.string() + ".before"),
        exercises_(course.exercises()),
        part_(std::move(part)),
        has_roster_(!roster.empty()),
        by_attempts_(by_attempts) {
    for (const Student& listed : roster) {
      const std::size_t student = add(listed);
      names_[{Kind::id, plain_name(listed.id)}].insert(student);
      for (const std::string& alias : listed.aliases) names_[{Kind::alias, plain_name(alias)}].insert(student);
      if (!listed.group.empty()) names_[{Kind::group, one_word(listed.group)}].insert(student);
      if (!listed.entry.empty()) owners_[listed.entry].push_back(student);
      std::vector<std::string> words = words_of(listed.name);  // with the family's name first or last
      for (std::size_t k = 0; k < words.size(); ++k) {
        std::ranges::rotate(words, words.begin() + 1);
        const std::string name = fmt::format("{}", fmt::join(words, " "));
        names_[{Kind::full_name, name}].insert(student);
        names_[{Kind::in_one_word, one_word(name)}].insert(student);
      }
    }
  }

  /// What GitHub Classroom puts before the logins: beginnings up to a "-" that most of the entries have.
  void learn_assignment(const std::set<std::string>& entries) {
    std::map<std::string, std::size_t> shares;
    for (const std::string& name : entries)
      for (std::size_t dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 1))
        ++shares[name.substr(0, dash + 1)];
    assignments_.clear();
    for (const auto& [beginning, count] : shares)
      if (2 * count > entries.size()) assignments_.insert(beginning);
    has_groups_ = std::ranges::none_of(entries, [](auto& name) { return !!search(name, "^[^-]*_assignsubmission_"); });
  }

  Intake intake;

  /// A class in a folder. Of what students have handed in only the files that may be read, for it can be much.
  void list(const fs::path& folder, const std::string& above, std::vector<Found>& files, int depth = 0) {
    std::error_code problem;
    std::vector<fs::path> entries;
    for (fs::directory_iterator next(folder, problem), end; !problem && next != end; next.increment(problem))
      if (const fs::path name = next->path().filename();
          name == progress_file.parent_path() || (!name.string().starts_with('.') && name != "__MACOSX"))
        entries.push_back(next->path());
    std::ranges::sort(entries);                                  // every run sees the same
    if (depth == wrappers_ && entries.size() == 1) ++wrappers_;  // perhaps the class lies in that folder
    const bool is_above_students = depth <= wrappers_ || (depth == 1 && is_export(folder.filename().string()));
    const auto refuse = [&](const std::string& path, const std::string& reason) {
      files.push_back({.path = path, .refusal = reason, .is_unread = true});
    };
    if (problem) refuse(above, fmt::format("is a folder that cannot be read ({})", problem.message()));
    for (const fs::path& entry : entries) {
      const std::string name = entry.filename().string(), path = above + name;
      if (is_above_students) looked_at_ = 0;
      if (++looked_at_ > most_entries) return refuse(path, "comes after too many other files");
      const bool is_folder =
          fs::symlink_status(entry, problem).type() == fs::file_type::directory && !is_exercise(entry);
      if (is_folder && depth == deepest) {
        refuse(path, "is a folder in too many others");
      } else if (is_folder) {
        if (is_above_students) files.push_back({.path = path + "/"});  // also whose folder is empty is of the class
        list(entry, path + "/", files, depth + 1);
      } else if (is_zip(entry)) {
        looked_at_ += most_entries / 20;
        files.push_back({.path = path.substr(0, path.size() - 4), .file = entry});
      } else if (depth == 0 || is_handed_in(name)) {
        files.push_back({.path = path, .file = entry});
      }
    }
  }

  /// Where all lies in one folder, or in one that is alone in it: the one in which students are told apart, if any is.
  /// Beside the folder of an export of Gradescope other things may lie.
  std::string folder_of_class(const std::vector<Found>& files) {
    const auto entries_in = [&](const std::string& folder) {
      std::set<std::string> entries;
      for (const Found& each : files)
        if (each.path.size() > folder.size())
          entries.insert(each.path.substr(folder.size(), each.path.find('/', folder.size()) - folder.size()));
      learn_assignment(entries);
      return entries;
    };
    std::string folder;
    for (std::set<std::string> entries = entries_in("");; entries = entries_in(folder += *entries.begin() + "/")) {
      for (const std::string& name : entries)
        if (is_export(name) && std::ranges::count(files, folder + name + "/" + gradescope_metadata, &Found::path) > 0)
          return folder + name + "/";
      if (entries.contains(gradescope_metadata) ||
          (has_roster_ && std::ranges::any_of(entries, [&](auto& name) { return !meant_by(name).empty(); })))
        return folder;
      if (entries.size() != 1) break;
    }
    entries_in("");
    return "";
  }

  /// Tells files whose text is read by their names; all others may only have to be named.
  bool needs_text(const std::string& name) const {
    return (search(name, source_file) && similar(name) != nullptr) || name == gradescope_metadata ||
           name == progress_file.filename();
  }

  /// All that a class has handed in.
  void take_class(std::vector<Found> files) {
    std::error_code ignored;
    fs::remove_all(before_, ignored);
    fs::rename(copies_, before_, ignored);
    const std::string above = folder_of_class(files);
    std::erase_if(files, [&](const Found& each) { return !each.path.starts_with(above) || each.path == above; });
    for (Found& each : files) each.path.erase(0, above.size());
    const auto metadata = std::ranges::find(files, gradescope_metadata, &Found::path);
    if (metadata != files.end()) {
      take_metadata(*metadata);
      files.erase(metadata);
    }
    for (Found& each : files) take(each);
    fs::remove_all(before_, ignored);
    if (!has_roster_ && intake.students.size() == 1 && has_second_)  // or the one folder in which a class lies
      say(intake.students.front().unread, in_quotes(intake.students.front().id) +
                                              " holds several files for one exercise; if it is no student but a "
                                              "class, unpack it and name it as SUBMISSIONS.");
  }

 private:
  enum class Kind { exact, id, alias, full_name, in_one_word, group };  ///< of a name; exact: an id, letter by letter

  /// An export of Gradescope: whose its folders are.
  void take_metadata(const Found& file) {
    if (!file.refusal.empty())
      throw GradingError(fmt::format("{} {}. Nothing was graded.", gradescope_metadata, file.refusal));
    has_metadata_ = true;
    const std::string text = file.file.empty() ? file.text : read_file(file.file).value_or("");
    for (const auto& [folder, people] : read_gradescope(text)) {
      std::vector<std::size_t>& owners = owners_[folder];
      for (const Student& person : people) {
        if (!has_roster_ && !the_one(Kind::exact, person.id)) add(person);
        std::optional<std::size_t> meant = known(person.id);
        if (!meant) meant = known(person.aliases.front());
        if (!meant) meant = the_one(Kind::full_name, person.name);
        if (!meant) {
          say(intake.problems,
              fmt::format("{} was not read for {}: the roster has no {}, and not just one of that name.",
                          in_quotes(folder), shortened(printable(person.name), 100), in_quotes(person.id)));
          continue;
        }
        owners.push_back(*meant);
        Student& student = intake.students[*meant];
        if (by_attempts_) {
          attempt(student, folder, person.submitted, person.submitted.value_or(0));
          continue;
        }
        if (!student.submitted) student.submitted = person.submitted;
        claim(student, folder);
      }
    }
  }

  std::size_t add(Student student) {
    // Names of files that differ in case only are one file on some systems.
    student.slug = replaced(cut(student.id, 60), "[^A-Za-z0-9_.]", "-");
    student.slug.erase(0, student.slug.find_first_not_of(".-"));
    if (student.slug.empty()) student.slug = "student";
    const std::string first = student.slug;
    for (int number = 2; !slugs_.insert(boost::to_lower_copy(student.slug)).second; ++number)
      student.slug = fmt::format("{}-{}", first, number);
    names_[{Kind::exact, student.id}].insert(intake.students.size());
    student.id = shortened(replaced(printable(student.id), "[\n\t]", "?"), 200);
    student.name = printable(student.name);
    student.copies = copies_ / student.slug;
    intake.students.push_back(std::move(student));
    return intake.students.size() - 1;
  }

  /// A name of several students names nobody.
  std::optional<std::size_t> the_one(Kind kind, const std::string& name) const {
    const auto found = names_.find({kind, kind == Kind::exact ? name : plain_name(name)});
    return found == names_.end() || found->second.size() > 1 ? std::nullopt : std::optional(*found->second.begin());
  }

  std::optional<std::size_t> known(const std::string& name) const {
    for (const Kind kind : {Kind::exact, Kind::id, Kind::alias})
      if (const auto student = the_one(kind, name)) return student;
    return std::nullopt;
  }

  static void say(std::vector<std::string>& to, const std::string& sentence) {
    if (to.size() < most_sentences && std::ranges::count(to, sentence) == 0) to.push_back(sentence);
  }

  /// In names of Moodle and Canvas the id stands between others, separated by "_", before what the student has named:
  /// up to the first number.
  static Match numbered(const std::string& name) { return search(name, "^(?:.*?_)??\\d+(?=_|$)"); }

  /// The students of the roster whose ids stand there, or else at the beginning; an id may itself hold "_".
  std::set<std::size_t> named_by(const std::string& name) const {
    const Match number = numbered(name);
    const std::string leading = number ? number[0] : name;
    std::set<std::size_t> meant;
    for (std::size_t begin = 0, end = 0; begin < leading.size(); begin = end + 1) {
      for (end = leading.size(); end > begin && end != std::string::npos; end = leading.rfind('_', end - 1))
        if (const auto student = known(leading.substr(begin, end - begin))) {
          meant.insert(*student);
          break;
        }
      if (!number) break;
      if (end <= begin || end == std::string::npos) end = std::min(leading.find('_', begin), leading.size());
    }
    return meant;
  }

  /// GitHub Classroom: "ASSIGNMENT-LOGIN", and both may hold "-"; in a zip file of GitHub also "ASSIGNMENT-LOGIN-main".
  std::optional<std::size_t> by_login(const std::string& name) const {
    for (const std::string& beginning : assignments_) {
      if (!name.starts_with(beginning)) continue;
      const std::string login = name.substr(beginning.size());
      for (const std::string& each : {login, replaced(login, "-(main|master)$", "")})
        if (const auto student = known(each)) return student;
    }
    return std::nullopt;
  }

  /// By the whole name; before it may stand that of a group.
  std::optional<std::size_t> by_full_name(std::string person) const {
    for (std::size_t dash = 0;; person.erase(0, dash + 1))
      if (const auto student = the_one(Kind::full_name, person);
          student || !has_groups_ || (dash = person.find('-')) == std::string::npos)
        return student;
  }

  /// Who hands in together, as Moodle and Canvas name a group: "Group 1_17", "group1_34"; or nobody.
  std::set<std::size_t> group_of(const std::string& name) const {
    const Match own = by_system(name);
    const auto group = names_.find({Kind::group, one_word(replaced(own[1], "(_LATE)?_\\d+$", ""))});
    return own && group != names_.end() ? group->second : std::set<std::size_t>();
  }

  /// Whom of the roster the name of an entry means.
  std::set<std::size_t> meant_by(const std::string& name) const {
    if (const auto owners = owners_.find(name); owners != owners_.end())
      return {owners->second.begin(), owners->second.end()};
    if (const auto whole = known(name)) return {*whole};
    if (const auto group = group_of(name); !group.empty()) return group;
    std::set<std::size_t> meant;
    const auto add = [&](const std::optional<std::size_t>& student) {
      if (student) meant.insert(*student);
    };
    // "Ada Byron_900001_assignsubmission_file_" of Moodle: its number is of this assignment only, and no id.
    const Match moodle = search(name, "^(.+)_(\\d+)(_assignsubmission_.*)?$");
    const bool is_of_moodle = !moodle[3].empty();
    if (is_of_moodle) add(the_one(Kind::alias, moodle[2]));
    if (moodle) add(by_full_name(moodle[1]));
    if (meant.empty() || !is_of_moodle)
      for (const std::size_t each : named_by(name))
        if (!is_of_moodle || intake.students[each].name.empty()) meant.insert(each);
    if (numbered(name)) add(the_one(Kind::in_one_word, name.substr(0, name.find('_'))));
    if (meant.empty()) add(by_login(name));
    if (meant.empty()) add(by_full_name(name));
    return meant;
  }

  /// Whom a top-level entry of that name belongs to and who is graded here.
  std::vector<Student*> students_of(const std::string& name) {
    std::vector<Student*> students;
    if (!owners_.contains(name)) owners_[name] = owners_of(name);
    for (const std::size_t owner : owners_[name])
      if (is_in_part(intake.students[owner].id, part_)) students.push_back(&intake.students[owner]);
    return students;
  }

  std::vector<std::size_t> owners_of(const std::string& name) {
    if (has_metadata_) {
      say(intake.problems, unread(name, fmt::format("{} names no student for it", gradescope_metadata)));
      return {};
    }
    const Match own = by_system(name);
    const std::string entry = own                             ? boost::erase_last_copy(own[1], "_LATE")
                              : has_roster_ && numbered(name) ? numbered(name)[0]
                                                              : name;
    // Canvas numbers the files of a student, who may be a group or have no name.
    if (!has_roster_ && !the_one(Kind::exact, entry)) add({.id = entry});
    const std::set<std::size_t> meant = has_roster_ ? meant_by(name) : std::set{*the_one(Kind::exact, entry)};
    if (meant.empty() || (meant.size() > 1 && meant != group_of(name))) {
      const char* whom = meant.empty() ? "no id, and no name of just one student," : "several students";
      say(intake.problems, unread(name, fmt::format("it names {} of the roster", whom)));
      return {};
    }
    for (const std::size_t each : meant) {
      Student& student = intake.students[each];
      if (own && !student.submitted && search(name, "(^|_)LATE_")) say(intake.late, student.id);
      claim(student, entry);
    }
    return {meant.begin(), meant.end()};
  }

  Student& attempt(Student& student, const std::string& name, const std::optional<std::int64_t>& submitted,
                   std::int64_t order) {
    if (const auto known = std::ranges::find(student.attempts, name, &Student::entry); known != student.attempts.end())
      return *known;
    student.attempts.push_back({.id = student.id,
                                .copies = student.copies / "attempts" / std::to_string(student.attempts.size() + 1),
                                .submitted = submitted,
                                .entry = name,
                                .order = order});
    return student.attempts.back();
  }

  Student& attempt_of(Student& student, const std::vector<std::string>& parts) {
    if (has_metadata_ && !student.attempts.empty()) return attempt(student, parts.front(), {}, 0);
    if (!by_attempts_ || parts.size() < 2) return student;
    std::string name = parts[1];
    if (name.size() > 16 && name[13] == '-' && name[16] == '-') name[13] = name[16] = ':';  // which Windows has not
    if (const auto time = read_time(name)) return attempt(student, parts[1], time, *time);
    const Match numbered = search(boost::to_lower_copy(name), "^attempt[ _-]*([0-9]{1,9})$");
    return numbered ? attempt(student, parts[1], student.submitted, std::stoi(numbered[1])) : student;
  }

  static void claim(Student& student, const std::string& entry) {
    if (student.entry.empty()) student.entry = entry;
    if (student.entry != entry && student.dispute.empty())
      student.dispute = fmt::format("{} and {} both name this student; leave only what is theirs.",
                                    in_quotes(student.entry), in_quotes(entry));
  }

  void take(Found& found) {
    const std::string shown = shortened(printable(found.path), 200);
    std::string first = top_entry(found.path);
    std::string trouble = found.is_unread ? unread(shown, "it " + found.refusal) : "";
    if (first == found.path && is_zip(first)) first.resize(first.size() - 4);
    if (is_zip(found.file)) {
      try {
        for (Found& each : read_zip(found.file, false, [&](auto& name) { return needs_text(name); })) {
          each.path = found.path + "/" + each.path;
          take(each);
        }
        return;
      } catch (const RejectedFile& reason) {
        trouble = reason.what();
      }
    }
    if (trouble.empty() && !found.path.ends_with('/')) return take_file(found, shown);
    for (Student* student : students_of(first))
      if (!trouble.empty()) say(student->unread, trouble);
  }

  /// Whose it is, for what, and what is in it.
  void take_file(const Found& found, const std::string& shown) {
    std::vector<std::string> parts;
    for (const fs::path& part : fs::path(found.path))
      if (!part.empty() && part != "." && part != "/") parts.push_back(part.string());
    const bool is_progress = parts.size() > 2 && fs::path(parts[parts.size() - 2]) / parts.back() == progress_file;
    if (is_progress) parts.resize(parts.size() - 2);
    if (parts.empty() || std::ranges::any_of(parts, [](const auto& part) { return part.starts_with('.'); })) {
      if (std::ranges::count(parts, "..") > 0) say(intake.problems, unread(shown, "its path leads away"));
    } else if (parts.size() == 1 && !is_progress) {
      take_flat(parts.front(), found, shown);
    } else {
      for (Student* owner : students_of(parts.front())) {
        Student& student = attempt_of(*owner, parts);
        if (is_progress)
          take_progress(student, found, shown);
        else
          take_of(student, parts.back(), found, shown);
      }
    }
  }

  bool is_exercise(const fs::path& file) const {
    return file.extension() == ".cpp" && std::ranges::count(exercises_, file.stem().string(), &Exercise::name) > 0;
  }

  /// Of the exercises with such names the one with the longest; or none.
  const Exercise* longest(const std::function<bool(const std::string& name)>& is_such) const {
    const Exercise* found = nullptr;
    for (const Exercise& each : exercises_)
      if (is_such(each.name()) && (found == nullptr || each.name().size() > found->name().size())) found = &each;
    return found;
  }

  const Exercise* similar(const std::string& name) const {
    const auto letters = [](std::string text) {
      std::erase_if(text, [](unsigned char letter) { return std::isalnum(letter) == 0; });
      return boost::to_lower_copy(text);
    };
    return longest([&, plain = letters(name)](auto& exercise) { return boost::contains(plain, letters(exercise)); });
  }

  void take_of(Student& student, const std::string& name, const Found& found, const std::string& shown) {
    if (is_exercise(name)) {
      const std::string exercise = fs::path(name).stem().string();
      const std::string lecture = std::ranges::find(exercises_, exercise, &Exercise::name)->lecture();
      const bool is_in_place = found.path.ends_with(fmt::format("/lectures/{}/exercises/{}", lecture, name));
      hand_in(student, exercise, {is_in_place ? HandedIn::in_place : HandedIn::anywhere, shown}, found);
    } else if (search(name, archive_file)) {
      if (std::ranges::count(found.path, '/') < 2) say(student.unread, unread(shown, "it is no zip file"));
    } else if (search(name, source_file)) {  // somebody may call it "3 - SpringEnergy (1).cpp"
      if (const Exercise* meant = similar(name))
        hand_in(student, meant->name(),
                {HandedIn::under_another_name, shown,
                 unread(shown, fmt::format("the file should be called {}.cpp", meant->name()))},
                found);
      else if (std::ranges::count(found.path, '/') < 2)
        say(student.notes, unread(shown, "no exercise is called so"));
    }
  }

  /// Of several the one counts, for each exercise, that tells of more hints.
  void take_progress(Student& student, const Found& found, const std::string& shown) {
    const fs::path copy = student.copies / "progress.json";
    try {
      write_or_throw(copy, text_of(found, shown));
      const Progress progress(copy);
      if (!progress.warning().empty()) throw RejectedFile(shown + " is damaged, so it was not used.");
      if (!student.hints) student.hints.emplace();
      for (const Exercise& exercise : exercises_)
        if (const std::size_t hints = progress.of(exercise.name()).hints_shown; hints > 0)
          (*student.hints)[exercise.name()] = std::max((*student.hints)[exercise.name()], hints);
    } catch (const RejectedFile& reason) {
      say(student.notes, reason.what());
    }
  }

  /// Of Canvas or Moodle, or else "ID_EXERCISE.cpp".
  void take_flat(const std::string& name, const Found& found, const std::string& shown) {
    // Canvas puts "-1" after the name of what was handed in once more.
    const std::string last = replaced(name, "-\\d+(\\.\\w+)$", "$1");
    if (const Match own = by_system(last)) {
      for (Student* student : students_of(name)) take_of(*student, own[2], found, shown);
      return;
    }
    const std::string stem = last.ends_with(".cpp") ? last.substr(0, last.size() - 4) : "";
    const Exercise* meant =
        longest([&](auto& exercise) { return stem.size() > exercise.size() + 1 && stem.ends_with("_" + exercise); });
    if (meant == nullptr)
      return say(intake.problems, unread(name, "it should be a student's folder, a zip file or ID_EXERCISE.cpp"));
    for (Student* student : students_of(stem.substr(0, stem.size() - meant->name().size() - 1)))
      hand_in(*student, meant->name(), {HandedIn::anywhere, shown}, found);
  }

  void hand_in(Student& student, const std::string& exercise, HandedIn in, const Found& found) {
    const fs::path copy = student.copies / (exercise + ".cpp");
    const auto known = student.files.find(exercise);
    const bool is_second = known != student.files.end();
    if (is_second && known->second.place > in.place) return;
    std::string text;
    try {
      if (in.refusal.empty()) text = text_of(found, in.where);
    } catch (const RejectedFile& reason) {
      in.refusal = reason.what();
    }
    if (is_second && known->second.place == in.place) {
      if (known->second.refusal.empty() && in.refusal.empty() && read_file(copy) == text) return;
      if (top_entry(known->second.where) != top_entry(in.where)) claim(student, top_entry(in.where));
      has_second_ |= in.place != HandedIn::under_another_name;
      in.refusal =
          fmt::format("{}.cpp is there twice: '{}' and '{}'; hand in one.", exercise, known->second.where, in.where);
    }
    const fs::path before = before_ / copy.lexically_relative(copies_);
    if (!in.refusal.empty()) {
      fs::remove(copy);
    } else if (read_file(before) == text) {  // which takes far less time than a new file
      fs::create_directories(copy.parent_path());
      fs::rename(before, copy);
    } else {
      write_or_throw(copy, text);
    }
    student.files[exercise] = std::move(in);
  }

  /// @throws RejectedFile
  std::string text_of(const Found& found, const std::string& shown) const {
    if (!found.refusal.empty()) throw RejectedFile(fmt::format("{} {}.", shown, found.refusal));
    std::error_code ignored;
    if (fs::is_regular_file(fs::symlink_status(found.file, ignored)) && fs::hard_link_count(found.file, ignored) > 1)
      throw RejectedFile(shown + " is a hard link, so it may be somebody else's; hand in a file of its own.");
    const fs::path unpacked = before_ / ".unpacked";  // what was in a zip file is judged like all others
    if (found.file.empty()) write_or_throw(unpacked, found.text);
    return read_submission(found.file.empty() ? unpacked : found.file, shown).text;
  }

  const fs::path copies_, before_;  ///< copies of this and of the last run
  const std::vector<Exercise> exercises_;
  const std::string part_;
  const bool has_roster_, by_attempts_;
  bool has_metadata_ = false;          ///< an export of Gradescope says whose each entry is
  bool has_groups_ = false;            ///< each of Moodle's entries may begin with the name of a group
  std::set<std::string> assignments_;  ///< what GitHub Classroom may put before logins
  std::map<std::pair<Kind, std::string>, std::set<std::size_t>> names_;  ///< of students, as plain_name() has them
  std::map<std::string, std::vector<std::size_t>> owners_;               ///< by top-level entries; of a group several
  std::set<std::string> slugs_;
  std::size_t looked_at_ = 0;
  int wrappers_ = 0;         ///< folders, one in the other, with one entry each
  bool has_second_ = false;  ///< somebody has handed in different files for one exercise
};

}  // namespace

bool is_zip(const fs::path& file) { return boost::iequals(file.extension().string(), ".zip"); }

bool is_handed_in(const std::string& name) {
  return search(name, source_file) || search(name, archive_file) || name == gradescope_metadata ||
         name == progress_file.filename();
}

bool is_in_part(const std::string& id, const std::string& part) {
  const Match parts = search(part, "^([1-9]\\d{0,8})/([1-9]\\d{0,8})$");
  if (!parts || std::stoull(parts[1]) > std::stoull(parts[2]))
    throw GradingError("--shard should say which part of how many, for example 2/8.");
  // Twice, for the low bits of the fingerprint tell parities of the letters only: digits of ids are often so chosen.
  return std::stoull(fingerprint(fingerprint(id)), nullptr, 16) % std::stoull(parts[2]) == std::stoull(parts[1]) - 1;
}

Intake take_in(const fs::path& submissions, const Course& course, const std::vector<Student>& roster,
               const fs::path& copies, const std::string& part, bool by_attempts) {
  std::error_code problem;
  Collector collector(course, roster, copies, part, by_attempts);
  std::vector<Found> files;
  if (is_zip(submissions) && fs::is_regular_file(submissions, problem)) {
    files.push_back({.path = "", .file = submissions});
  } else {
    fs::directory_iterator(submissions, problem);
    if (problem)
      throw GradingError(fmt::format("{} is no zip file, and no folder that can be read ({}).", shown_path(submissions),
                                     problem.message()));
    collector.list(submissions, "", files);
  }
  if (files.size() == 1 && is_zip(files.front().file)) try {  // that of the class, or where it is in a folder perhaps
      const Found zip = files.front();
      files = read_zip(zip.file, true, [&](auto& name) { return collector.needs_text(name); });
      for (Found& each : files) each.path = zip.path + (zip.path.empty() ? "" : "/") + each.path;
    } catch (const RejectedFile& reason) {
      throw GradingError(fmt::format("{} Nothing was graded.", reason.what()));
    }
  collector.take_class(std::move(files));
  std::erase_if(collector.intake.students, [&](const Student& each) { return !is_in_part(each.id, part); });
  for (Student& student : collector.intake.students) {
    std::ranges::stable_sort(student.attempts, {}, &Student::order);
    if (!student.attempts.empty() && !student.files.empty())
      student.unread.push_back("Files beside the folders of the attempts were not read.");
  }
  return std::move(collector.intake);
}

void take_attempt(Student& student, std::size_t number, const std::string& why) {
  Student taken = std::move(student.attempts[number]);
  student.files = std::move(taken.files);
  student.hints = std::move(taken.hints);
  student.copies = taken.copies;
  student.submitted = taken.submitted;
  student.attempt = taken.entry;
  std::ranges::copy(taken.notes, std::back_inserter(student.notes));
  std::ranges::copy(taken.unread, std::back_inserter(student.unread));
  student.notes.push_back(
      fmt::format("Of {} {} counts, {}.", plural(student.attempts.size(), "attempt"), in_quotes(taken.entry), why));
  student.attempts.clear();
}

}  // namespace workbook
