#include "checker/commands/on_demand/given_away.hpp"
#include "checker/commands/on_demand/options.hpp"
#include "checker/explain/question.hpp"
#include "checker/explain/repair.hpp"
#include "checker/explain/values/soundness.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <sstream>

namespace workbook {

namespace {

constexpr std::size_t hints_wanted = 3, limits_wanted = 2;

/// What stands in a formula and not in a sentence: operators, powers, fractions, functions of symbols.
constexpr const char* in_formulas =
    R"([=/^|]|(×|·|√|∫|Σ|∂|½|⅓|⅔|¼|²|³|⁻|ᵀ)| (\+|-|−) |\b(sin|cos|tan|cot|ln|exp|sinh|cosh|tanh|sech|sqrt)\b)";

std::string text_of(const fs::path& file) { return read_file(file).value_or(""); }

/// One line, and one for each bug that no case shows.
std::string adequacy_text(const Exercise& exercise, const ExerciseReference& judged, const Adequacy& adequacy) {
  std::string text = fmt::format("{:.2} {:<30} {:>3} of {:>3} bugs found, {} equal in the domain\n", exercise.lecture(),
                                 exercise.name(), adequacy.killed, adequacy.made, adequacy.equal);
  for (const std::string& bug : adequacy.survivors)
    text += fmt::format("   not found: {}. {}\n", bug, judged.survivor_reason(bug));
  return text;
}

/// Works on the exercises in processes of their own, several at once: `work` gives a JSON document, which `use` takes.
/// What goes wrong is a fault of that exercise.
/// @param limit for one exercise
void for_each_exercise(const std::vector<Exercise>& exercises, std::chrono::minutes limit,
                       const std::function<nlohmann::json(const Exercise&)>& work,
                       const std::function<void(std::size_t, const nlohmann::json&)>& use,
                       std::vector<std::string>& faults) {
  const auto begin = [&](std::size_t k) {
    const auto guarded = [&work, &exercise = exercises[k]] {
      try {
        return work(exercise).dump();
      } catch (const std::exception& problem) {
        return nlohmann::json{{"problem", problem.what()}}.dump();
      }
    };
    return std::make_unique<ForkedJob>(guarded, limit);
  };
  ProgressBar progress_bar;
  std::size_t done = 0;
  run_jobs(exercises.size(), begin, [&](std::size_t k, ForkedJob& job) {
    progress_bar.show(++done, exercises.size(), exercises[k].name());
    std::string trouble = job.finish();
    const auto found = nlohmann::json::parse(job.output(), nullptr, false);
    if (trouble.empty()) trouble = found.value("problem", "");
    if (trouble.empty())
      use(k, found);
    else
      faults[k] = without_full_stop(trouble);
  });
  progress_bar.clear();
}

/// Collects what is wrong, each sentence once and with the fix, and counts what was looked at.
class SelfCheck {
 public:
  SelfCheck(const Course& course, std::vector<Exercise> exercises, const std::vector<std::uint64_t>& seeds,
            bool runs_solutions)
      : course_(course),
        context_(course),
        exercises_(std::move(exercises)),
        seeds_(seeds),
        runs_solutions_(runs_solutions) {}

  int run(const std::vector<const Card*>& cards) {
    std::map<std::string, std::string> lecture_of;
    for (const Exercise& exercise : course_.exercises())
      if (const auto [first, is_new] = lecture_of.emplace(exercise.name(), exercise.lecture()); !is_new)
        fault(card_file(*exercise.card), "the exercise '{}' is on the card of {} too; rename one.", exercise.name(),
              first->second);
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
          add(problem.what());
        }
      }
    }
    progress_bar.clear();
    for (const std::uint64_t seed : seeds_)
      if (runs_solutions_) require_passes(seed);
    if (!adequacy_.empty())
      fmt::print(
          "Bugs are small mistakes in the solution, such as a lost sign. One is found if some case fails with it, and "
          "is "
          "equal in the domain if no legal input shows it.\n{}",
          adequacy_);
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
  /// Something that should be there.
  struct Part {
    fs::path file;
    std::string fix;
    bool is_there = fs::is_regular_file(file);
  };

  void add(const std::string& sentence) {
    if (std::ranges::find(faults_, sentence) == faults_.end()) faults_.push_back(sentence);
  }

  template <class... Words>
  void fault(const fs::path& file, fmt::format_string<Words...> text, Words&&... words) {
    add(course_.in_course(file) + ": " + fmt::format(text, std::forward<Words>(words)...));
  }

  /// What is missing comes in one message.
  void require(const std::string& what, const std::vector<Part>& parts) {
    std::string missing;
    for (const Part& part : parts)
      if (!part.is_there) missing += fmt::format("\n  {}: {}", course_.in_course(part.file), part.fix);
    if (!missing.empty())
      add(fmt::format("{}: write what is missing, or remove the entry from the card.{}", what, missing));
  }

  fs::path card_file(const Card& card) const { return course_.lectures() / card.lecture / "card.json"; }

  std::vector<Exercise> exercises_of(const Card& card) const {
    std::vector<Exercise> all;
    std::ranges::copy_if(exercises_, std::back_inserter(all), [&](const Exercise& each) { return each.card == &card; });
    return all;
  }

  /// Whatever can be seen without reference results.
  void check_parts(const Card& card) {
    const fs::path folder = course_.lectures() / card.lecture;
    require(card.lecture, {{course_.contract_file(card), "the contract that the card names"},
                           {folder / "notes.md", "the notes"},
                           {folder / "worked_examples.cpp", "the worked examples, as cases of doctest"},
                           {folder / "figures.cpp", "the program that draws the figures"}});
    for (const std::string& earlier : card.builds_on)
      if (std::ranges::find(course_.cards(), earlier, &Card::lecture) == course_.cards().end())
        fault(card_file(card), "builds_on names '{}', which is no lecture of the course.", earlier);
    if (course_.has_solutions()) check_strays(card);  // a student may keep any file there
    if (card.exercises.empty())
      fault(card_file(card), "no exercise yet; `{}` adds one.",
            command("new exercise NAME --lecture " + card.lecture + " --signature '...'"));
    const std::string notes = text_of(course_.notes_file(card));
    for (const Exercise& exercise : exercises_of(card)) {
      const std::string anchor = "{#" + exercise.entry->notes + "}";
      std::vector<Part> parts = {
          {course_.contract_file(card), fmt::format("the declaration `TYPE {}(...);`", exercise.name()),
           !declared_signature(course_, exercise).empty()},
          {course_.hints_file(exercise), "three hints, weakest first, with lines of three dashes between"},
          {course_.notes_file(card), fmt::format("a heading with the anchor {}, to which the card points", anchor),
           notes.find(anchor) != std::string::npos}};
      if (course_.has_solutions())
        parts.insert(parts.end(),
                     {{course_.student_file(exercise),
                       fmt::format("the stub; `{}` writes it", command("reset " + exercise.name()))},
                      {course_.solution_file(exercise), "the solution"},
                      {course_.judging_file(exercise), "how it is judged"},
                      {course_.derivation_file(exercise), "another route to the same result, and why it is equal"}});
      require(card.lecture + ", " + exercise.name(), parts);
      if (fs::exists(course_.hints_file(exercise))) check_hints(exercise);
    }
    check_commands(course_.notes_file(card), notes);
  }

  void check_hints(const Exercise& exercise) {
    const fs::path hints_file = course_.hints_file(exercise);
    try {
      const std::vector<std::string> hints = read_hints(hints_file);
      if (hints.size() != hints_wanted)
        fault(hints_file, "{} instead of {}; separate them by lines of three dashes.", plural(hints.size(), "hint"),
              hints_wanted);
      if (std::set<std::string>(hints.begin(), hints.end()).size() != hints.size())
        fault(hints_file, "two hints are the same; write another.");
    } catch (const CourseError& problem) {
      add(problem.what());
    }
  }

  /// Doxygen passes over what it does not know: its commands and those of the site, whose arguments stand in braces.
  void check_commands(const fs::path& file, std::string notes) {
    static const std::set<std::string> of_doxygen = {
        "ref",     "page",    "include",  "snippet",   "anchor",      "image",        "cite",        "note",   "par",
        "section", "subpage", "htmlonly", "latexonly", "endhtmlonly", "endlatexonly", "htmlinclude", "warning"};
    std::map<std::string, long> of_site;  // so many arguments
    const std::string settings = text_of(course_.lectures() / "site/Doxyfile.in");
    for (const Match& alias : search_all(settings, R"re(ALIASES *\+?= *"(\w+)(?:\{(\d)\})?=)re"))
      of_site[alias[1]] = std::atol(alias[2].c_str());
    if (of_site.empty()) return;
    for (const auto& [open, close] : {std::pair{"```", "```"}, {"`", "`"}, {"\\f$", "\\f$"}, {"\\f[", "\\f]"}})
      for (std::size_t at = 0; (at = notes.find(open, at)) != std::string::npos;)
        notes.erase(at, notes.find(close, at + std::strlen(open)) + std::strlen(close) - at);
    for (const std::string& line : lines_of(notes))
      for (const Match& used : search_all(line, R"re((?:^|[^\\\w])[\\@]([a-z_]+)(\{[^}]*\}?)?)re")) {
        const auto alias = of_site.find(used[1]);
        const long arguments = used[2].empty() ? 0 : 1 + std::ranges::count(used[2], ',');
        // A comma in a single argument is a part of it.
        if (alias != of_site.end() ? alias->second == (alias->second == 1 ? std::min(arguments, 1L) : arguments)
                                   : of_doxygen.contains(used[1]) && (arguments == 0 || used[1] == "include"))
          continue;
        fault(file, "no command reads '\\{}{}': Doxygen passes over it, or takes it for another.", used[1], used[2]);
      }
  }

  /// Files that belong to nothing. Dot-files and editors' backups do not count.
  void check_strays(const Card& card) {
    const fs::path folder = course_.lectures() / card.lecture;
    const fs::path solutions = course_.root() / "solutions" / card.lecture;
    std::set<fs::path> known = {solutions / "shared.hpp", course_.adequacy_file(card.lecture)};
    for (const CardExercise& entry : card.exercises) {
      const Exercise exercise{&card, &entry};
      known.insert({course_.student_file(exercise), course_.hints_file(exercise), course_.solution_file(exercise),
                    course_.judging_file(exercise), course_.derivation_file(exercise)});
    }
    for (const fs::path& each :
         {folder / "exercises", folder / "hints", solutions, solutions / "judging", solutions / "derivations"}) {
      std::error_code ignored;
      for (const auto& entry : fs::directory_iterator(each, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() && !name.starts_with('.') && !name.ends_with('~') && !known.contains(entry.path()))
          fault(entry.path(), "no card lists it; add its exercise to the card, or move the file away.");
      }
    }
  }

  void check_lecture(const Card& card, std::uint64_t seed) {
    const bool is_first = seed == seeds_.front();
    const LectureReference reference = course_.reference(card.lecture, seed);
    if (is_first) check_notes(card, reference);
    const auto rank = [](const CardExercise& entry) { return std::pair(entry.is_problem(), entry.difficulty); };
    const auto easier = std::ranges::is_sorted_until(card.exercises, {}, rank);
    if (easier != card.exercises.end())
      fault(card_file(card), "'{}' stands after a problem or after what is harder; list it earlier.", easier->name);
    for (const Exercise& exercise : exercises_of(card)) {
      const ExerciseReference& judged = reference.exercise(exercise.name());
      for (const std::string& sentence : unsound_parts(judged)) fault(course_.judging_file(exercise), "{}", sentence);
      if (do_routes_agree_on_another(judged)) continue;  // all else follows from it
      check_domain(exercise, judged);
      if (is_first) {
        routes_ += judged.routes.size();
        misconceptions_ += judged.misconceptions.size();
        adequacy_ += adequacy_text(exercise, judged, judged.adequacy);
        check_texts(exercise, judged);
        if (exercise.entry->is_problem()) check_words(exercise, judged);
        if (exercise.entry->is_problem() && judged.limits.size() < limits_wanted)
          fault(
              course_.judging_file(exercise),
              "a problem names {} limits (`e.limit`): what comes out there without its formula, and why. {} names {}.",
              limits_wanted, exercise.name(), judged.limits.size());
        if (exercise.entry->is_problem() && course_.has_solutions())
          for (const GivenAway& each : answers_given_away(course_, exercise)) fault(each.file, "{}", each.sentence);
        if (!question_on(judged))
          fault(course_.judging_file(exercise),
                "no case tells three of its wrong answers apart, as the question after a pass needs; add one.");
      }
      judged_[seed].push_back(exercise);
    }
  }

  /// What the contract demands of numbers by their names, "0 < inner < outer", holds at every case; else the domain of
  /// the judging is wider than the contract. Conditions of another form are left to people.
  void check_domain(const Exercise& exercise, const ExerciseReference& judged) {
    const std::string contract = text_of(course_.contract_file(*exercise.card));
    const std::size_t end = contract.find(" " + exercise.name() + "(");
    const std::size_t before = end == std::string::npos ? end : contract.rfind(";", end);
    if (before == std::string::npos) return;
    constexpr const char* condition =
        R"re((?:^|[,;:(]|\band) *((?:[A-Za-z]\w*|[0-9.]+|π)(?: (?:<|≤|>|≥|≠) (?:[A-Za-z]\w*|[0-9.]+|π))+) *(?=$|[,;:)]| and\b))re";
    for (const std::string& line : lines_of(contract.substr(before, end - before))) {
      const std::size_t pre = line.find("@pre ");
      if (pre == std::string::npos) continue;
      for (const Match& found : search_all(std::string_view(line).substr(pre + 5), condition))
        for (const Case& one : judged.cases)
          if (!holds(found[1], judged, one)) {
            fault(course_.judging_file(exercise),
                  "the case “{}” is outside the contract, which demands {}: narrow the domain.", one.name, found[1]);
            break;
          }
    }
  }

  /// @param condition  numbers and names with signs of comparison between, "0 < inner ≤ 2"
  static bool holds(const std::string& condition, const ExerciseReference& judged, const Case& one) {
    std::istringstream words(condition);
    std::optional<double> last;
    std::string sign;
    for (std::string word; words >> word; words >> sign) {
      std::optional<double> number;
      const auto argument = std::ranges::find(judged.arguments, word, &Argument::name);
      if (word == "π")
        number = std::numbers::pi;
      else if (std::isdigit(static_cast<unsigned char>(word[0])) != 0)
        number = std::stod(word);
      else if (argument != judged.arguments.end())
        if (const Value& value = one.inputs.at(static_cast<std::size_t>(argument - judged.arguments.begin()));
            argument->kind == Kind::number || argument->kind == Kind::integer)
          number = value.numbers[0];
      if (last && number &&
          !(sign == "<"   ? *last < *number
            : sign == ">" ? *last > *number
            : sign == "≤" ? *last <= *number
            : sign == "≥" ? *last >= *number
                          : *last != *number))
        return false;
      last = number;
    }
    return true;
  }

  /// Where anchors, examples and facts are looked for and are not.
  void check_notes(const Card& card, const LectureReference& reference) {
    const fs::path file = course_.notes_file(card);
    const std::string notes = text_of(file);
    const auto has = [&](const std::string& mark) { return notes.find(mark) != std::string::npos; };
    std::map<std::string, std::string> anchors;  // and what points there
    for (const ExerciseReference& exercise : reference.exercises) {
      for (const Misconception& each : exercise.misconceptions)
        anchors.emplace(each.notes, exercise.name + ", " + each.name);
      for (const Property& each : exercise.properties) anchors.emplace(each.notes, exercise.name + ", a property");
    }
    anchors.erase("");  // the anchor of the card
    for (const auto& [anchor, what] : anchors)
      if (!has("{#" + anchor + "}"))
        fault(file,
              "no paragraph has the anchor '{0}', to which {1} points; add {{#{0}}} to a heading, or correct the "
              "pointer.",
              anchor, what);
    check_quotes(file, notes);
    for (const int fact : card.facts)
      if (!has(fmt::format("<!-- fact {} -->", fact)))
        fault(file, "no paragraph is marked with `<!-- fact {} -->`, though the card says that the lecture teaches it.",
              fact);
  }

  /// What the notes quote, and what is wrong with its marks: regions of files. A worked example is quoted twice, its
  /// lines in brief and the whole of it.
  void check_quotes(const fs::path& notes_file, const std::string& notes) {
    const auto require_marks = [&](const fs::path& file, const std::string& region) {
      const std::string text = text_of(file), mark = "[" + region + "]";
      std::size_t marks = 0;
      for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos; at += mark.size()) ++marks;
      if (marks != 2)
        fault(notes_file, "quotes '{}' of {}, which has {} of the two marks `//! {}`; put them around the example.",
              region, course_.in_course(file), marks, mark);
    };
    constexpr const char* quotes = R"(\\snippet\s+(\S+)\s+([^\n]*\S)|\\computed\{([^,}]+),([^}]+)\})";
    for (const Match& quote : search_all(notes, quotes)) {
      if (!quote[1].empty()) require_marks(course_.lectures() / quote[1], quote[2]);
      for (const char* part : {"", " in brief"})
        if (!quote[3].empty()) require_marks(course_.lectures() / quote[3] / "worked_examples.cpp", quote[4] + part);
    }
  }

  /// A stub that is not the one its card makes, a contract that declares another
  /// function than is judged.
  void check_texts(const Exercise& exercise, const ExerciseReference& reference) {
    const std::string declared = declared_signature(course_, exercise);
    if (declared != reference.signature)
      fault(course_.contract_file(*exercise.card),
            "declares `{}`, but `{}` is judged; make contract and judging agree, names of the arguments included.",
            declared, reference.signature);
    // Where there are no solutions, the exercises belong to a student, who may have solved them.
    const fs::path stub = course_.student_file(exercise);
    if (course_.has_solutions() && text_of(stub) != stub_text(exercise, declared))
      fault(stub, "not the stub that the card makes (is it solved?); `{}` puts it back.",
            command("reset " + exercise.name()));
  }

  /// What a copy tells of a problem before it is solved is said in words: its formula is what is asked for.
  void check_words(const Exercise& exercise, const ExerciseReference& reference) {
    const auto require_words = [&](const auto& all, auto text) {
      for (const auto& each : all)
        if (const std::string& words = each.*text; search(words, in_formulas))
          fault(course_.judging_file(exercise),
                "'{}' holds a formula, and a problem leaves that to the student; say it in words.", words);
    };
    require_words(reference.terms, &Term::name);
    require_words(reference.misconceptions, &Misconception::message);
    require_words(reference.properties, &Property::message);
  }

  /// Every solution passes. Several are compiled at once.
  void require_passes(std::uint64_t seed) {
    const std::vector<Exercise>& exercises = judged_[seed];
    for (const Exercise& exercise : exercises) context_.reference(check_task(course_, exercise, seed));
    std::vector<std::string> trouble(exercises.size());
    for_each_exercise(
        exercises, std::chrono::minutes(10),
        [&](const Exercise& exercise) -> nlohmann::json {
          faults_.clear();  // those of this process
          require_pass(exercise, seed);
          return {{"faults", faults_}};
        },
        [&](std::size_t, const nlohmann::json& found) {
          for (const auto& sentence : found.at("faults")) add(sentence);
        },
        trouble);
    for (std::size_t k = 0; k < exercises.size(); ++k)
      if (!trouble[k].empty())
        fault(course_.solution_file(exercises[k]), "the solution could not be checked: {}.", trouble[k]);
  }

  /// The solution passes, and nothing is explained.
  void require_pass(const Exercise& exercise, std::uint64_t seed) {
    const fs::path file = course_.solution_file(exercise);
    const CheckResult checked = check_exercise(context_, check_task(course_, exercise, seed, file));
    if (checked.judgement.verdict != Verdict::passed)
      fault(file, "the verdict is {}, not passed: {} Correct the solution or its judging.",
            to_string(checked.judgement.verdict), checked.judgement.message);
    else if (!checked.reasons.empty())
      fault(file, "passes, and a fault is explained all the same.");
  }

  const Course& course_;
  CheckContext context_;
  const std::vector<Exercise> exercises_;
  const std::vector<std::uint64_t> seeds_;
  const bool runs_solutions_;
  std::map<std::uint64_t, std::vector<Exercise>> judged_;  ///< by seed: those whose reference results are sound
  std::string adequacy_;
  std::vector<std::string> faults_;
  std::size_t routes_ = 0;
  std::size_t misconceptions_ = 0;
};

/// "line 7, another sign: return -x"
std::string name_of(const Variant& mutant, const std::string& text) {
  const bool is_gone = mutant.kind == VariantKind::statement;
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
                          .work = 100'000'000'000,
                          .calls = 1'000'000,
                          .slow_calls = 150,
                          .compiling = std::chrono::minutes(5),
                          .one_call = std::chrono::seconds(1)});
    if (!mutants.front().edits.empty() || !runner.is_right(0))
      throw std::runtime_error("the solution itself does not pass");
    made += mutants.size() - 1;
    for (std::size_t k = 1; k < mutants.size(); ++k)
      if (runner.is_right(k)) survivors.push_back(name_of(mutants[k], solution.text));
  }
  return {{"made", made}, {"survivors", survivors}};
}

using PartOfTolerance = std::pair<double, std::string>;  ///< and where

void print_worst(const char* title, std::vector<PartOfTolerance> all) {
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(10, all.size()));
  std::ranges::partial_sort(all, end, std::ranges::greater());
  fmt::print("{} moves results by parts of their tolerances; the largest are:\n", title);
  for (auto worst = all.begin(); worst != end; ++worst) fmt::print("  {:.2g}  {}\n", worst->first, worst->second);
}

void print_worst_conditions(CheckContext& context, const std::vector<Exercise>& exercises) {
  std::vector<PartOfTolerance> all;
  for (const Exercise& exercise : exercises)
    for (const Case& one : context.reference(check_task(context.course(), exercise)).cases)
      all.emplace_back(one.condition, fmt::format("{}, {}", exercise.name(), one.name));
  print_worst("Rounding of the inputs", std::move(all));
}

/// Prints what rounding in every step does to the solutions and their other routes, beside the solutions in extended
/// precision. A fault of an exercise is what takes more than a quarter of a tolerance.
void check_rounding(const Course& course, const std::vector<Exercise>& exercises, const std::set<std::string>& lectures,
                    std::vector<std::string>& faults) {
  constexpr double most = 0.25;
  std::vector<PartOfTolerance> all;
  for (const std::string& lecture : lectures) {
    std::istringstream lines(course.rounding(lecture));
    for (std::string part, name, where;
         std::getline(lines, part, '\t') && std::getline(lines, name, '\t') && std::getline(lines, where);) {
      const auto exercise = std::ranges::find(exercises, name, &Exercise::name);
      if (exercise == exercises.end()) continue;
      all.emplace_back(std::stod(part), fmt::format("{}, {}", name, where));
      const auto k = static_cast<std::size_t>(exercise - exercises.begin());
      if (!(all.back().first <= most))
        faults[k] +=
            fmt::format("{}rounding takes {} of the tolerance at {}", faults[k].empty() ? "" : "; ", part, where);
    }
  }
  print_worst("Rounding in every step (beside extended precision)", std::move(all));
}

/// Tries bugs anew. Either writes the record of the typical ones; or compares: it must name enough points, and a bug
/// that survives needs a reason. (Which points are found first, and which bugs differ by rounding only, depends on the
/// machine.)
/// @param with_mutants  also every small change in the text of the solutions, which takes minutes for each
int self_check_bugs(const Course& course, const std::vector<Exercise>& exercises, bool writes, bool with_mutants) {
  constexpr int seeds = 3;
  std::vector<std::string> faults(exercises.size()), trouble(exercises.size()), tried(exercises.size());
  std::map<std::string, std::map<std::string, Adequacy>> records;  // by lecture
  for (const Exercise& exercise : exercises)
    records.try_emplace(exercise.lecture(), read_adequacy(course.adequacy_file(exercise.lecture())));
  CheckContext context(course);
  for (const auto& [lecture, record] : records) course.make_reference(lecture);
  const auto reference = [&](const Exercise& exercise) -> const ExerciseReference& {
    return context.reference(check_task(course, exercise));
  };
  for (const Exercise& exercise : exercises) reference(exercise);
  for_each_exercise(
      exercises, std::chrono::minutes(30),
      [&](const Exercise& exercise) {
        const fs::path start = writes ? fs::path() : course.adequacy_file(exercise.lecture());
        nlohmann::json found = {{"file", course.prove_adequacy(exercise, seeds, start).string()}};
        if (with_mutants) found["mutants"] = try_mutants(course, context.toolchain(), exercise, reference(exercise));
        return found;
      },
      [&](std::size_t k, const nlohmann::json& found) {
        const Exercise& exercise = exercises[k];
        const fs::path file = found.at("file").get<std::string>();
        const Adequacy proven = read_adequacy(file).at(exercise.name());
        fs::remove(file);
        Adequacy& recorded = records.at(exercise.lecture())[exercise.name()];
        if (writes) {
          recorded = proven;
          return;
        }
        std::vector<std::string> survivors = proven.survivors;
        if (with_mutants) {
          Adequacy mutants;
          mutants.made = found.at("mutants").at("made");
          mutants.survivors = found.at("mutants").at("survivors").get<std::vector<std::string>>();
          mutants.killed = mutants.made - mutants.survivors.size();
          tried[k] = adequacy_text(exercise, reference(exercise), mutants);
          survivors.insert(survivors.end(), mutants.survivors.begin(), mutants.survivors.end());
        }
        const auto missing = proven.neighbours.size() - recorded.neighbours.size();
        std::vector<std::string> sentences = unshown_bugs(reference(exercise), survivors);
        if (missing > 0 || proven.made != recorded.made)
          sentences.push_back(fmt::format("{} must join its cases, and {} of {} bugs are on record; `{}` records them",
                                          plural(missing, "point"), recorded.made, proven.made,
                                          command("self-check --record " + exercise.name())));
        faults[k] = fmt::format("{}", fmt::join(sentences, " "));
      },
      trouble);
  print_worst_conditions(context, exercises);
  std::set<std::string> lectures;
  for (const auto& [lecture, record] : records) lectures.insert(lecture);
  check_rounding(course, exercises, lectures, faults);
  fmt::print("{}", fmt::join(tried, ""));
  bool has_fault = false;
  for (std::size_t k = 0; k < exercises.size(); ++k) {
    if (!trouble[k].empty()) faults[k] = fmt::format("bugs could not be tried: {}", trouble[k]);
    if (faults[k].empty()) continue;
    has_fault = true;
    fmt::print("{}: {}.\n", course.in_course(course.judging_file(exercises[k])), without_full_stop(faults[k]));
  }
  if (writes)
    for (const auto& [lecture, record] : records) write_adequacy(record, course.adequacy_file(lecture));
  if (writes || !has_fault)
    fmt::print("{}: {}.\n", writes ? "Recorded" : "As recorded", plural(exercises.size(), "exercise"));
  return has_fault ? something_failed : all_passed;
}

}  // namespace

int self_check(const Course& course, const SelfCheckOptions& options) {
  if (options.prove || options.record) {
    if (!course.has_solutions())
      throw UsageError("Bugs are made in solutions, and this copy of the workbook has none.");
    return self_check_bugs(course, course.choose(options.names), options.record,
                           !options.record && !options.names.empty());
  }
  std::vector<std::uint64_t> seeds(static_cast<std::size_t>(options.seeds));
  std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
  if (!course.has_solutions()) seeds = {course.seed()};
  const std::vector<Exercise> exercises = course.choose(options.names);
  std::vector<const Card*> cards;
  for (const Card& card : course.cards()) {
    const auto is_of_card = [&](const Exercise& exercise) { return exercise.card == &card; };
    if (options.names.empty() || std::ranges::any_of(exercises, is_of_card)) cards.push_back(&card);
  }
  return SelfCheck(course, exercises, seeds, course.has_solutions() && !options.quick).run(cards);
}

}  // namespace workbook
