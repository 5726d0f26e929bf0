#include "checker/commands/on_demand/options.hpp"
#include "checker/course/assignment.hpp"
#include "checker/course/locked_text.hpp"
#include "checker/grading/grading.hpp"
#include "checker/templates/templates.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <iterator>
#include <random>

namespace workbook {

using nlohmann::json;

namespace {

constexpr const char* assignment_name = "lectures/assignment.json";

/// What students get, relative to the top level. What is not named here stays at home: the solutions first of all.
constexpr std::array handed_out = {".clang-format",
                                   ".clangd",
                                   ".devcontainer",
                                   ".github/workflows/check.yml",
                                   ".github/workflows/notes.yml",
                                   ".gitignore",
                                   ".vscode",
                                   "CMakeLists.txt",
                                   "CMakePresets.json",
                                   "LICENSE",
                                   "README.md",
                                   "checker",
                                   "include",
                                   "lectures",
                                   "tests/CMakeLists.txt",
                                   "tests/run",
                                   "tests/judging",
                                   "tests/running",
                                   "tests/setup",
                                   "tests/support"};

bool is_left_behind(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.starts_with('.') || name.ends_with('~') || name.ends_with(".orig");
}

/// Copies a file, or a folder without dot-files and editors' backups.
void copy_part(const fs::path& from, const fs::path& to) {
  if (!fs::is_directory(from)) return place_file(from, to);
  for (auto entry = fs::recursive_directory_iterator(from); entry != fs::recursive_directory_iterator(); ++entry) {
    if (is_left_behind(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      place_file(entry->path(), to / entry->path().lexically_relative(from));
    }
  }
}

/// Every exercise as it was at the beginning, whatever has been tried in this copy.
void write_stubs(const Course& course, const fs::path& copy) {
  for (const Card& card : course.cards()) fs::remove_all(copy / "lectures" / card.lecture / "exercises");
  for (const Exercise& exercise : course.exercises())
    write_or_throw(copy / course.in_course(course.student_file(exercise)),
                   stub_text(exercise, declared_signature(course, exercise)));
}

/// Of a locked text and of the results that a right function returns.
std::string fingerprint_of(const std::string& text, const ExerciseReference& judged) {
  std::string bytes = text;
  for (const Case& one : judged.cases)
    bytes.append(reinterpret_cast<const char*>(one.expected.numbers.data()),
                 one.expected.numbers.size() * sizeof(double));
  return fingerprint(bytes);
}

/// Without names of routes and of small bugs, which tell how a function is written.
LectureReference without_secrets(LectureReference reference) {
  for (ExerciseReference& exercise : reference.exercises) {
    for (std::size_t k = 0; k < exercise.routes.size(); ++k) exercise.routes[k].name = fmt::format("route {}", k + 1);
    exercise.adequacy = {};
    exercise.survivor_reasons = {};
  }
  return reference;
}

/// The notes as pages without derivations; missing where this machine cannot build them.
fs::path student_notes(const Course& course) { return course.build().directory / "student_notes.zip"; }

/// What the reference implementation made: the results to judge by, the notes, and the numbers and figures in them.
void copy_made(const Course& course, const fs::path& copy, const std::vector<LectureReference>& references) {
  if (fs::exists(student_notes(course))) place_file(student_notes(course), copy / "lectures/site/handed_out.zip");
  for (const LectureReference& reference : references) {
    const fs::path data = copy / "lectures" / reference.lecture / "handed_out";
    place_file(course.build().directory / "printed" / (reference.lecture + ".txt"), data / "printed.txt");
    copy_figures(course, reference.lecture, data / "figures");
    write_reference_results(without_secrets(reference), data / "reference.json");
  }
}

/// Solution and another route, or the derivation, for those whose function is right. Where neither these nor the
/// results have changed since an earlier copy, its files stay: another key would be a change for nothing.
void lock_derivations(const Course& course, const fs::path& copy, const std::vector<LectureReference>& references,
                      const std::optional<fs::path>& earlier) {
  const std::uint64_t seed = std::random_device()();
  LectureReference secret;
  for (const Exercise& exercise : course.exercises()) {
    const auto derivation = read_file(course.derivation_file(exercise));
    const auto code = read_file(course.solution_file(exercise));
    if (!derivation || !code) continue;
    const fs::path file = course.in_course(course.locked_file(exercise));
    const std::string text = *code + "\n" + *derivation;
    const auto lecture = std::ranges::find(references, exercise.lecture(), &LectureReference::lecture);
    const std::string made_from = fingerprint_of(text, lecture->exercise(exercise.name()));
    const std::string before = earlier ? read_file(*earlier / file).value_or("") : "";
    if (const json known = json::parse(before, nullptr, false);
        known.is_object() && known.value("made_from", "") == made_from) {
      write_or_throw(copy / file, before);
      continue;
    }
    if (secret.lecture != exercise.lecture()) secret = course.random_cases(exercise.lecture(), seed);
    ExerciseReference reference = secret.exercise(exercise.name());
    // Whole numbers need more calls than there are random cases.
    for (std::uint64_t draw = 1; draw <= 30 && !makes_key(reference); ++draw)
      std::ranges::copy(course.random_cases(exercise.lecture(), seed + draw).exercise(exercise.name()).cases,
                        std::back_inserter(reference.cases));
    json locked = json::parse(locked_text(reference, text));
    locked["made_from"] = made_from;
    write_or_throw(copy / file, locked.dump() + "\n");
  }
}

void copy_sources(const Course& course, const fs::path& copy) {
  for (const char* part : handed_out) {
    if (fs::exists(course.root() / part)) copy_part(course.root() / part, copy / part);
  }
  write_stubs(course, copy);
}

/// @param earlier  the copy that it is to take the place of
void make_copy(const Course& course, const fs::path& copy, const std::vector<LectureReference>& references,
               const std::optional<fs::path>& earlier) {
  copy_sources(course, copy);
  copy_made(course, copy, references);
  lock_derivations(course, copy, references, earlier);
}

void require_solutions_for_copies(const Course& course) {
  if (!course.has_solutions())
    throw UsageError(
        "This copy was handed out itself: it has no solutions, so no other copy can be made from it. Copy the folder.");
}

/// What a learning system takes to grade in a container of its own: templates below checker/grading/containers, and
/// where, of what they make, cases and workbook belong.
struct Recipe {
  const char *system, *cases, *workbook;
};
constexpr std::array recipes = {Recipe{"gradescope", "cases", "workbook"},
                                Recipe{"autolab", "NAME/autograde.tar/cases", nullptr},
                                Recipe{"prairielearn", "questions/NAME/tests/cases", nullptr},
                                Recipe{"classroom50", "autograders/NAME/cases", nullptr}};

/// What the templates are filled with. @param name  of letters and digits
json recipe_values(const Assignment& assignment, const ExportOptions& options, const std::string& name) {
  json exercises = json::array();
  double possible = 0;
  std::vector<std::string> files;
  for (const Exercise& exercise : assignment.exercises()) {
    const double points = exercise.entry->points;
    exercises.push_back({{"exercise", exercise.name()}, {"points", points}, {"task", exercise.entry->task}});
    possible += points;
    files.push_back(exercise.name() + ".cpp");
  }
  std::string uuid =
      fingerprint(name) + fingerprint(assignment.title() + name);  // the same for each week's next export
  for (const std::size_t at : {20, 16, 12, 8}) uuid.insert(at, "-");
  return {{"name", name},
          {"module", capitalized(name)},
          {"title", assignment.title().empty() ? "Rigid Body Workbook" : assignment.title()},
          {"exercises", exercises},
          {"possible", possible},
          {"files", fmt::format("{}", fmt::join(files, ","))},
          {"base", options.image},
          {"image", options.image + "-autolab"},
          {"uuid", uuid}};
}

/// The folder of an earlier release if it is to be updated, or one that is to be filled. @throws UsageError
fs::path target_of(const HandoutOptions& options) {
  const fs::path directory = fs::absolute(*options.out).lexically_normal();
  std::error_code problem;
  const fs::file_status there = fs::status(directory, problem);
  if (!options.update && fs::exists(there) && !(fs::is_directory(there) && fs::is_empty(directory, problem)))
    throw UsageError(fmt::format(
        "{} exists and is not empty; name a new or an empty folder, so that nothing is lost, or --update it.",
        shown_path(directory)));
  return directory.has_filename() ? directory : directory.parent_path();
}

/// All files of a folder, in a file whose name says of which kind: "week3.zip", "week3.tar". @throws std::runtime_error
void write_archive(const fs::path& folder, const fs::path& file) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  const std::unique_ptr<archive, decltype(&archive_write_free)> written(archive_write_new(), archive_write_free);
  const std::unique_ptr<archive_entry, decltype(&archive_entry_free)> entry(archive_entry_new(), archive_entry_free);
  const auto require = [&](la_ssize_t status) {
    if (status < ARCHIVE_OK)
      throw std::runtime_error(
          fmt::format("{} cannot be written ({}).", shown_path(file), archive_error_string(written.get())));
  };
  require(archive_write_set_format_filter_by_ext(written.get(), file.c_str()));
  require(archive_write_open_filename(written.get(), file.c_str()));
  for (const fs::path& each : files) {
    const std::string text = read_file(each).value();
    archive_entry_clear(entry.get());
    archive_entry_set_pathname(entry.get(), each.lexically_relative(folder).c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), static_cast<mode_t>(fs::status(each).permissions()));
    archive_entry_set_mtime(entry.get(), std::time(nullptr), 0);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(text.size()));
    require(archive_write_header(written.get(), entry.get()));
    require(archive_write_data(written.get(), text.data(), text.size()));
  }
  require(archive_write_close(written.get()));
}

}  // namespace

int handout(const Course& course, const HandoutOptions& options) {
  require_solutions_for_copies(course);
  const fs::path whole = target_of(options);
  std::optional<Release> before;
  if (options.update) before = read_release(whole);
  Assignment(course, options.assignment);  // so that a wrong one is refused now
  const FinishedProgram built = make(course.build(), {"handed_out"});
  if (!built.succeeded())
    throw std::runtime_error(
        built.output +
        "\nNothing was handed out, because the reference results, figures and numbers of the notes could "
        "not be made; fix what the lines above name.");
  // An update keeps the cases of the copy, unless others are asked for.
  const std::uint64_t seed = options.seed.value_or(before ? before->seed : course.seed());
  std::vector<LectureReference> references;
  for (const Card& card : course.cards()) references.push_back(course.reference(card.lecture, seed));
  // Under another name first, so that there is a whole copy or none.
  const fs::path unfinished = fmt::format("{}.unfinished-{}", whole.string(), getpid());
  Release release;
  const auto stop_with = [&](const std::exception& reason, const std::string& what_now) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw std::runtime_error(fmt::format("{} could not be written ({}); {}", options.out->string(),
                                         without_full_stop(reason.what()), what_now));
  };
  try {
    make_copy(course, unfinished, references, before ? std::optional(whole) : std::nullopt);
    // An update keeps the assignment as well.
    const bool keeps = before && before->files.contains(assignment_name) && fs::exists(whole / assignment_name);
    if (options.assignment)
      place_file(*options.assignment, unfinished / assignment_name);
    else if (keeps)
      place_file(whole / assignment_name, unfinished / assignment_name);
    release = write_release(unfinished, seed, current_day(), options.message, before);
    if (!before) {
      if (fs::exists(whole)) fs::remove(whole);
      fs::rename(unfinished, whole);
    }
  } catch (const std::exception& reason) {
    stop_with(reason, "nothing was handed out. Name a folder in a place that is writable.");
  }
  if (before) try {
      print_update(release, *before, update_copy(unfinished, release, whole, *before));
      fs::remove_all(unfinished);
    } catch (const std::exception& reason) {
      stop_with(reason, "do not hand it out before the same command has succeeded.");
    }
  fmt::print(
      "{} holds {} with {}, their cases drawn with seed {}, and no solutions. Students type ./checker/run in it; put "
      "it into an archive or a repository of its own.\n",
      options.out->string(), plural(course.cards().size(), "lecture"), plural(course.exercises().size(), "exercise"),
      seed);
  if (!fs::exists(student_notes(course)))
    say("Students will read the notes as plain text, because this machine cannot build the pages; cmake --workflow "
        "--preset notes says which packages are missing. Then repeat this command with --update.");
  return all_passed;
}

int export_recipe(const Course& course, const ExportOptions& options) {
  const auto recipe = std::ranges::find(recipes, options.system, &Recipe::system);
  if (recipe == recipes.end())
    throw UsageError(
        fmt::format("There is no system '{}'; there are gradescope, autolab, prairielearn and classroom50.",
                    printable(options.system)));
  require_solutions_for_copies(course);
  const Assignment assignment(course, options.assignment);
  const fs::path file = fs::absolute(*options.out);
  std::string name = options.assignment ? options.assignment->stem().string() : "workbook";
  std::erase_if(name, [](unsigned char letter) { return std::isalnum(letter) == 0; });
  if (name.empty() || std::isalpha(static_cast<unsigned char>(name[0])) == 0) name = "week" + name;
  std::ranges::transform(name, name.begin(), [](unsigned char letter) { return std::tolower(letter); });
  std::random_device random;
  const std::uint64_t seed = options.seed ? *options.seed : (std::uint64_t{random()} << 20) ^ random();
  const json values = recipe_values(assignment, options, name);
  const auto named = [&](std::string path) { return boost::replace_all_copy(path, "NAME", name); };
  const Workspace made(fs::temp_directory_path());
  const fs::path root = made.directory() / "made",
                 templates = course.root() / "checker/grading/containers" / recipe->system;
  std::map<fs::path, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(templates))
    if (entry.is_regular_file()) texts[entry.path()] = read_file(entry.path()).value();
  texts = filled_texts(texts, values);
  const std::string next = texts.extract(templates / "next.txt").mapped();
  for (const auto& [form, text] : texts) {
    const fs::path target = root / named(form.lexically_relative(templates).string());
    write_or_throw(target, text);
    fs::permissions(target, fs::status(form).permissions());
  }
  const fs::path cases = root / named(recipe->cases);
  write_or_throw(cases / "assignment.json", options.assignment ? read_file(*options.assignment).value() : "{}\n");
  for (const Card& card : course.cards()) {
    write_reference_results(without_secrets(course.reference(card.lecture, seed)), cases / (card.lecture + ".json"));
    if (card.lecture == assignment.exercises().back().lecture()) break;  // functions of earlier ones may be called
  }
  if (recipe->workbook != nullptr) copy_sources(course, root / recipe->workbook);
  if (const fs::path inner = cases.parent_path(); inner.extension() == ".tar") {
    write_archive(inner, made.directory() / "inner.tar");
    fs::remove_all(inner);
    fs::rename(made.directory() / "inner.tar", inner);
  }
  write_archive(root, file);
  fmt::print("{} holds {} for {}, with cases of seed {}. {}", shown_path(file),
             plural(assignment.exercises().size(), "exercise"), recipe->system, seed, next);
  return all_passed;
}

}  // namespace workbook
