#include "checker/grading/grading.hpp"

#include <unicode/normalizer2.h>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

namespace workbook {
namespace {

constexpr std::size_t most_notes = 20;
constexpr std::size_t most_entries = 20'000;  // looked at in one student's folder
constexpr int deepest = 16;
const fs::path progress_file = ".workbook/progress.json";
const std::vector<std::string> source_endings = {".cpp", ".cc", ".cxx", ".c", ".cpp.txt"};
const std::vector<std::string> archive_endings = {".tar", ".gz", ".tgz", ".xz", ".bz2", ".7z", ".rar"};
constexpr std::size_t nobody = SIZE_MAX;  // who is graded here, but perhaps in another shard

bool has_ending(const std::string& name, const std::vector<std::string>& endings) {
  return std::ranges::any_of(endings, [&](const auto& each) { return boost::iends_with(name, each); });
}

/// Canvas and Moodle write before the name of what was handed in whose it is, and numbers of their own.
Match by_system(const std::string& name) {
  return search(name,
                "^(?:LATE_)?(anon_[A-Za-z0-9]+|[^A-Z_ -]+(?:_LATE)?_\\d+|.+_\\d+(?=_assignsubmission_))"
                "_(?:\\d\\d+|assignsubmission_[a-z]+)(?:_(.*))?$");
}

/// A person's name as it is compared: in small letters, with accents in one form (a Mac writes them as signs of their
/// own), and without what learning systems leave out of the names of files.
std::string plain_person(const std::string& name) {
  UErrorCode problem = U_ZERO_ERROR;
  const icu::Normalizer2* const form = icu::Normalizer2::getNFKCCasefoldInstance(problem);
  const icu::UnicodeString read = icu::UnicodeString::fromUTF8(name);
  std::string plain;
  if (U_SUCCESS(problem)) form->normalize(read, problem).toUTF8String(plain);
  if (U_FAILURE(problem) || read.indexOf(char16_t{0xFFFD}) >= 0) return boost::to_lower_copy(name);  // no UTF-8
  for (const char* sign : {"&", "<", ">", "\"", "`", "|", "'", ":", "\\", "/", "\u2019"}) boost::erase_all(plain, sign);
  std::ranges::replace(plain, '_', ' ');
  return plain;
}

/// The folder into which Gradescope's export puts all students.
bool is_export(const std::string& name) { return name.starts_with("assignment_") && name.ends_with("_export"); }

std::string in_quotes(const std::string& name) { return fmt::format("'{}'", shortened(printable(name), 100)); }

fs::file_type type_of(const fs::path& file) {
  std::error_code ignored;
  return fs::symlink_status(file, ignored).type();
}

class Collector {
 public:
  Collector(const Course& course, const std::vector<RosterEntry>& roster, fs::path copies, const Shard& shard,
            bool by_attempts)
      : copies_(std::move(copies)),
        exercises_(course.exercises()),
        shard_(shard),
        has_roster_(!roster.empty()),
        by_attempts_(by_attempts) {
    for (const RosterEntry& entry : roster) {
      add(entry);
      for (const std::string& alias : entry.aliases) add_name(aliases_, alias, entry.id);
      add_name(aliases_, entry.id, entry.id);
      add_name(full_names_, entry.name, entry.id);
      if (const Match turned = search(entry.name, "^([^,]+), *([^,]+)$"))
        add_name(full_names_, turned[2] + " " + turned[1], entry.id);
    }
  }

  /// What GitHub Classroom puts before the logins: beginnings up to a "-" that most of the entries have.
  void learn_assignment(const std::set<std::string>& entries) {
    std::map<std::string, std::size_t> shares;
    std::size_t all = 0;
    assignments_.clear();
    has_groups_ = true;
    for (const std::string& name : entries) {
      if (const std::size_t moodle = name.find("_assignsubmission_"); moodle != std::string::npos)
        has_groups_ = has_groups_ && name.find('-') < moodle;
      all += name.find('-') != std::string::npos ? 1 : 0;
      for (std::size_t dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 1))
        ++shares[name.substr(0, dash + 1)];
    }
    for (const auto& [beginning, count] : shares)
      if (2 * count > all) assignments_.insert(beginning);
  }

  /// Is the only entry a folder in which a whole class lies? Where there is a roster, that is known.
  bool is_class(const std::string& entry, const std::set<std::string>& inside) {
    if (has_roster_ && !meant_by(entry).empty()) return false;
    if (inside.contains(gradescope_metadata) || !has_roster_) return inside.contains(gradescope_metadata);
    learn_assignment(inside);
    return std::ranges::any_of(inside, [&](const std::string& name) { return !meant_by(name).empty(); });
  }

  Intake intake;

  /// A class in a zip file. @throws GradingError
  std::vector<Found> zipped_class(const fs::path& submissions) const {
    try {
      return read_zip(submissions, true);
    } catch (const RejectedFile& reason) {
      throw GradingError(fmt::format("{} Nothing was graded.", reason.what()));
    }
  }

  /// A class in a folder. Of what students have handed in only the files that may be read, for it can be much.
  void list(const fs::path& folder, const std::string& above, std::vector<Found>& files, int depth = 0) {
    std::error_code problem;
    std::vector<fs::path> entries;
    for (fs::directory_iterator next(folder, problem), end; !problem && next != end; next.increment(problem))
      if (!next->path().filename().string().starts_with('.')) entries.push_back(next->path());
    std::ranges::sort(entries);  // every run sees the same
    if (depth == 0) is_alone_ = entries.size() == 1;
    const bool is_above_students = depth == 0 || (depth == 1 && (is_alone_ || is_export(folder.filename().string())));
    const auto refuse = [&](const std::string& path, const std::string& reason) {
      files.push_back({.path = path, .refusal = reason, .is_unread = true});
    };
    if (problem) refuse(above, fmt::format("is a folder that cannot be read ({})", problem.message()));
    if (depth > 0 && type_of(folder / progress_file.parent_path()) == fs::file_type::directory &&
        type_of(folder / progress_file) != fs::file_type::not_found)
      files.push_back({.path = above + progress_file.string(), .file = folder / progress_file});
    for (const fs::path& entry : entries) {
      const std::string name = entry.filename().string(), path = above + name;
      if (is_above_students) looked_at_ = 0;
      if (++looked_at_ > most_entries) return refuse(path, "comes after too many other files");
      if (type_of(entry) == fs::file_type::directory && !is_exercise(entry)) {
        if (name == "__MACOSX") continue;
        if (depth == deepest) {
          refuse(path, "is a folder in too many others");
          continue;
        }
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

  /// All that a class has handed in.
  void take_class(std::vector<Found> files) {
    std::set<std::string> top;
    while (true) {
      std::set<std::string> below;
      top.clear();
      for (const Found& each : files) {
        const std::size_t slash = std::min(each.path.find('/'), each.path.size());
        top.insert(each.path.substr(0, slash));
        if (slash + 1 < each.path.size())
          below.insert(each.path.substr(slash + 1, each.path.find('/', slash + 1) - slash - 1));
      }
      // Is the only entry a folder in which a whole class lies?
      if (top.size() != 1 || !is_class(*top.begin(), below)) break;
      for (Found& each : files) each.path.erase(0, each.path.find('/') + 1);
      std::erase_if(files, [](const Found& each) { return each.path.empty(); });  // the folder itself
    }
    learn_assignment(top);
    const auto metadata = std::ranges::find_if(files, [](const Found& each) {
      const fs::path path = each.path;
      return path.filename() == gradescope_metadata && (path.parent_path().empty() || is_export(path.parent_path()));
    });
    std::string above;
    if (metadata != files.end()) {
      above = metadata->path.substr(0, metadata->path.size() - std::string_view(gradescope_metadata).size());
      if (!metadata->refusal.empty())
        throw GradingError(fmt::format("{} {}. Nothing was graded.", gradescope_metadata, metadata->refusal));
      take_metadata(metadata->file.empty() ? metadata->text
                                           : read_file(metadata->file, std::size_t{64} << 20).value_or(""));
    }
    for (Found& each : files) {
      if (!each.path.starts_with(above) || each.path == above + gradescope_metadata) continue;
      each.path.erase(0, above.size());
      take(each);
    }
  }

  /// The one folder of a class in which all lie looks like that of one student who has handed in everything twice.
  void doubt_single_student() {
    if (has_roster_ || intake.students.size() != 1 || !has_second_) return;
    Student& only = intake.students.front();
    unread(only,
           fmt::format("'{}' holds several files for one exercise; if it is no student but a class, unpack it and "
                       "name it as SUBMISSIONS.",
                       only.id));
  }

 private:
  /// An export of Gradescope: whose its folders are.
  void take_metadata(const std::string& text) {
    has_metadata_ = true;
    for (const auto& [folder, people] : read_gradescope(text)) {
      std::vector<std::size_t>& owners = owners_[folder];
      for (const RosterEntry& person : people) {
        std::optional<std::size_t> meant = has_roster_ ? known(person.id) : std::nullopt;
        if (!has_roster_) {
          if (!students_.contains(person.id)) add(person);
          meant = students_.at(person.id);
        }
        for (const std::string& alias : person.aliases)
          if (!meant) meant = known(alias);
        if (!meant) meant = found_in(full_names_, person.name);
        if (!meant)
          problem(fmt::format("{} was not read for {}: the roster has no {}, and not just one of that name.",
                              in_quotes(folder), shortened(printable(person.name), 100), in_quotes(person.id)));
        if (!meant || *meant == nobody) continue;
        owners.push_back(*meant);
        Student& student = intake.students[*meant];
        if (by_attempts_) {
          attempt(student, folder, person.submitted, person.submitted.value_or(0));
          continue;
        }
        if (!student.submitted) student.submitted = person.submitted;
        if (!student.entry.empty() && student.entry != folder) dispute(student, student.entry, folder);
        student.entry = folder;
      }
    }
  }

  void add(const RosterEntry& entry) {
    if (!shard_.has(entry.id)) {
      students_.emplace(entry.id, nobody);
      return;
    }
    Student& student = add_student(entry.id);
    student.name = printable(entry.name);
    student.submitted = entry.submitted;
  }

  /// Names of several students name nobody.
  void add_name(std::map<std::string, std::string>& names, const std::string& name, const std::string& id) {
    if (name.empty()) return;
    const auto [known, is_new] = names.emplace(plain_person(name), id);
    if (!is_new && known->second != id) known->second.clear();
  }

  std::optional<std::size_t> found_in(const std::map<std::string, std::string>& names, const std::string& name) const {
    const auto found = names.find(plain_person(name));
    if (found == names.end() || found->second.empty()) return std::nullopt;
    return students_.at(found->second);
  }

  /// By id or alias.
  std::optional<std::size_t> known(const std::string& name) const {
    if (const auto student = students_.find(name); student != students_.end()) return student->second;
    return found_in(aliases_, name);
  }

  Student& add_student(const std::string& raw) {
    // Names of files that differ in case only are one file on some systems.
    std::string slug = replaced(cut(raw, 60), "[^A-Za-z0-9_.]", "-");
    slug.erase(0, slug.find_first_not_of(".-"));
    if (slug.empty()) slug = "student";
    std::string unique = slug;
    for (int number = 2; !slugs_.insert(boost::to_lower_copy(unique)).second; ++number)
      unique = fmt::format("{}-{}", slug, number);
    students_.emplace(raw, intake.students.size());
    Student student;
    student.id = shortened(replaced(printable(raw), "[\n\t]", "?"), 200);
    student.slug = unique;
    intake.students.push_back(std::move(student));
    return intake.students.back();
  }

  void problem(const std::string& sentence) {
    if (std::ranges::count(intake.problems, sentence) == 0 && intake.problems.size() < 1000)
      intake.problems.push_back(sentence);
  }

  static void note(Student& student, const std::string& sentence) {
    if (student.notes.size() < most_notes) student.notes.push_back(sentence);
  }

  static void unread(Student& student, const std::string& sentence) {
    note(student, sentence);
    if (student.unread.size() < most_notes) student.unread.push_back(sentence);
  }

  static bool is_number(const std::string& field) {
    return !field.empty() && field.find_first_not_of("0123456789") == std::string::npos;
  }

  /// Names of Moodle and Canvas hold the id between others, separated by "_", before what the student has named: up to
  /// the first number, or else at the beginning.
  static std::vector<std::string> leading_fields(const std::string& name) {
    std::vector<std::string> fields;
    boost::split(fields, name, [](char letter) { return letter == '_'; });
    if (const auto number = std::ranges::find_if(fields, is_number); number != fields.end())
      fields.erase(number + 1, fields.end());
    return fields;
  }

  /// The students of the roster whose ids stand among the fields; an id may itself hold "_".
  std::set<std::size_t> named_by(const std::vector<std::string>& fields) const {
    std::set<std::size_t> meant;
    const std::size_t ends = is_number(fields.back()) ? fields.size() : 1;
    for (std::size_t begin = 0, next = 1; begin < ends; begin = next, ++next) {
      std::optional<std::size_t> longest;
      std::string id;
      for (std::size_t last = begin; last < fields.size(); ++last) {
        id += (last == begin ? "" : "_") + fields[last];
        if (const auto student = known(id)) longest = student, next = last + 1;
      }
      if (longest) meant.insert(*longest);
    }
    return meant;
  }

  /// GitHub Classroom: "ASSIGNMENT-LOGIN", and both may hold "-"; in a zip file of GitHub also "ASSIGNMENT-LOGIN-main".
  std::optional<std::size_t> by_login(const std::string& name) const {
    for (const std::string& beginning : assignments_) {
      if (!name.starts_with(beginning)) continue;
      const std::string login = name.substr(beginning.size());
      if (const auto student = known(login)) return student;
      if (const Match branch = search(login, "^(.*)-(main|master)$"))
        if (const auto student = known(branch[1])) return student;
    }
    return std::nullopt;
  }

  /// Whom of the roster the name of an entry means.
  std::set<std::size_t> meant_by(const std::string& name) const {
    if (const auto whole = known(name)) return {*whole};
    const std::vector<std::string> fields = leading_fields(name);
    std::set<std::size_t> meant = named_by(fields);
    if (meant.empty() && fields.size() == 1)
      if (const auto student = by_login(name)) meant.insert(*student);
    // "Ada Byron_900001_assignsubmission_file_" of Moodle, whose number is of this assignment only; where groups hand
    // in for their members "Group-Ada Byron_900001_...".
    if (meant.empty() && fields.size() == 2 && is_number(fields.back())) {
      std::string person = fields.front();
      std::optional<std::size_t> student = found_in(full_names_, person);
      for (std::size_t dash = 0; has_groups_ && !student && (dash = person.find('-')) != std::string::npos;) {
        person.erase(0, dash + 1);
        student = found_in(full_names_, person);
      }
      if (student) meant.insert(*student);
    }
    return meant;
  }

  /// Whom a top-level entry of that name belongs to and who is graded here.
  std::vector<Student*> students_of(const std::string& name) {
    std::vector<Student*> students;
    if (!owners_.contains(name)) owners_[name] = owners_of(name);
    for (const std::size_t owner : owners_[name]) students.push_back(&intake.students[owner]);
    return students;
  }

  std::vector<std::size_t> owners_of(const std::string& name) {
    if (has_metadata_) {
      problem(fmt::format("{} was not read: {} does not name it.", in_quotes(name), gradescope_metadata));
      return {};
    }
    const Match own = by_system(name);
    std::set<std::size_t> meant = meant_by(name);
    const std::string entry = own           ? boost::erase_last_copy(own[1], "_LATE")
                              : has_roster_ ? fmt::format("{}", fmt::join(leading_fields(name), "_"))
                                            : name;
    if (!has_roster_) {  // Canvas numbers the files of a student, who may be a group or have no name
      if (!shard_.has(entry)) return {};
      if (!students_.contains(entry)) add_student(entry);
      meant = {students_.at(entry)};
    }
    if (meant.size() != 1) {
      problem(fmt::format("{} was not read: {} of the roster.", in_quotes(name),
                          meant.empty() ? "it names no id, and no name of just one student," : "it names several ids"));
      return {};
    }
    if (*meant.begin() == nobody) return {};
    Student& student = intake.students[*meant.begin()];
    if (student.entry.empty()) student.entry = entry;
    if (student.entry != entry) dispute(student, student.entry, entry);
    return {*meant.begin()};
  }

  /// That of the name; a new one takes its place in their order.
  Student& attempt(Student& student, const std::string& name, const std::optional<std::int64_t>& submitted,
                   std::int64_t order) {
    if (const auto known = std::ranges::find(student.attempts, name, &Student::entry); known != student.attempts.end())
      return *known;
    Student made;
    made.id = student.id;
    made.slug = fmt::format("{}/attempts/{}", student.slug, student.attempts.size() + 1);
    made.submitted = submitted;
    made.entry = name;
    std::vector<std::int64_t>& orders = orders_[student.id];
    const auto at = std::ranges::upper_bound(orders, order) - orders.begin();
    orders.insert(orders.begin() + at, order);
    return *student.attempts.insert(student.attempts.begin() + at, std::move(made));
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

  static void dispute(Student& student, const std::string& one, const std::string& other) {
    if (student.dispute.empty())
      student.dispute =
          fmt::format("{} and {} both name this student; leave only what is theirs.", in_quotes(one), in_quotes(other));
  }

  void take(Found& found) {
    const std::string shown = shortened(printable(found.path), 200);
    std::string first = found.path.substr(0, found.path.find('/'));
    std::string trouble = found.is_unread ? fmt::format("'{}' was not read: it {}.", shown, found.refusal) : "";
    if (first == found.path && is_zip(first)) first.resize(first.size() - 4);
    if (is_zip(found.file)) {
      try {
        for (Found& each : read_zip(found.file, false)) {
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
      if (!trouble.empty()) unread(*student, trouble);
  }

  /// Whose it is, for what, and what is in it.
  void take_file(const Found& found, const std::string& shown) {
    std::vector<std::string> parts;
    for (const fs::path& part : fs::path(found.path))
      if (!part.empty() && part != "." && part != "/") parts.push_back(part.string());
    const bool is_progress = parts.size() > 2 && fs::path(parts[parts.size() - 2]) / parts.back() == progress_file;
    if (is_progress) parts.resize(parts.size() - 2);
    if (parts.empty() || std::ranges::any_of(parts, [](const auto& part) { return part.starts_with('.'); })) {
      if (std::ranges::count(parts, "..") > 0) problem(fmt::format("'{}' was not read: its path leads away.", shown));
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

  /// The exercise that somebody meant who called a file "Spring Energy-2 (1).cpp"; or none.
  const Exercise* meant_exercise(const std::string& name) const {
    const std::string plain = boost::to_lower_copy(replaced(name, "[- ]", "_"));
    const Exercise* meant = nullptr;
    for (const Exercise& exercise : exercises_)
      if (search(plain, "^" + exercise.name() + "([^a-z]|$)"))
        if (meant == nullptr || exercise.name().size() > meant->name().size()) meant = &exercise;
    return meant;
  }

  void take_of(Student& student, const std::string& name, const Found& found, const std::string& shown) {
    if (is_exercise(name)) {
      const std::string exercise = fs::path(name).stem().string();
      const std::string lecture = std::ranges::find(exercises_, exercise, &Exercise::name)->lecture();
      const bool is_in_place = found.path.ends_with(fmt::format("/lectures/{}/exercises/{}", lecture, name));
      hand_in(student, exercise, {is_in_place ? HandedIn::in_place : HandedIn::anywhere, found.path}, found);
    } else if (has_ending(name, archive_endings)) {
      if (std::ranges::count(found.path, '/') < 2)
        unread(student, fmt::format("'{}' was not read: it is no zip file.", shown));
    } else if (const Exercise* meant = meant_exercise(name); meant != nullptr && has_ending(name, source_endings)) {
      hand_in(student, meant->name(),
              {HandedIn::under_another_name, found.path,
               fmt::format("'{}' was not read: the file should be called {}.cpp.", shown, meant->name())},
              found);
    }
  }

  /// Of several the one counts, for each exercise, that tells of more hints.
  void take_progress(Student& student, const Found& found, const std::string& shown) {
    const fs::path copy = copies_ / student.slug / "progress.json";
    try {
      write_or_throw(copy, text_of(found, shown));
      const Progress progress(copy);
      if (progress.warning().empty() && !student.hints) student.hints.emplace();
      for (const Exercise& exercise : exercises_)
        if (const std::size_t hints = progress.of(exercise.name()).hints_shown; hints > 0)
          (*student.hints)[exercise.name()] = std::max((*student.hints)[exercise.name()], hints);
      if (!progress.warning().empty()) note(student, shown + " is damaged, so it was not used.");
    } catch (const RejectedFile& reason) {
      note(student, reason.what());
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
    const Exercise* meant = nullptr;
    for (const Exercise& exercise : exercises_)
      if (stem.size() > exercise.name().size() + 1 && stem.ends_with("_" + exercise.name()) &&
          (meant == nullptr || exercise.name().size() > meant->name().size()))
        meant = &exercise;
    if (meant == nullptr)
      return problem(fmt::format("{} was not read: it should be a student's folder, a zip file or ID_EXERCISE.cpp.",
                                 in_quotes(name)));
    for (Student* student : students_of(stem.substr(0, stem.size() - meant->name().size() - 1)))
      hand_in(*student, meant->name(), {HandedIn::anywhere, name}, found);
  }

  void hand_in(Student& student, const std::string& exercise, HandedIn in, const Found& found) {
    const fs::path copy = copies_ / student.slug / (exercise + ".cpp");
    in.entry = in.where.substr(0, in.where.find('/'));
    in.where = shortened(printable(in.where), 200);
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
      if (known->second.entry != in.entry) dispute(student, known->second.entry, in.entry);
      has_second_ = has_second_ || in.place != HandedIn::under_another_name;
      in.refusal =
          fmt::format("{}.cpp is there twice: '{}' and '{}'; hand in one.", exercise, known->second.where, in.where);
    }
    std::error_code ignored;
    fs::remove(copy, ignored);
    if (in.refusal.empty()) write_or_throw(copy, text);
    student.files[exercise] = std::move(in);
  }

  /// @throws RejectedFile
  std::string text_of(const Found& found, const std::string& shown) const {
    if (!found.refusal.empty()) throw RejectedFile(fmt::format("{} {}.", shown, found.refusal));
    struct stat status {};
    if (::lstat(found.file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink > 1)
      throw RejectedFile(shown + " is a hard link, so it may be somebody else's; hand in a file of its own.");
    const fs::path unpacked = copies_ / ".unpacked";  // what was in a zip file is judged like all others
    if (found.file.empty()) write_or_throw(unpacked, found.text);
    return read_submission(found.file.empty() ? unpacked : found.file, shown).text;
  }

  const fs::path copies_;
  const std::vector<Exercise> exercises_;
  const Shard shard_;
  const bool has_roster_, by_attempts_;
  bool has_metadata_ = false;  ///< an export of Gradescope says whose each entry is
  bool has_groups_ = false;    ///< each of Moodle's entries may begin with the name of a group
  std::map<std::string, std::vector<std::int64_t>> orders_;  ///< of the attempts, by student
  std::set<std::string> assignments_;                        ///< what GitHub Classroom may put before logins
  std::map<std::string, std::size_t> students_;              ///< by id
  std::map<std::string, std::string> aliases_, full_names_;  ///< ids by plain_person(); "": of several students
  std::map<std::string, std::vector<std::size_t>> owners_;   ///< by top-level entries; of a group several
  std::set<std::string> slugs_;
  std::size_t looked_at_ = 0;
  bool is_alone_ = false;    ///< the folder of the class holds one entry
  bool has_second_ = false;  ///< somebody has handed in different files for one exercise
};

}  // namespace

bool is_zip(const fs::path& file) { return boost::iequals(file.extension().string(), ".zip"); }

bool is_handed_in(const std::string& name) {
  return has_ending(name, source_endings) || has_ending(name, archive_endings) || name == gradescope_metadata ||
         name == progress_file.filename();
}

bool Shard::has(const std::string& id) const {
  // The low bits of the fingerprint tell parities of the letters only: the digits of ids are often so chosen.
  std::uint64_t hash = std::stoull(fingerprint(id), nullptr, 16);
  hash = (hash ^ (hash >> 33)) * 0xff51afd7ed558ccdULL;
  return (hash >> 32) % count == number - 1;
}

Shard read_shard(const std::string& text) {
  Shard shard;
  char slash = 0;
  std::istringstream words(text);
  words >> shard.number >> slash >> shard.count;
  if (!words || slash != '/' || !words.eof() || shard.number < 1 || shard.number > shard.count)
    throw GradingError("--shard should say which part of how many, for example 2/8.");
  return shard;
}

Intake take_in(const fs::path& submissions, const Course& course, const std::vector<RosterEntry>& roster,
               const fs::path& copies, const Shard& shard, bool by_attempts) {
  std::error_code problem;
  const fs::file_type type = fs::status(submissions, problem).type();
  if (type != fs::file_type::directory && !(type == fs::file_type::regular && submissions.extension() == ".zip"))
    throw GradingError(fmt::format("{} is neither a folder nor a zip file.", shown_path(submissions)));
  Collector collector(course, roster, copies, shard, by_attempts);
  std::vector<Found> files;
  if (type == fs::file_type::directory) fs::directory_iterator(submissions, problem);
  if (problem) throw GradingError(fmt::format("{} cannot be read ({}).", shown_path(submissions), problem.message()));
  if (type == fs::file_type::regular)
    files = collector.zipped_class(submissions);
  else
    collector.list(submissions, "", files);
  fs::remove_all(copies, problem);
  collector.take_class(std::move(files));
  collector.doubt_single_student();
  fs::remove(copies / ".unpacked", problem);
  for (Student& student : collector.intake.students)
    if (!student.attempts.empty() && !student.files.empty())
      student.unread.push_back(student.notes.emplace_back("Files beside the folders of the attempts were not read."));
  return std::move(collector.intake);
}

void take_attempt(Student& student, std::size_t number, const std::string& why, const fs::path& copies) {
  Student& taken = student.attempts[number];
  std::error_code ignored;
  for (const auto& file : fs::directory_iterator(copies / student.slug, ignored))
    if (file.is_regular_file()) fs::remove(file, ignored);
  for (const auto& file : fs::directory_iterator(copies / taken.slug, ignored))
    fs::rename(file, copies / student.slug / file.path().filename());
  fs::remove_all(copies / student.slug / "attempts", ignored);
  student.files = std::move(taken.files);
  student.hints = std::move(taken.hints);
  student.submitted = taken.submitted;
  student.attempt = taken.entry;
  std::ranges::copy(taken.notes, std::back_inserter(student.notes));
  std::ranges::copy(taken.unread, std::back_inserter(student.unread));
  student.notes.push_back(
      fmt::format("Of {} {} counts, {}.", plural(student.attempts.size(), "attempt"), in_quotes(taken.entry), why));
  student.attempts.clear();
}

}  // namespace workbook
