/// @file
/// The command line of the checker.
#include "checker/base/console.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/commands.hpp"
#include "checker/course/exam.hpp"

#include <CLI/CLI.hpp>

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>

namespace {

using namespace workbook;
namespace fs = std::filesystem;

constexpr const char* program_description =
    "The checker of the Rigid Body Workbook.\n\nIt compiles your functions, compares what they compute with reference "
    "results, and says what is wrong in the language of the lecture. Without a command it shows your progress and what "
    "is next.";

constexpr const char* program_footer = R"(Exit status:
  0  everything that was asked for passed
  1  something did not
  2  wrong usage
  3  internal error of the checker (never counted as your zero)

Environment:
  NO_COLOR        disables colour
  CLICOLOR_FORCE  colour even where the output is not a terminal
  COLUMNS         width of the output where it is not a terminal
  WORKBOOK_PLAIN  the same as --plain
  WORKBOOK_POLL   watch reads the files several times a second

Files:
  lectures/NN_topic/exercises/*.cpp  your functions
  .workbook/progress.json            your progress
  .workbook/kept/                    your versions from before a reset
  build/workbook/scratch/            plots and compiled exercises; disposable

)";

constexpr const char* students = "For students";
constexpr const char* instructors = "For instructors";
constexpr const char* authors = "For authors";

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// "--seed", "-h": every way to write an option.
std::vector<std::string> spellings(const CLI::Option* option) {
  std::vector<std::string> all;
  for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
  for (const std::string& name : option->get_snames()) all.push_back("-" + name);
  return all;
}

/// CLI11's help in lines that fit the terminal.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(std::clamp<std::size_t>(console_.width() / 3, 12, 26));
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string text;
    for (const std::string& line : lines_of(Formatter::make_help(app, std::move(name), mode))) {
      if (line.empty() && text.ends_with("\n\n")) continue;
      text += (line.starts_with("Usage") ? "\n" : "") + fitted(line) + "\n";
    }
    while (text.ends_with("\n\n")) text.pop_back();  // the versions of CLI11 end in different ways
    return text;
  }

 private:
  std::string fitted(const std::string& line) const {
    if (display_width(line) <= console_.width() || line.starts_with("  " + command(""))) return line;
    if (!line.starts_with(' ')) return console_.wrapped(line);
    // A name and after a gap what it means, side by side, or one below the other on a narrow terminal.
    const std::size_t column = get_column_width();
    const std::size_t name = line.find_first_not_of(' ');
    const std::size_t gap = name >= column ? 0 : std::min(line.find("  ", name), column - 1);
    const std::size_t end = line.find_first_of(' ', gap) == gap ? gap : line.find("  ", name);
    if (end == std::string::npos) return console_.wrapped(line, name);
    const std::string meaning = console_.wrapped(line.substr(end), column);
    return line.substr(0, end) + (end < column ? meaning.substr(end) : "\n" + meaning);
  }

  Console console_ = Console::of_standard_output();
};

/// A script for bash to source: per command its options and the names that its argument may be; else files.
std::string completion_script(const CLI::App& app, const Course& course) {
  std::string lectures;
  std::string exercises;
  for (const Card& card : course.cards()) lectures += " " + card.lecture;
  for (const Exercise& exercise : course.exercises()) exercises += " " + exercise.name();
  const std::map<std::string, std::string> arguments = {
      {"LECTURE", lectures}, {"EXERCISE", exercises}, {"NAME", exercises + lectures}};
  std::string branches;
  std::string commands = "--help --plain";
  for (const CLI::App* each : commands_of(app)) {
    commands += " " + each->get_name();
    std::string words;
    for (const CLI::Option* option : each->get_options()) {
      const auto argument = arguments.find(option->get_name());
      words += argument == arguments.end() ? fmt::format(" {}", fmt::join(spellings(option), " ")) : argument->second;
    }
    branches += fmt::format("    {}) words='{}' ;;\n", each->get_name(), words);
  }
  return fmt::format(R"(# Completion for the checker of the Rigid Body Workbook: source this file in bash.
_rigid_body_workbook() {{
  local words='{}'
  [ "$COMP_CWORD" -eq 1 ] || case ${{COMP_WORDS[1]}} in
{}  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "${{COMP_WORDS[COMP_CWORD]}}")
}}

complete -o default -F _rigid_body_workbook checker checker/run ./checker/run
)",
                     commands, branches);
}

/// What is wrong with a command line that was not understood, what was perhaps meant, and where help is.
std::string usage_sentence(const CLI::App& app, const CLI::ParseError& problem, const fs::path& course_file) {
  const bool has_command = !app.get_subcommands().empty();
  const CLI::App& parsed = has_command ? *app.get_subcommands().front() : app;
  const std::string help =
      fmt::format("`{}` shows what there is.", command((has_command ? parsed.get_name() + " " : "") + "--help"));
  const std::vector<std::string> unexpected = app.remaining(true);
  if (unexpected.empty()) return fmt::format("{}. {}", printable(problem.what()), help);
  const std::string& word = unexpected.front();
  std::string kind = "further argument", meant;
  std::vector<std::string> known;
  if (word.starts_with('-')) {
    kind = "option";
    for (const CLI::Option* option : parsed.get_options())
      for (const std::string& spelling : spellings(option)) known.push_back(spelling);
    meant = did_you_mean(word, known);
  } else if (!has_command) {
    kind = "command";
    for (const CLI::App* each : commands_of(app)) known.push_back(each->get_name());
    meant = did_you_mean(word, known);
    try {
      if (meant.empty() && !Course(course_file).find(word).empty()) meant = "check " + word;
    } catch (const std::runtime_error&) {  // neither a command nor an exercise
    }
  }
  return fmt::format("There is no {} '{}'. {}{}", kind, printable(word),
                     meant.empty() ? "" : fmt::format("Did you mean '{}'? ", meant), help);
}

/// The name for what was typed, which may be the path of an exercise's own file or of a lecture's folder. All else as
/// it is. @throws UsageError for a file that is no exercise's own
std::string known_name(const Course& course, const fs::path& typed) {
  if (typed.extension() != ".cpp") return (typed.has_filename() ? typed : typed.parent_path()).filename();
  const bool is_there = fs::exists(typed);
  if (!is_there && !typed.has_parent_path()) return typed.stem();
  if (!is_there) throw UsageError(fmt::format("There is no file {}.", printable(typed.string())));
  std::string named = "EXERCISE";
  for (const Exercise& exercise : course.exercises()) {
    if (exercise.name() != typed.stem()) continue;
    named = exercise.name();
    std::error_code ignored;
    if (fs::equivalent(typed, course.student_file(exercise), ignored)) return named;
  }
  const std::string file = printable(typed.string());
  throw UsageError(fmt::format("{} is not an exercise's own file. To check it: `{}`.", file,
                               command("check " + named + " --file " + shell_quoted(file))));
}

/// CLI11's own, whose sentence is another one in each version.
auto in_range(int least, int most) {
  return [range = CLI::Range(least, most), least, most](std::string typed) {
    return range(typed).empty() ? "" : fmt::format("{} is not between {} and {}", printable(typed), least, most);
  };
}

fs::path running_program(const char* argv0) {
  std::error_code problem;
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  return problem ? fs::canonical(argv0, problem) : program;
}

class CommandLine {
 public:
  CommandLine(int argc, char** argv) : argc_(argc), argv_(argv) {
    options_.program = running_program(argv[0]);
    options_.typed.assign(argv + 1, argv + argc);
    course_file_ = options_.program.parent_path() / "course.json";  // where the build writes it
    app_.name(command("").substr(0, command("").size() - 1));
    app_.description(program_description);
    app_.footer(program_footer + fmt::format("More about one command: {}", command("COMMAND --help")));
    app_.formatter(std::make_shared<HelpFormatter>());
    app_.require_subcommand(0, 1);
    app_.add_flag_callback(
        "--plain", [] { setenv("WORKBOOK_PLAIN", "1", 1); },
        "words in place of marks, colours and drawings, for screen readers");
    app_.add_option("--course", course_file_, "another course.json than the one that was built")
        ->type_name("FILE")
        ->group("For tests of the checker");
    declare_options();
    add_commands_of_the_exercises();
    add_commands_of_the_course();
    add_commands_of_instructors();
    add_new();
  }

  int run() {
    try {
      app_.parse(argc_, argv_);
    } catch (const CLI::ParseError& problem) {
      if (problem.get_exit_code() != 0) throw UsageError(usage_sentence(app_, problem, course_file_));
      return app_.exit(problem);  // --help
    }
    const Course course(course_file_);
    options_.seed = seed_.value_or(course.seed());
    options_.is_seed_given = seed_.has_value();
    for (std::string& name : options_.names) name = known_name(course, name);
    for (const CLI::App* typed : app_.get_subcommands())
      if (!options_.name.empty() && typed->get_name() != "exam") options_.name = known_name(course, options_.name);
    for (const CLI::App* typed : app_.get_subcommands()) {
      require_usable(course, *typed);
      require_no_exam(course, typed->get_name());
    }
    return job_(course, options_);
  }

 private:
  using Job = std::function<int(const Course&, const Options&)>;

  /// What would help with a problem of an exam is refused while it runs. @throws UsageError
  void require_no_exam(const Course& course, const std::string& command) {
    constexpr std::array helping = {"check",  "watch",   "hint",     "solution", "plot",
                                    "report", "predict", "question", "debug"};
    if (std::ranges::count(helping, command) == 0) return;
    // watch checks whatever is saved, and a hint without a name is that of the next exercise.
    const bool is_any = command == "watch" || (options_.name.empty() && command != "hint");
    if (is_any) refuse_in_exam(course, course.choose(command == "watch" ? std::vector<std::string>() : options_.names));
    if (!options_.name.empty()) refuse_in_exam(course, course.find(options_.name));
  }

  /// What a command could not use is refused before anything is built for it. @throws UsageError
  void require_usable(const Course& course, const CLI::App& command) {
    if (command.get_name() == "try" && options_.case_name) {
      if (!options_.file) throw UsageError(fmt::format("--case needs an exercise: `{}`.", workbook::command("try --case 3 EXERCISE")));
      options_.name = course.find_exercise(known_name(course, *options_.file)).name();
    }
    const auto require_file = [](const fs::path& file, const char* what) {
      std::error_code ignored;
      if (fs::exists(file, ignored) && !fs::is_directory(file, ignored)) return;
      throw UsageError(fmt::format("{} is no file: {} is meant.", printable(file.string()), what));
    };
    for (const CLI::Option* option : command.get_options()) {
      const std::string name = option->get_name();
      if (option->count() == 0) continue;
      if (name == "NAME") course.choose(options_.names.empty() ? std::vector{options_.name} : options_.names);
      if (name == "EXERCISE") course.find_exercise(options_.name);
      if (name == "LECTURE") options_.name = course.find(options_.name).front().lecture();
      if (name == "FILE" && !options_.case_name) require_file(*options_.file, "a program in C++ with main()");
      if (name == "--roster") require_file(*options_.roster, "a table in CSV");
      if (name == "--assignment") require_file(*options_.assignment, "what is graded, in JSON,");
      // A program that asks for JSON gets its document.
      if (name == "--file" && !options_.json) require_file(*options_.file, "the function of an exercise");
      if (name == "--html") require_page(options_.html);
      std::error_code ignored;
      if (name == "SUBMISSIONS" && !fs::exists(options_.submissions, ignored))
        throw UsageError(fmt::format("There is no {}.", printable(options_.submissions.string())));
      if (name == "FOLDER" || name == "--out")
        if (const std::string trouble = place_trouble(*options_.out); !trouble.empty())
          throw UsageError(fmt::format("{} cannot be written ({}); name a place that is writable.",
                                       printable(options_.out->string()), trouble));
    }
  }

  /// Every option and argument once; a command names those that it takes. Words after the first one tell apart
  /// options of one name.
  void declare_options() {
    option("NAME", "", options_.names, "exercises or lectures, by name or number; none: all");
    option("NAME of one", "", options_.name, "an exercise or a lecture");
    option("EXERCISE", "", options_.name, "its name", true);
    option("EXERCISE or next", "", options_.name, "its name; none: the one that was checked last, or else the next one, if that does not pass");
    option("LECTURES", "", options_.name, "a lecture or a range of them, 01-03; none: the exam that is running");
    option("--minutes", "NUMBER", options_.minutes, "the time; 0: what the problems take together");
    option("--seed of problems", "NUMBER", seed_, "draw the problems by this number, to get the same ones again");
    option("--finish", "", options_.finish, "grade the exam and end it");
    option("LECTURE", "", options_.name, "its name, number or topic", true);
    option("FOLDER", "", options_.out, "a new folder for the copy, or an earlier copy to --update", true);
    option("--update", "", options_.update, "bring FOLDER, an earlier copy, to a new release");
    option("--message", "TEXT", options_.message, "what is new, for the change log");
    option("FOLDER of release", "", options_.out, "the folder of the new release", true);
    option("--file", "FILE", options_.file, "check this file instead of the exercise's own");
    option("--seed", "NUMBER", seed_, "draw other random cases");
    option("--case", "CASE", options_.case_name, "show this case in full, by number or name, even if it passes");
    option("FILE or EXERCISE", "", options_.file, "a program with main(), in C++; with --case an exercise");
    option("--case try", "CASE", options_.case_name, "every variable of your function at this case, by number or name");
    option("--case debug", "CASE", options_.case_name, "stop at this case, by number or name");
    option("--build-only", "", options_.build_only, "only build the program, for an editor's debugger");
    option("PREDICTION", "", options_.predictions, "a case and the numbers of its result: '4=0 0 1.5'");
    option("ANSWER", "", options_.answer, "a, b or c; none: show the question");
    option("--started", "", options_.started, "leave out what is not started");
    option("--full", "", options_.full, "show everything: all failing cases, long lists, all compiler messages");
    option("--json", "", options_.json, "print one JSON document and nothing else");
    option("--plot", "", options_.plot, "draw your curve on the reference, as SVG and PNG");
    option("--all hints", "", options_.all, "show all three");
    option("--all mistakes", "", options_.all, "name every mistake that a prediction does not show, not three");
    option("--now", "", options_.now, "even though yours does not pass yet");
    option("--all plots", "", options_.all, "all plots, and the figures of every lecture");
    option("--wrong", "NAME", options_.wrong, "this wrong answer of the judging beside the solution, for a lecture");
    option("--out", "FOLDER", options_.out, "the folder for the pictures");
    option("--seconds", "NUMBER", options_.seconds_per_figure, "time limit of one figure");
    option("--html", "FILE", options_.html, "the page to write; an older one is replaced", true);
    option("--name", "TEXT", options_.student, "whose page it is");
    option("SYSTEM", "", options_.name, "gradescope, autolab, prairielearn or classroom50", true);
    option("--out archive", "FILE", options_.out, "the file to write: zip or tar, as its name ends", true);
    option("--image", "NAME", options_.image, "the image with the workbook, where a system takes one");
    option("SUBMISSIONS", "", options_.submissions, "what was handed in: a folder or a zip file", true);
    option("--out class", "FOLDER", options_.out, "the folder for all results; the next run goes on in it");
    option("--who", "", options_.who, "only say who has handed in what: nothing is judged or written");
    option("--roster", "FILE", options_.roster, "CSV with the column id, or the table of a learning system");
    option("--assignment", "FILE", options_.assignment, "JSON: what is graded and what it is worth");
    option("--overrides", "FILE", options_.overrides, "CSV: points, excuses, due dates and comments by hand");
    option("--attempts", "WHICH", options_.attempts, "last or best: each folder in a student's is an attempt");
    option("--reference", "FILE", options_.references, "judge by these reference results, made before, of one seed");
    option("--only", "VERDICT", options_.only, "judge once more what had this verdict, wrong_value for example");
    option("--shard", "K/N", options_.shard, "only judge the K-th of N parts of the class; --merge joins them");
    option("--merge", "FOLDER", options_.merged, "take over what was judged in these folders, of parts for example");
    option("--copy", "FOLDER", options_.copy, "the copy that students have, if it was drawn with a seed of its own");
    option("--with-missing", "", options_.with_missing, "rows of all students in the tables, whatever was not read");
    option("--explain-minutes", "NUMBER", options_.explain_minutes,
           "of each student's submission, for the reasons of failures");
    option("--allow-reduced", "", options_.allow_reduced, "be content with the sandbox that `doctor` calls reduced");
    option("--seeds", "NUMBER", options_.seeds, "how many seeds to try, from 1 on, at most 1000");
    option("--mutants", "", options_.mutants, "try small bugs in the solutions instead: do the cases find all?");
    option("--prove", "", options_.prove, "try typical bugs anew at all cases and compare with the record");
    option("--record", "", options_.record, "try them and write the record, judging/adequacy.json");
    declared_["--picture"] = [this](CLI::App& command) {
      static const std::map<std::string, PictureKind> kinds = {{"auto", PictureKind::automatic},
                                                               {"text", PictureKind::text},
                                                               {"none", PictureKind::none}};
      command.add_option("--picture", options_.picture, "the plot on the terminal: auto (if not given), text or none")
          ->transform(CLI::Transformer(kinds).description(""))
          ->transform(CLI::IsMember(kinds).description(""))
          ->type_name("KIND");
    };
  }

  void add_commands_of_the_exercises() {
    add("check", students,
        "Grade exercises and explain what is wrong\n\nCompiles each exercise, runs it in a process of its own on the "
        "cases of the reference results, and compares. A failure is explained as far as the reason is certain, with "
        "where to read; then come the inputs, the expected value and yours for the first failing case. Verdicts on "
        "the exercise's own file without --seed are saved as your progress.",
        {"check inertia_of_points", "check 3", "check 03 --started", "check inertia_of_points --case 2",
         "check inertia_of_points --file draft.cpp --plot", "check --seed 7 --json"},
        {"NAME", "--file", "--seed", "--case", "--started", "--full", "--json", "--plot", "--picture"}, check);
    add("watch", students,
        "Check every file as you save it\n\nStarts at the next exercise, or at the one that is named, and waits. Each "
        "time an exercise file is saved, its verdict replaces the one before; when it passes, the next exercise is "
        "shown. Keys: h hint, l list, p plot, n next, c all compiler messages, r check again, q quit.",
        {"watch", "watch 03", "watch inertia_of_points"}, {"NAME of one"}, watch);
    add("list", students, "Show every exercise with its state", {}, {}, list);
    add("hint", students,
        "Show the next hint of an exercise\n\nEvery exercise has three hints, weakest first. Each call shows one more; "
        "the last one stays. Without a name: the exercise that was checked last, or else the next one that does not pass.",
        {"hint", "hint inertia_of_points", "hint inertia_of_points --all"}, {"EXERCISE or next", "--all hints"}, hint);
    add("solution", students,
        "Show the solution of an exercise that passes\n\nAnd where another route, or the derivation, is to be read.",
        {"solution inertia_of_points"}, {"EXERCISE", "--now"}, solution);
    add("plot", students,
        "Draw your curve on the reference\n\nWrites an SVG and a PNG with your curve on the reference and the "
        "difference below, and shows the picture in the terminal: as graphics where chafa is installed and the "
        "terminal can show them, else as text. For instructors: --all --out DIR draws every exercise and copies every figure of the "
        "lectures, and --wrong draws a wrong answer, by its name in judging/, beside the solution.",
        {"plot inertia_of_points", "plot 03", "plot inertia_of_points --wrong plus_dyad", "plot --all --out pictures"},
        {"NAME", "--all plots", "--wrong", "--file", "--out", "--seed", "--picture"}, plot);
    add("report", students,
        "Write one page about your work, to hand in or to read\n\nThe page needs no other file: verdicts, reasons, "
        "plots, your files, and what to read next.",
        {"report --html report.html", "report --html inertia.html 03 --name 'YOUR NAME'"},
        {"NAME", "--html", "--name", "--file", "--seed"}, report);
    add("reset", students,
        "Put an exercise back to the beginning\n\nYour version is kept in the folder .workbook/kept.",
        {"reset inertia_of_points"}, {"EXERCISE"}, reset);
  }

  void add_commands_of_the_course() {
    add("figures", students,
        "Redraw the figures of a lecture with your own functions\n\nA figure that needs a function you have not "
        "started is left out, and the function is named.",
        {"figures 03"}, {"LECTURE", "--out", "--seconds"}, figures)
        .get_option("--seconds")
        ->check(in_range(1, 3600));
    add("live", students,
        "Build the live figures of a lecture on your own functions\n\nThe figures that move take those of your functions "
        "that pass, instead of computing the same themselves. They are compiled for the browser, which needs the package "
        "emscripten; then open one of the pages that are named.",
        {"live 06"}, {"LECTURE"}, live);
    add("examples", students,
        "Run the worked examples of a lecture on your own functions\n\nShows which of them hold, which need a function "
        "that is not started, and for the others the check that failed, with both numbers.",
        {"examples 03"}, {"LECTURE"}, examples);
    add("try", students,
        "Run a program of your own that calls your functions\n\nWithout a file it is lectures/try.cpp, which the first "
        "time is written for you. Only the functions that it names are compiled with it. With --case it shows every "
        "variable of your function at this case, line by line, and the result beside the expected one; that needs gdb.",
        {"try", "try drafts/spin.cpp", "try --case 3 euler_equations"}, {"FILE or EXERCISE", "--case try"}, try_out);
    add("debug", students,
        "Step through your function with gdb\n\nStops where your function begins, at the first case that fails, or at "
        "the given one. Vectors and matrices are shown as numbers, and computed with as in C++: `info args`, `next`, `print 2*I*omega`, "
        "`print I(0,1)`, `print omega.dot(L)`. At the end of the case stand the expected result and yours.",
        {"debug euler_equations", "debug euler_equations --case 4"}, {"EXERCISE", "--case debug", "--build-only"},
        debug);
    add("predict", students,
        "Say what a function will return before you write it\n\nWithout predictions it shows cases to choose from. "
        "Each prediction is judged, and the wrong functions that would agree with all of them are told: examples are "
        "good that can tell these from the right one.",
        {"predict euler_equations", "predict euler_equations '1=0 0 0' '4=0.1 -0.2 0'"}, {"EXERCISE", "PREDICTION", "--all mistakes"},
        predict);
    add("question", students,
        "Answer a question on an exercise that passes\n\nShows what another function returned, and three mistakes, one "
        "of which it made. Your first answer is kept for the report page.",
        {"question euler_equations", "question euler_equations b"}, {"EXERCISE", "ANSWER"}, question);
    add("review", students,
        "Write an exercise of an earlier lecture once more\n\nOne that is due: after 1, 3, 7, 21 and 60 days. It comes "
        "with an empty file and other cases; `review` again checks it. The first verdict is kept beside the others.",
        {"review"}, {}, review);
    add("exam", students,
        "Draw an exam of six problems that you have not seen, and grade it\n\nThe problems come from the lectures that "
        "you name. Until they are graded there are no hints, checks, plots or solutions of them. Without an argument it "
        "shows the problems and the time that is left; --finish grades what is written by then.",
        {"exam 01-03", "exam 09 --minutes 90", "exam", "exam --finish"},
        {"LECTURES", "--minutes", "--finish", "--seed of problems"}, exam)
        .get_option("--minutes")
        ->check(in_range(0, 1440));
    add("update", students,
        "Bring your copy of the workbook to a new release\n\nFOLDER is the newer copy, unpacked somewhere else. Exercises "
        "that you have begun and files of your own stay as they are; another file that you have changed is kept under "
        ".workbook/kept. What has changed is printed.",
        {"update ../phy711-release-2"}, {"FOLDER of release"}, update);
    add("prepare", students,
        "Build all that is otherwise built when it is first needed\n\nReference results, the commands, the notes, and "
        "the examples and figures of all lectures: before a journey, for example. It takes minutes.",
        {"prepare"}, {}, prepare);
    add("doctor", students, "Check what is installed and writable on this machine", {}, {"--json"}, doctor);
    add("completion", students, "Print a script that lets bash complete commands, options and names", {}, {},
        [this](const Course& course, const Options&) {
          fmt::print("{}", completion_script(app_, course));
          return static_cast<int>(all_passed);
        })
        .footer(fmt::format("Put this line into ~/.bashrc, with the path of your workbook:\n  source <({})",
                            command("completion")));
  }

  void add_commands_of_instructors() {
    add("handout", instructors,
        "Write the copy of the workbook that students get\n\nThe copy has no solutions: reference results, printed "
        "numbers and figures are data, and every exercise is back at the beginning. Students type the same commands "
        "in it. With --seed all random cases are others, this year's for example. With --update an earlier copy "
        "becomes the next release, with a change log; students get it by `update`.",
        {"handout ../phy711-students", "handout ../phy711-2027 --seed 2027 --assignment week3.json",
         "handout ../phy711-2027 --update --message 'Hints of lecture 03 corrected'"},
        {"FOLDER", "--update", "--message", "--seed", "--assignment"}, handout);
    add("grade", instructors,
        "Grade a class\n\nSUBMISSIONS is what Gradescope, Moodle, Canvas or GitHub Classroom export, or holds a folder or "
        "a zip file per student, or files called ID_EXERCISE.cpp. Only files with the names of exercises are read. The "
        "roster may be a table of your own, Moodle's grading worksheet, which is written back with marks and comments, "
        "or the gradebook of Canvas. FOLDER gets class.html, class.json, tables for spreadsheets, Moodle and Canvas, and "
        "for every student a page, JSON, and results for other autograders. What is judged is kept there: a run that was stopped goes on, and of a class that was "
        "graded before only what is new is judged; whose mark has changed, and why, is printed. The first run draws "
        "cases that nobody knows, unless --seed says which; FOLDER keeps them for the next.",
        {"grade submissions --out grades", "grade submissions --who --roster class.csv", "grade week3.zip --out week3 --roster class.csv --assignment week3.json",
         "grade submissions --out part1 --shard 1/2 --seed 740296",
         "grade submissions --out grades --merge part1 part2"},
        {"SUBMISSIONS", "--out class", "--who", "--roster", "--assignment", "--overrides", "--attempts", "--seed", "--copy", "--reference", "--only",
         "--with-missing", "--shard", "--merge", "--explain-minutes", "--allow-reduced"},
        grade)
        .get_option("--reference")
        ->excludes("--seed");
    add("export", instructors,
        "Write what another system needs to grade an assignment itself\n\nFor Gradescope an autograder, for Autolab an "
        "assessment, for PrairieLearn a question, for Classroom 50 an autograder: with cases of their own, which are "
        "drawn anew unless --seed says which, and no solutions. What to do with it is printed.",
        {"export gradescope --assignment week3.json --out week3.zip",
         "export autolab --assignment week3.json --out week3.tar --image registry.example.org/workbook"},
        {"SYSTEM", "--out archive", "--assignment", "--seed", "--image"}, export_recipe);
    add("self-check", authors,
        "Check the workbook itself\n\nTries every stub, solution, right route, wrong answer, hint and pointer of the "
        "course, and names the file and the fix for everything that is wrong.",
        {"self-check --seeds 20", "self-check 03", "self-check --mutants 03", "self-check --record slow_precession"},
        {"NAME", "--seeds", "--mutants", "--prove", "--record"}, self_check)
        .get_option("--seeds")
        ->check(in_range(1, 1000));
  }

  void add_new() {
    CLI::App& added = *app_.add_subcommand("new", "Write the skeleton of a lecture or of an exercise")->group(authors);
    added.require_subcommand(1)->fallthrough();
    added.footer(
        fmt::format("The skeleton builds at once; `{}` says what remains to be written. The page for authors in "
                    "the notes walks through one exercise.\n\nExamples:\n  {}\n  {}",
                    command("self-check NAME"), command("new lecture 09_gyroscopes"),
                    command("new exercise precession_rate --lecture 09 --signature "
                            "'double precession_rate(const Vector3d& L, double torque)'")));
    const auto required = [](CLI::App* to, const char* name, const char* type, std::string& target, const char* help) {
      to->add_option(name, target, help)->required()->type_name(type);
    };
    CLI::App* lecture = added.add_subcommand("lecture", "Write the skeleton of a lecture");
    required(lecture, "folder", "FOLDER", options_.new_name, "NN_topic; the number says where in the course it stands");
    lecture->callback([this] { job_ = new_lecture; });
    CLI::App* exercise = added.add_subcommand("exercise", "Write the skeleton of an exercise");
    required(exercise, "name", "NAME", options_.new_name, "the name of its function");
    required(exercise, "--lecture", "LECTURE", options_.new_lecture, "its lecture");
    required(exercise, "--signature", "TEXT", options_.signature,
             "its declaration: 'Vector3d f(const Matrix3d& I, double t)'");
    exercise->callback([this] { job_ = new_exercise; });
  }

  /// @param help  its first line stands in the list of commands, the rest below the options
  CLI::App& add(const std::string& name, const char* group, const std::string& help,
                const std::vector<std::string>& examples, const std::vector<std::string>& options, const Job& job) {
    const std::size_t first_line = std::min(help.find('\n'), help.size());
    CLI::App& added = *app_.add_subcommand(name, help.substr(0, first_line))->group(group);
    added.fallthrough();  // --plain may follow the command
    std::string footer = help.substr(std::min(first_line + 2, help.size())) + (examples.empty() ? "" : "\n\nExamples:");
    for (const std::string& example : examples) footer += "\n  " + command(example);
    added.footer(footer);
    for (const std::string& option : options) declared_.at(option)(added);
    added.callback([this, job] { job_ = job; });
    return added;
  }

  template <class T>
  void option(const std::string& key, const char* type, T& target, const char* help, bool required = false) {
    declared_[key] = [=, &target, name = key.substr(0, key.find(' '))](CLI::App& command) {
      if constexpr (std::is_same_v<T, bool>) {
        command.add_flag(name, target, help);
      } else {
        // The versions of CLI11 write defaults in different ways.
        std::string text = help;
        if constexpr (std::is_arithmetic_v<T>) text += fmt::format(" ({} if not given)", target);
        CLI::Option* added = command.add_option(name, target, text)->type_name(type)->required(required);
        // CLI11 takes -1, and all that is too large, for the largest number.
        if constexpr (std::is_same_v<T, std::optional<std::uint64_t>>)
          added->check([](const std::string& typed) {
            std::uint64_t number = 0;
            const auto [end, problem] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
            const bool is_read = problem == std::errc() && end == typed.data() + typed.size();
            return is_read ? "" : fmt::format("{} is no whole number from 0 to 2⁶⁴ − 1", printable(typed));
          });
      }
    };
  }

  int argc_;
  char** argv_;
  CLI::App app_;
  fs::path course_file_;
  Options options_;
  std::optional<std::uint64_t> seed_;
  std::map<std::string, std::function<void(CLI::App&)>> declared_;
  Job job_ = status;
};

/// A standard stream that is closed would lend its number to the next file or worker, which would then get what is
/// meant for people. In its place comes one that cannot be written to.
void occupy_standard_descriptors() {
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) ::close(descriptor);
}

int run(int argc, char** argv) {
  const auto fail = [](const std::exception& problem, ExitStatus status) {
    const bool is_read_by_people = isatty(STDERR_FILENO) != 0;
    fmt::print(stderr, "{}\n",
               is_read_by_people ? Console::of_standard_error().wrapped(problem.what()) : problem.what());
    return status;
  };
  try {
    return CommandLine(argc, argv).run();
  } catch (const UsageError& problem) {
    return fail(problem, wrong_usage);
  } catch (const std::exception& problem) {
    return fail(problem, checker_failed);
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_descriptors();
  std::signal(SIGPIPE, SIG_IGN);  // a worker that dies, or a reader like `head` that leaves, is no reason to die
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is one that cannot be written, which is told
  const int status = run(argc, argv);
  if (std::fflush(stdout) == 0 || errno == EPIPE) return status;
  fmt::print(stderr, "The output could not be written ({}).\n", std::generic_category().message(errno));
  return checker_failed;
}
