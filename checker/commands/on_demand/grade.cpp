// A class graded: take in → judge what was not judged yet → write results. Whatever happens, what is judged is kept.
#include "checker/commands/on_demand/options.hpp"
#include "checker/compile/compile.hpp"
#include "checker/explain/diagnostic_run.hpp"
#include "checker/grading/grading.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <sys/stat.h>

#include <algorithm>
#include <random>
#include <set>

namespace workbook {
namespace {

using nlohmann::ordered_json;

constexpr const char* journal_name = "journal.jsonl";

void write_or_fail(const fs::path& file, const std::string& text) {
  if (const std::string trouble = write_file(file, text); !trouble.empty())
    throw std::runtime_error(
        fmt::format("{} cannot be written ({}); what is judged is kept, so start again.", shown_path(file), trouble));
}

SandboxStrength strong_sandbox(bool allow_reduced, const fs::path& out) {
  SandboxStrength sandbox = probe_sandbox(grading_user(out));
  if (sandbox.tier() < SandboxTier::reduced)
    throw GradingError("Strangers' code is not graded on this machine: its sandbox is " + sandbox.sentence() + ".");
  if (sandbox.tier() < SandboxTier::full && !allow_reduced)
    throw GradingError("The sandbox is " + sandbox.sentence() +
                       ". File names and processes of this machine are not hidden in it. If that will do, say "
                       "--allow-reduced; for strangers, better on a machine that holds nothing else.");
  return sandbox;
}

/// An empty folder, or that of an earlier run: files in it are deleted.
void prepare_folder(const fs::path& out, const fs::path& submissions) {
  std::error_code problem;
  const auto is_below = [&](const fs::path& file, const fs::path& folder) {
    const fs::path way = fs::proximate(file, folder, problem);
    return !way.empty() && *way.begin() != "..";
  };
  if (is_below(out, submissions) || is_below(submissions, out))
    throw GradingError("The submissions and --out must not lie in each other.");
  remove_unfinished(out);
  if (fs::exists(out, problem) && !(fs::is_directory(out, problem) &&
                                    (fs::is_empty(out, problem) || fs::is_regular_file(out / journal_name, problem))))
    throw GradingError(
        fmt::format("{} is neither empty nor the folder of an earlier `grade`; give another one.", shown_path(out)));
  const std::string trouble = fs::exists(out / journal_name) ? "" : write_file(out / journal_name, "");
  if (!trouble.empty()) throw GradingError(fmt::format("{} cannot be written ({}).", shown_path(out), trouble));
  fs::create_directories(out / "work", problem);
  fs::permissions(out, fs::perms::owner_all, problem);  // that of an earlier run as well
  if (problem)
    throw GradingError(fmt::format("{} cannot be kept from other users ({}).", shown_path(out), problem.message()));
}

/// The journals of other runs, for as long as nobody writes into them.
std::vector<Journal> journals_in(const std::vector<fs::path>& folders, const fs::path& out) {
  std::vector<Journal> journals;
  std::error_code ignored;
  for (const fs::path& folder : folders) {
    if (fs::equivalent(folder, out, ignored)) continue;
    if (!fs::is_directory(folder)) throw GradingError(fmt::format("There is no folder {}.", shown_path(folder)));
    if (fs::exists(folder / journal_name))
      journals.emplace_back(folder / journal_name, Journal::Access::read);
    else
      fmt::print("{} holds no results; what is missing is judged now.\n", shown_path(folder));
  }
  return journals;
}

/// What judges, apart from the cases: a change of it makes another result possible.
std::string tools_fingerprint(const Course& course, const Toolchain& toolchain) {
  std::string text = file_fingerprint("/proc/self/exe") + file_fingerprint(course.toolchain_file());
  std::vector<fs::path> files = toolchain.support;
  files.insert(files.end(), {toolchain.compiler, toolchain.precompiled()});
  std::error_code ignored;
  for (const fs::path& file : files)
    text += fmt::format("|{} {} {}", file.string(), fs::file_size(file, ignored),
                        fs::last_write_time(file, ignored).time_since_epoch().count());
  return fingerprint(text);
}

std::string indented(const ordered_json& document) {
  return document.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// What of one student is judged for one exercise.
struct Content {
  std::vector<std::pair<std::string, std::string>> files;  ///< name and text: the exercise's, then those it may call
  std::string bytes;                                       ///< all of them
  std::string key;
};

class Grader {
 public:
  /// @param known_seed  that of the cases whose results students have, if it is another one
  /// @param explain_minutes  for the reasons of all failures of one student, so that nobody can keep the others waiting
  Grader(const Course& course, const Assignment& assignment, std::uint64_t seed,
         std::optional<std::uint64_t> known_seed, double explain_minutes, fs::path out, Journal& journal)
      : context_(course),
        assignment_(assignment),
        seed_(seed),
        known_seed_(known_seed),
        explain_minutes_(explain_minutes),
        out_(std::move(out)),
        journal_(journal),
        all_(course.exercises()) {
    if (program_on_path("gnuplot").empty())
      fmt::print("Pages get no plots: {} `--only wrong_value` draws them later.\n", gnuplot_is_missing);
    else
      draw_ = [this](CheckResult& checked) { add_picture(checked, out_ / "work"); };
  }

  /// Builds now what is else built at its first need: who gives up root can write into no build afterwards.
  void build_all(SandboxTier tier) {
    std::vector<Toolchain> toolchains = {context_.toolchain()};
    if (missing_for_diagnostic_runs(toolchains.front()).empty())
      toolchains.push_back(read_toolchain(toolchains.front().diagnostic));
    const auto last = std::ranges::find(all_, assignment_.exercises().back().name(), &Exercise::name);
    const std::vector<Exercise> needed(all_.begin(), last + 1);  // it may call all those before it
    fmt::print("Cases are drawn, and what is missing is built: the first time this takes minutes.\n");
    std::fflush(stdout);
    ProgressBar bar;
    for (std::size_t i = 0; i < needed.size(); ++i) {
      bar.show(i, needed.size(), "prepared");
      for (const Toolchain& toolchain : toolchains)
        if (i == 0 || ::geteuid() == 0) require_complete(toolchain, needed[i].name());
      if (i > 0 && needed[i].card == needed[i - 1].card) continue;
      for (const std::uint64_t seed : std::set{seed_, known_seed_.value_or(seed_)})
        context_.course().reference(needed[i].lecture(), seed, needed[i].name());
    }
    tools_ = tools_fingerprint(context_.course(), context_.toolchain()) + to_string(tier);
  }

  /// @throws GradingError where the assignment names a misconception that no exercise has
  void require_misconceptions() {
    std::set<std::string> known;
    for (const Exercise& exercise : assignment_.exercises())
      for (const Misconception& each : context_.reference({exercise, {}, seed_}).misconceptions)
        known.insert({each.name, exercise.name() + "/" + each.name});
    for (const auto& [name, unused] : assignment_.misconceptions())
      if (!known.contains(name))
        throw GradingError(
            fmt::format("'misconceptions' of the assignment names '{}', which no exercise that is graded "
                        "has. Nothing was graded.",
                        shortened(printable(name), 100)));
  }

  void begin(const Intake& intake) {
    for (const Exercise& exercise : all_) {
      write_or_fail(stub(exercise), stub_text(exercise, declared_signature(context_.course(), exercise)));
    }
    for (const Student& student : intake.students) {
      plan(student);
      for (const Student& attempt : student.attempts) plan(attempt);
    }
  }

  std::size_t left_to_judge() const { return waiting_.size(); }
  std::size_t failed() const { return failures_.size(); }

  void judge_all() {
    std::map<std::size_t, Content> contents;
    ProgressBar bar;
    const Clock::time_point begun = Clock::now();
    std::size_t done = 0;
    bar.show(done, waiting_.size(), "");
    std::map<const Student*, Clock::duration> explaining;
    const auto begin = [&](std::size_t k) {
      const auto& [student, exercise] = waiting_[k];
      return begin_job(contents[k] = content_of(*student, exercise), exercise, k,
                       explaining[student] < explain_minutes_ || !assignment_.misconceptions().empty());
    };
    run_jobs(waiting_.size(), begin, [&](std::size_t k, CheckJob& job) {
      explaining[waiting_[k].first] += job.explaining();
      keep(contents.at(k), finish_job(job, k));
      contents.erase(k);
      ++done;
      const auto left = (Clock::now() - begun) * (waiting_.size() - done) / done;
      bar.show(done, waiting_.size(),
               fmt::format("about {} s left", std::chrono::ceil<std::chrono::seconds>(left).count()));
    });
    journal_.sync();
  }

  /// Of each student's attempts the one with the most points counts, of equal ones the last.
  void take_best_attempts(Intake& intake) {
    for (Student& student : intake.students) {
      std::pair<double, std::size_t> best;
      for (std::size_t k = 0; k < student.attempts.size(); ++k) {
        const Student& attempt = student.attempts[k];
        double points = 0;
        std::string unused;
        for (const Exercise& exercise : assignment_.exercises()) points += result(attempt, exercise, unused).score();
        points *= assignment_.late_factor(assignment_.days_late(attempt.submitted, student.whole().due));
        best = std::max(best, {points, k});
      }
      if (!student.attempts.empty()) take_attempt(student, best.second, "the best one");
    }
  }

  /// Files for every student; and what came of the class.
  ordered_json write_results(const Intake& intake, const std::string& sandbox, bool with_missing) {
    ReportedCourse page;
    page.date = current_day();
    for (const Card& card : context_.course().cards())
      page.headings.merge(read_headings(context_.course().notes_file(card)));
    ClassResults results(assignment_, seed_, sandbox, intake, with_missing);
    for (const Exercise& exercise : assignment_.exercises()) {
      results.similar.take_off(exercise.name(), read_file(stub(exercise)).value_or(""));
      results.similar.take_off(exercise.name(), read_file(context_.course().solution_file(exercise)).value_or(""));
      for (const char* file : {"notes.md", "worked_examples.cpp", "figures.cpp"})
        results.similar.take_off(exercise.name(),
                                 read_file(context_.course().lectures() / exercise.lecture() / file).value_or(""));
    }
    std::error_code ignored;
    for (const char* folder : {"students", "gradescope", "autolab", "github_classroom", "classroom50", "prairielearn"})
      fs::remove_all(out_ / folder, ignored);
    for (Student student : intake.students) {
      std::ranges::copy(student.unread, std::back_inserter(student.notes));
      std::ranges::copy(assignment_.rules(student.hints.has_value()), std::back_inserter(student.notes));
      std::vector<CheckResult> checked;
      std::vector<std::string> made_from(assignment_.exercises().size());
      for (std::size_t i = 0; i < made_from.size(); ++i)
        checked.push_back(decided(student, assignment_.exercises()[i], made_from[i]));
      const ordered_json document = results.add(student, checked, made_from);
      const fs::path file = out_ / "students" / student.slug;
      write_or_fail(file.string() + ".json", indented(document));
      for (const auto& [name, text] : student_exports(document)) write_or_fail(out_ / name, text);
      page.student = student.name.empty() ? student.id : student.name;
      page.notes = student.notes;
      page.notes.insert(page.notes.begin(), "Sandbox: " + sandbox + ".");
      page.counted.reset();
      if (const Override whole = student.whole(); !whole.sentence.empty()) {
        page.counted = document.at("student").at("score");
        page.notes.push_back("By hand: " + whole.sentence);
      }
      if (const int days = document.at("student").at("days_late"); days > 0) {
        page.counted = document.at("student").at("score");
        page.notes.push_back(fmt::format("Handed in {} late: {:g} % of the points count.",
                                         plural(static_cast<std::size_t>(days), "day"),
                                         100 * document.at("student").at("late_factor").get<double>()));
      }
      page.exercises.clear();
      for (CheckResult& each : checked) page.exercises.push_back({std::move(each)});
      write_or_fail(file.string() + ".html", report_page(page));
    }
    return results.document();
  }

 private:
  void plan(const Student& student) {
    for (const Exercise& exercise : assignment_.exercises()) {
      if (!student.dispute.empty() || is_refused(student, exercise)) continue;
      const std::string key = content_of(student, exercise).key;
      if (!journal_.has(key) && keys_.insert(key).second) waiting_.push_back({&student, exercise});
    }
  }

  /// @param made_from  gets the fingerprint of what the result was made from
  CheckResult result(const Student& student, const Exercise& exercise, std::string& made_from) {
    const CheckTask task{exercise, copy(student, exercise), seed_, true, false};
    if (!student.dispute.empty()) return failed_check(task, student.dispute);
    const ExerciseReference& reference = context_.reference(task);
    if (is_refused(student, exercise)) {
      const std::string& sentence = student.files.at(exercise.name()).refusal;
      made_from = fingerprint(sentence);
      return rejected_check(task, reference, sentence);
    }
    const Content content = content_of(student, exercise);
    made_from = fingerprint(content.bytes);
    std::optional<CheckResult> checked = journal_.find(content.key, content.bytes);
    if (const auto failed = failures_.find(content.key); !checked && failed != failures_.end())
      return failed_check(task, failed->second);
    if (!checked) {  // its key is that of something else, or its entry is damaged
      checked = finish_job(*begin_job(content, exercise, waiting_.size()), waiting_.size());
      keep(content, *checked);
    }
    checked->task = task;
    checked->reference = &reference;
    std::vector<std::string> misconceptions;
    for (const Reason& reason : checked->reasons)
      if (reason.kind == ReasonKind::misconception) misconceptions.push_back(reason.name);
    checked->share = assignment_.share(checked->judgement, reference, misconceptions, hints_of(student, exercise));
    return *checked;
  }

  CheckResult decided(const Student& student, const Exercise& exercise, std::string& made_from) {
    CheckResult checked = result(student, exercise, made_from);
    checked.is_excused = student.whole().is_excused;
    if (const auto by_hand = student.by_hand.find(exercise.name()); by_hand != student.by_hand.end()) {
      checked.by_hand = by_hand->second.sentence;
      checked.points_by_hand = by_hand->second.points;
      checked.is_excused |= by_hand->second.is_excused;
    }
    return checked;
  }

  static fs::path copy(const Student& student, const Exercise& exercise) {
    return student.copies / (exercise.name() + ".cpp");
  }
  fs::path stub(const Exercise& exercise) const { return out_ / "work" / "stubs" / (exercise.name() + ".cpp"); }
  fs::path folder(std::size_t number) const { return out_ / "work" / "judging" / std::to_string(number); }

  static std::size_t hints_of(const Student& student, const Exercise& exercise) {
    return student.hints && student.hints->contains(exercise.name()) ? student.hints->at(exercise.name()) : 0;
  }

  static bool is_refused(const Student& student, const Exercise& exercise) {
    const auto file = student.files.find(exercise.name());
    return file != student.files.end() && !file->second.refusal.empty();
  }

  /// What was not handed in, or was refused, is as it was in the beginning.
  fs::path file_of(const Student& student, const Exercise& exercise) const {
    const bool is_there = student.files.contains(exercise.name()) && !is_refused(student, exercise);
    return is_there ? copy(student, exercise) : stub(exercise);
  }

  Content content_of(const Student& student, const Exercise& exercise) {
    Content content;
    const std::string text = read_submission(file_of(student, exercise)).text;
    content.files.emplace_back(exercise.name(), text);
    for (const Submission& own : own_functions(text, context_.course().exercises_before(exercise),
                                               [&](auto& each) { return file_of(student, each); }))
      content.files.emplace_back(own.path.stem().string(), own.text);
    // Where reasons earn points, a result whose reasons were left out will not do.
    std::string judged_by = tools_ + (assignment_.misconceptions().empty() ? "" : "explained");
    for (const auto& [name, file] : content.files) {
      content.bytes.append(name).append(1, '\0').append(file).append(1, '\0');
      judged_by += reference_fingerprint(name);
    }
    content.key = fingerprint(fmt::format("{} {} {} {}", judged_by, seed_, known_seed_.value_or(seed_), content.bytes));
    return content;
  }

  const std::string& reference_fingerprint(const std::string& name) {
    std::string& known = reference_fingerprints_[name];
    if (known.empty()) {
      const Exercise exercise = context_.course().find_exercise(name);
      const ExerciseReference& reference = context_.reference({exercise, {}, seed_});
      const fs::path file = out_ / "work" / "reference_of_one.json";
      write_reference_results({seed_, exercise.lecture(), {reference}}, file);
      known = file_fingerprint(file);
    }
    return known;
  }

  /// In a folder that says nothing of whose files these are, for others may have handed in the same.
  std::unique_ptr<CheckJob> begin_job(const Content& content, const Exercise& exercise, std::size_t number,
                                      bool is_explained = true) {
    for (const auto& [name, text] : content.files) write_or_fail(folder(number) / (name + ".cpp"), text);
    fs::current_path(folder(number));  // messages name files as seen from there
    auto job =
        std::make_unique<CheckJob>(context_, CheckTask{exercise, folder(number) / (exercise.name() + ".cpp"), seed_,
                                                       true, false, known_seed_, is_explained, false, draw_});
    leave_folder();
    return job;
  }

  CheckResult finish_job(CheckJob& job, std::size_t number) {
    CheckResult checked = job.result();
    for (const auto& entry : fs::directory_iterator(folder(number)))
      boost::replace_all(checked.judgement.next_step, " --file " + shell_quoted(entry.path().string()), "");
    std::error_code ignored;
    fs::remove_all(folder(number), ignored);
    checked.observation.compile_seconds = checked.observation.run_seconds = 0;  // the same for the same files
    checked.observation.sweep.clear();                                          // it is drawn
    // Nothing reads the values where no case failed; without them a later run reads the journal in half the time.
    if (checked.judgement.failing.empty() && printed(checked.observation).empty()) checked.observation.replies.clear();
    return checked;
  }

  void leave_folder() const {
    std::error_code ignored;  // without root it may be closed
    fs::current_path(origin_, ignored);
    if (ignored) fs::current_path("/");
  }

  /// Our own failure is nobody's result: the next run tries again.
  void keep(const Content& content, const CheckResult& checked) {
    if (checked.is_judged())
      journal_.append(content.key, content.bytes, checked);
    else
      failures_.emplace(content.key, checked.judgement.message);
  }

  CheckContext context_;
  const Assignment& assignment_;
  const std::uint64_t seed_;
  const std::optional<std::uint64_t> known_seed_;
  const std::chrono::duration<double, std::ratio<60>> explain_minutes_;
  const fs::path out_;
  Journal& journal_;
  const fs::path origin_ = fs::current_path();
  const std::vector<Exercise> all_;
  /// Once and on all processors, so that a run without anything new draws nothing.
  std::function<void(CheckResult&)> draw_;
  std::string tools_;
  std::set<std::string> keys_;
  std::vector<std::pair<const Student*, Exercise>> waiting_;
  std::map<std::string, std::string> failures_;
  std::map<std::string, std::string> reference_fingerprints_;
};

/// The verdict of that name. @throws GradingError
std::string known_verdict(const std::string& name) {
  std::string known = to_string(nlohmann::json(name).get<Verdict>());
  if (known != name || name == to_string(Verdict::checker_error))
    throw GradingError(fmt::format("No result has the verdict '{}'; one is wrong_value.", printable(name)));
  return known;
}

/// Makes the course take these reference results, if any are given. Returns their seed.
std::optional<std::uint64_t> use_references(Course& course, const std::vector<fs::path>& files) {
  std::optional<std::uint64_t> seed;
  for (const fs::path& file : files) {
    const std::uint64_t given = course.use_reference(file);
    if (seed.value_or(given) != given)
      throw GradingError(fmt::format("{} was made with seed {}, another one with {}; give such of one seed.",
                                     shown_path(file), given, *seed));
    seed = given;
  }
  return seed;
}

/// That of the runs before, here or in the folders that are joined; else one that nobody knows.
std::uint64_t own_seed(const Course& course, const GradeOptions& options, const Journal& journal,
                       const std::vector<Journal>& merged) {
  std::set<std::uint64_t> known;
  for (const Journal& each : merged)
    if (const auto seed = each.seed()) known.insert(*seed);
  if (const auto seed = journal.seed()) known.insert(*seed);
  if (known.size() > 1)
    throw GradingError(
        fmt::format("What is to be joined was judged with the seeds {}; say with --seed which one counts.",
                    fmt::join(known, ", ")));
  if (!known.empty()) return *known.begin();
  if (!options.shard.empty())
    throw GradingError(
        "All parts of a class need the same cases: give each of them the same --seed, any number that "
        "students do not know.");
  try {  // the journal may be damaged
    if (const auto before = read_file(*options.out / "class.json")) return ordered_json::parse(*before).at("seed");
  } catch (const nlohmann::json::exception&) {
  }
  if (!course.has_solutions()) return course.seed();
  std::random_device random;
  return (std::uint64_t{random()} << 20) ^ random();
}

/// @param students  all of the class. @throws GradingError if an override is of somebody else
void require_known(const Overrides& overrides, const auto& students) {
  for (const auto& one : overrides)
    if (std::ranges::none_of(students, [&](const auto& each) { return each.id == one.first; }))
      throw GradingError(
          fmt::format("The overrides are of '{}', and no student of the class has that id. Nothing was graded.",
                      shortened(printable(one.first), 100)));
}

/// Says how many have handed in, and what was not read. Returns whether that is all.
/// @param remark  goes on after how many
bool print_intake(const Intake& intake, const std::vector<std::string>& problems,
                  const std::vector<std::string>& missing, const GradeOptions& options, const std::string& remark) {
  fmt::print("{} of {}{} handed in{}.\n", intake.students.size() - missing.size(),
             plural(intake.students.size(), "student"), options.roster ? " of the roster" : "", remark);
  for (const std::string& sentence : problems) fmt::print("  {}\n", sentence);
  if (!missing.empty())
    fmt::print("  Nothing was found of {}.\n", shortened(fmt::format("{}", fmt::join(missing, ", ")), 1000));
  if (!intake.late.empty())
    fmt::print("Canvas marks files as late of {}; with their times in a column 'submitted' of the roster it counts.\n",
               shortened(fmt::format("{}", fmt::join(intake.late, ", ")), 1000));
  return problems.empty() && missing.empty() && !intake.students.empty();
}

void compare_with_last_run(const fs::path& class_file, ordered_json& document) {
  const auto before = read_file(class_file);
  if (!before) return;
  try {
    const std::vector<std::string> changes = compare_with(ordered_json::parse(*before), document);
    for (const std::string& line : changes) fmt::print("  {}\n", line);
    if (changes.empty()) fmt::print("No mark has changed.\n");
  } catch (const nlohmann::json::exception&) {
    fmt::print("The results of the last run cannot be read, so changes are not shown.\n");
  }
}

int print_who(const Course& course, const GradeOptions& options) {
  const fs::path submissions = fs::absolute(options.submissions);
  const std::vector<Student> roster = options.roster ? read_roster(*options.roster) : std::vector<Student>{};
  const Workspace copies(fs::temp_directory_path());
  const Intake intake = take_in(submissions, course, roster, copies.directory());
  std::vector<std::string> missing;
  for (const Student& student : intake.students) {
    if (student.is_missing() && student.unread.empty()) {
      missing.push_back(student.id);
      continue;
    }
    const std::string entry = printable(student.entry);
    std::vector<std::string> files;
    for (const auto& [exercise, file] : student.files)
      files.push_back(file.refusal.empty() ? exercise : exercise + " (not read)");
    fmt::print("{}{}{}: {}\n", student.id, student.name.empty() ? "" : ", " + student.name,
               entry.empty() || entry == student.id ? "" : " (" + entry + ")",
               !student.dispute.empty() ? student.dispute
               : files.empty()          ? "nothing that is graded"
                                        : listed(files));
    for (const std::string& sentence : student.unread) fmt::print("  {}\n", sentence);
  }
  return print_intake(intake, intake.problems, missing, options, "") ? all_passed : something_failed;
}

}  // namespace

int grade(const Course& given, const GradeOptions& options) {
  if (options.who) return print_who(given, options);
  if (!options.out) throw GradingError("Say with --out FOLDER where the results go, or only --who handed in what.");
  const fs::path out = fs::absolute(*options.out).lexically_normal();
  const SandboxStrength sandbox = strong_sandbox(options.allow_reduced, out);
  const fs::path submissions = fs::absolute(options.submissions);
  Course course = given;
  course.use_scratch(out / "work");
  const std::optional<std::uint64_t> of_references = use_references(course, options.references);
  const std::uint64_t handed_out = options.copy ? read_release(*options.copy).seed : course.seed();
  const Assignment assignment(course, options.assignment);
  const Match zone = search(assignment.due_text(), "[+-]\\d\\d:?\\d\\d$");
  const std::vector<Student> roster =
      options.roster ? read_roster(*options.roster, zone ? zone[0] : "Z") : std::vector<Student>{};
  const fs::path kept_overrides = out / "overrides.csv";
  const std::optional<fs::path> overrides_file = options.overrides            ? options.overrides
                                                 : fs::exists(kept_overrides) ? std::optional(kept_overrides)
                                                                              : std::nullopt;
  const Overrides overrides = overrides_file ? read_overrides(*overrides_file, assignment) : Overrides{};
  if (options.roster) require_known(overrides, roster);
  const std::string overrides_text = overrides_file ? read_file(*overrides_file).value_or("") : "";
  if (!options.attempts.empty() && options.attempts != "last" && options.attempts != "best")
    throw GradingError("--attempts should be last or best.");
  const std::string forgotten = options.only.empty() ? "" : known_verdict(options.only);
  const std::string part = options.shard.empty() ? "1/1" : options.shard;
  is_in_part("", part);                // so that a wrong one is refused now
  const mode_t usual = ::umask(0077);  // results are nobody else's
  const bool is_new = !fs::exists(out / journal_name);
  prepare_folder(out, submissions);
  Journal journal(out / journal_name, Journal::Access::write, forgotten);
  const std::vector<Journal> merged = journals_in(options.merged, out);
  const std::uint64_t seed = of_references  ? *of_references
                             : options.seed ? *options.seed
                                            : own_seed(course, options, journal, merged);
  if (!of_references) journal.remember_seed(seed);
  for (const Journal& each : merged) journal.merge(each);
  fmt::print("Sandbox: {}.\n", sandbox.sentence());
  if (journal.damaged() > 0) fmt::print("{} of the journal are damaged.\n", plural(journal.damaged(), "line"));
  const bool is_known = seed == handed_out;
  if (is_known)
    fmt::print("Students may have the results of these cases (seed {}), so answers learnt by heart pass.\n", seed);
  Grader grader(course, assignment, seed,
                is_known || of_references || !course.has_solutions() ? std::nullopt : std::optional(handed_out),
                options.explain_minutes, out, journal);
  ::umask(usual);  // the build is everybody's
  grader.build_all(sandbox.tier());
  ::umask(0077);
  std::vector<fs::path> needed = options.references;
  needed.insert(needed.end(), {submissions, course.lectures(), course.toolchain_file()});
  give_up_root(out, needed, sandbox.tier() < SandboxTier::full);
  use_sandbox(sandbox);
  std::error_code ignored;
  Intake intake = [&] {
    try {
      grader.require_misconceptions();
      Intake taken = take_in(submissions, course, roster, out / "submissions", part, !options.attempts.empty());
      if (options.attempts == "last")
        for (Student& student : taken.students)
          if (!student.attempts.empty()) take_attempt(student, student.attempts.size() - 1, "the last one");
      if (!options.shard.empty()) return taken;
      require_known(overrides, taken.students);
      for (Student& student : taken.students)
        if (overrides.contains(student.id)) student.by_hand = overrides.at(student.id);
      return taken;
    } catch (const GradingError&) {
      fs::remove_all(is_new ? out : out / "work", ignored);
      throw;
    }
  }();
  grader.begin(intake);
  fmt::print("{}, {}: {} to judge.\n", plural(intake.students.size(), "student"),
             plural(assignment.exercises().size(), "exercise"), plural(grader.left_to_judge(), "different file"));
  std::fflush(stdout);
  grader.judge_all();
  if (!options.shard.empty()) {
    for (const char* folder : {"work", "submissions"}) fs::remove_all(out / folder, ignored);
    fmt::print("Part {} is judged; `{}` joins the parts.\n", options.shard,
               command("grade SUBMISSIONS --out FOLDER --merge " + shell_quoted(options.out->string())));
    return grader.failed() == 0 ? all_passed : checker_failed;
  }
  grader.take_best_attempts(intake);
  ordered_json document = grader.write_results(intake, sandbox.sentence(), options.with_missing);
  compare_with_last_run(out / "class.json", document);
  for (const auto& [name, text] : class_exports(document)) write_or_fail(out / name, text);
  write_or_fail(out / "class.html", class_page(document, current_day()));
  write_or_fail(out / "class.json", indented(document));  // the last: it is what the next run compares with
  if (overrides_file) write_or_fail(kept_overrides, overrides_text);
  if (options.roster)
    if (const auto worksheet = filled_worksheet(*options.roster, document))
      write_or_fail(out / "moodle_worksheet.csv", *worksheet);
  fs::remove_all(out / "work", ignored);
  const std::vector<std::string> problems = document.at("problems"), missing = document.at("missing");
  const std::string left_out = problems.empty() ? "" : fmt::format("; {} not read or not judged", problems.size());
  const bool is_complete = options.with_missing || (problems.empty() && missing.empty());
  const bool is_all = print_intake(
      intake, problems, missing, options,
      left_out + (is_complete ? "" : ". The tables have no rows of whom this concerns; --with-missing adds them"));
  for (const ordered_json& each : document.at("learnt_by_heart"))
    fmt::print("Learnt by heart: {}: {}.\n", each.at("exercise").get<std::string>(),
               listed(each.at("students").get<std::vector<std::string>>()));
  for (const std::string sentence : document.at("not_judged")) fmt::print("Not judged: {}\n", sentence);
  fmt::print("The page of the class is {}; grades.csv and a page for every student are beside it.\n",
             shown_path(out / "class.html"));
  if (!document.at("not_judged").empty()) return checker_failed;
  return is_all ? all_passed : something_failed;
}

}  // namespace workbook
