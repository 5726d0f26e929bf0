#include "checker/course/course.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace workbook {

static void from_json(const nlohmann::json& part, CardExercise& exercise) {
  exercise = {part.at("name"), part.at("points"), part.at("notes"), part.at("task")};
  if (part.value("problem", false)) exercise.difficulty = part.at("difficulty");
  const bool is_known = part.contains("minutes") || exercise.is_problem();
  exercise.minutes = is_known ? part.at("minutes").get<int>() : std::max(1, static_cast<int>(10 * exercise.points));
}
// The macro defines to_json as well, which nobody calls.
static void to_json(nlohmann::json& part, const CardExercise& exercise) { part = exercise.name; }
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Card, title, summary, slides, builds_on, contract, facts, exercises)

namespace {

/// "(/exercises/0/points) type must be …", without the name of the exception in brackets.
std::string json_reason(const nlohmann::json::exception& problem) {
  const std::string reason = problem.what();
  return reason.substr(reason.find(']') + 2);
}

Card read_card(const fs::path& lecture) {
  const fs::path file = lecture / "card.json";
  const auto refuse = [&](const std::string& reason) {
    throw CourseError(fmt::format("{}: {}.", file.string(), reason));
  };
  const std::optional<std::string> text = read_file(file);
  if (!text) refuse("the card of the lecture is missing or cannot be read");
  Card card;
  try {
    card = nlohmann::json::parse(*text).get<Card>();
  } catch (const nlohmann::json::exception& problem) {
    refuse(json_reason(problem));
  }
  card.lecture = lecture.filename().string();
  std::set<std::string> names;
  for (const CardExercise& exercise : card.exercises) {
    if (!names.insert(exercise.name).second) refuse(fmt::format("the exercise '{}' is on it twice", exercise.name));
    if (!(exercise.points > 0)) refuse(fmt::format("the points of '{}' should be a positive number", exercise.name));
    if (exercise.difficulty < 0 || exercise.difficulty > 3)
      refuse(fmt::format("the difficulty of '{}' of a problem should be from 1 to 3", exercise.name));
    if (exercise.minutes <= 0) refuse(fmt::format("the minutes of '{}' should be a positive number", exercise.name));
  }
  return card;
}

/// What the compiler complains about first.
std::string first_errors(const std::string& output) {
  constexpr int most_errors = 3;
  std::string text;
  int count = 0;
  for (const std::string& line : lines_of(output))
    if (line.find("error: ") != std::string::npos && count++ < most_errors) text += "\n" + line;
  return text;
}

[[noreturn]] void throw_unknown(const std::string& what, const std::string& name,
                                const std::vector<std::string>& known) {
  const std::string meant = did_you_mean(name, known);
  throw UsageError(fmt::format("There is no {} '{}'.{} `{}` shows all names.", what, name,
                               meant.empty() ? "" : fmt::format(" Did you mean '{}'?", meant), command("list")));
}

std::string without_zeros(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('0'), name.size()));
}

std::string topic_of(const Card& card) {
  return card.lecture.substr(std::min(card.lecture.find('_'), card.lecture.size() - 1) + 1);
}

bool is_named(const Card& card, const std::string& name) {
  const std::string number = card.lecture.substr(0, card.lecture.find('_'));
  const std::string wanted = without_zeros(name);
  return wanted == without_zeros(card.lecture) || wanted == without_zeros(number) || wanted == topic_of(card);
}

}  // namespace

Course::Course(const fs::path& course_file) {
  const std::optional<std::string> text = read_file(course_file);
  if (!text)
    throw CourseFileError(fmt::format("{}: missing, or no file; build the workbook again.", course_file.string()));
  try {
    const auto document = nlohmann::json::parse(*text);
    const auto path = [&](const char* key) { return fs::path(document.at(key).get<std::string>()); };
    root_ = path("root");
    reference_ = path("reference");
    toolchain_file_ = path("toolchain");
    scratch_ = path("scratch");
    notes_ = path("notes");
    build_ = {document.value("setup", ""), path("build")};
  } catch (const nlohmann::json::exception& problem) {
    throw CourseFileError(
        fmt::format("{}: not usable ({}); build the workbook again.", course_file.string(), json_reason(problem)));
  }
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(lectures(), problem))
    // Notes without a card are a lecture that has lost it.
    if (fs::exists(entry.path() / "card.json") || fs::exists(entry.path() / "notes.md"))
      cards_.push_back(read_card(entry.path()));
  std::ranges::sort(cards_, {}, &Card::lecture);
  if (!has_solutions() && !cards_.empty()) seed_ = seed_of_reference_results(reference_file(cards_.front().lecture));
}

std::vector<Exercise> Course::exercises() const {
  std::vector<Exercise> all;
  for (const Card& card : cards_)
    for (const CardExercise& entry : card.exercises) all.push_back({&card, &entry});
  return all;
}

std::vector<Exercise> Course::exercises_before(const Exercise& exercise) const {
  std::vector<Exercise> all = exercises();
  all.erase(std::ranges::find(all, exercise.name(), &Exercise::name), all.end());
  return all;
}

const Card& Course::find_lecture(const std::string& name) const {
  std::vector<std::string> known;
  for (const Card& card : cards_) {
    if (is_named(card, name)) return card;
    known.insert(known.end(), {card.lecture, topic_of(card)});
  }
  throw_unknown("lecture", name, known);
}

std::vector<Exercise> Course::find(const std::string& name) const {
  std::vector<Exercise> of_lecture;
  std::vector<std::string> known;
  for (const Exercise& exercise : exercises()) {
    // An exercise may be called like the topic of a lecture; then the exercise is meant.
    if (name == exercise.name()) return {exercise};
    if (is_named(*exercise.card, name)) of_lecture.push_back(exercise);
    known.insert(known.end(), {exercise.name(), exercise.lecture(), topic_of(*exercise.card)});
  }
  if (of_lecture.empty()) throw_unknown("exercise or lecture", name, known);
  return of_lecture;
}

std::vector<Exercise> Course::choose(const std::vector<std::string>& names) const {
  if (names.empty()) return exercises();
  std::vector<Exercise> all;
  for (const std::string& name : names)
    for (const Exercise& exercise : find(name))
      if (std::ranges::count(all, exercise.entry, &Exercise::entry) == 0) all.push_back(exercise);
  return all;
}

Exercise Course::find_exercise(const std::string& name) const {
  const Exercise found = find(name).front();
  if (found.name() != name)
    throw UsageError(fmt::format("'{}' is a lecture; name one of its exercises, such as {}.", name, found.name()));
  return found;
}

std::optional<fs::path> Course::notes_page(const std::string& lecture) const {
  const fs::path page = notes_ / ("lecture_" + lecture + ".html");
  return fs::exists(page) ? std::optional(page) : std::nullopt;
}

fs::path Course::reference_file(const std::string& lecture) const {
  const fs::path handed_out = lectures() / lecture / "handed_out" / "reference.json";
  return fs::exists(handed_out) ? handed_out : reference_ / (lecture + ".json");
}

std::string Course::trouble_to_build(const std::string& target, const fs::path& file,
                                     const std::vector<fs::path>& sources) const {
  const bool is_old = std::ranges::any_of(sources, [&](const fs::path& source) { return is_newer(source, file); });
  if (build_.setup.empty() || !is_old) return "";
  const FinishedProgram made = make(build_, {target});
  if (made.succeeded()) {
    // A folder is newer than the file after any change in it, also one that the file does not depend on.
    std::error_code ignored;
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);
    return "";
  }
  return fmt::format("{} says why.{}", shown_path(build_.directory / "build.log"), first_errors(made.output));
}

std::vector<fs::path> Course::sources_of_reference(const std::string& lecture) const {
  const fs::path solutions = root_ / "solutions";
  return {solutions / lecture, solutions / "judging", root_ / "include"};
}

void Course::make_reference(const std::string& lecture) const {
  const std::string trouble =
      trouble_to_build("reference_results_" + lecture, reference_ / (lecture + ".json"), sources_of_reference(lecture));
  if (!trouble.empty())
    throw ReferenceError(fmt::format("The reference results of {} could not be made; {}", lecture, trouble));
}

/// What a program made of solutions prints.
static std::string output_of_author(const fs::path& program, const std::vector<std::string>& arguments) {
  // Far above what any takes on a slow and busy machine: it ends only what hangs.
  constexpr std::chrono::minutes limit(30);
  const FinishedProgram made = run_with_path(program.string(), arguments, limit);
  if (!made.succeeded())
    throw ReferenceError(
        fmt::format("{} {} failed: {}", program.string(), fmt::join(arguments, " "),
                    made.out_of_time ? fmt::format("it took more than {} minutes", limit.count()) : made.output));
  return made.output;
}

void Course::run_reference_program(const std::string& lecture, const fs::path& file,
                                   const std::vector<std::string>& options) const {
  const fs::path program = reference_program(lecture);
  if (!fs::exists(program))
    throw ReferenceError(fmt::format(
        "This copy of the workbook has reference results for seed {} only; other seeds need the solutions, which it "
        "does not have.",
        seed_));
  fs::create_directories(file.parent_path());
  std::vector<std::string> arguments = {"--lecture", lecture, "--out", file.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  output_of_author(program, arguments);
}

std::string Course::rounding(const std::string& lecture) const {
  const std::string name = "rounding_" + lecture;
  const std::string trouble = trouble_to_build(name, reference_ / name, sources_of_reference(lecture));
  if (!trouble.empty())
    throw ReferenceError(fmt::format("The solutions of {} in extended precision do not compile; {}", lecture, trouble));
  return output_of_author(reference_ / name, {(reference_ / (lecture + ".json")).string()});
}

LectureReference Course::random_cases(const std::string& lecture, std::uint64_t seed) const {
  make_reference(lecture);
  const fs::path file = scratch_ / "reference" / fmt::format("{}-random-{}.json", lecture, ::getpid());
  run_reference_program(lecture, file, {"--seed", std::to_string(seed), "--cases", "random"});
  LectureReference results = read_reference_results(file);
  fs::remove(file);
  return results;
}

fs::path Course::prove_adequacy(const Exercise& exercise, int seeds, const fs::path& record) const {
  const fs::path file = scratch_ / "reference" / (exercise.name() + "-adequacy.json");
  run_reference_program(exercise.lecture(), file,
                        {"--prove", exercise.name(), "--seeds", std::to_string(seeds), "--adequacy", record.string()});
  return file;
}

LectureReference Course::reference(const std::string& lecture, std::uint64_t seed, const std::string& only) const {
  const auto given = given_.find(lecture);
  if (given == given_.end() && has_solutions()) make_reference(lecture);
  fs::path file = given != given_.end() ? given->second : reference_file(lecture);
  if (given == given_.end() && seed != seed_) {
    file = scratch_ / "reference" / fmt::format("{}-seed-{}.json", lecture, seed);
    if (is_newer(reference_program(lecture), file) || is_newer(adequacy_file(lecture), file))
      run_reference_program(lecture, file,
                            {"--seed", std::to_string(seed), "--adequacy", adequacy_file(lecture).string()});
  }
  LectureReference results = read_reference_results(file, only);
  for (const CardExercise& exercise : find_lecture(lecture).exercises)
    if ((only.empty() || exercise.name == only) &&
        std::ranges::count(results.exercises, exercise.name, &ExerciseReference::name) == 0)
      throw ReferenceError(
          fmt::format("{}: '{}' is missing, though the card lists it; `{}` names what is to be written.", file.string(),
                      exercise.name, command("self-check " + exercise.name)));
  return results;
}

std::uint64_t Course::use_reference(const fs::path& file) {
  const LectureReference results = read_reference_results(file);
  given_[find_lecture(results.lecture).lecture] = fs::absolute(file);
  return results.seed;
}

}  // namespace workbook
