/// @file
/// The command line of the checker.
#include "checker/base/console.hpp"
#include "checker/base/text.hpp"
#include "checker/commands/command.hpp"

#include <CLI/CLI.hpp>

#include <fcntl.h>

#include <algorithm>
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

/// CLI11's own, whose sentence is another one in each version.
auto in_range(int least, int most) {
  return [least, most](std::string typed) {
    return CLI::Range(least, most)(typed).empty()
               ? ""
               : fmt::format("{} is not between {} and {}", printable(typed), least, most);
  };
}

/// CLI11 takes -1, and all that is too large, for the largest number.
std::string trouble_of_number(const std::string& typed) {
  std::uint64_t number = 0;
  const auto [end, problem] = std::from_chars(typed.data(), typed.data() + typed.size(), number);
  const bool is_read = problem == std::errc() && end == typed.data() + typed.size();
  return is_read ? "" : fmt::format("{} is no whole number from 0 to 2⁶⁴ − 1", printable(typed));
}

class CommandLine {
 public:
  CommandLine() {
    course_file_ = fs::read_symlink("/proc/self/exe").parent_path() / "course.json";  // where the build writes it
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
    Command completion{"completion",
                       students,
                       "Print a script that lets bash complete commands, options and names\n\nPut this line into "
                       "~/.bashrc, with the path of your workbook:\n  source <(" +
                           command("completion") + ")",
                       {},
                       {},
                       [this](const Course& course) {
                         fmt::print("{}", completion_script(app_, course));
                         return static_cast<int>(all_passed);
                       }};
    // In the order of the help.
    for (const Command& each :
         {check_command(),    watch_command(),   list_command(),   hint_command(),    solution_command(),
          plot_command(),     report_command(),  reset_command(),  figures_command(), live_command(),
          examples_command(), try_command(),     debug_command(),  predict_command(), question_command(),
          review_command(),   exam_command(),    update_command(), prepare_command(), doctor_command(),
          completion,         handout_command(), grade_command(),  export_command(),  self_check_command()})
      add(app_, each, each.name).group(each.group);
    CLI::App& added = *app_.add_subcommand("new", "Write the skeleton of a lecture or of an exercise")->group(authors);
    added.require_subcommand(1)->fallthrough();
    added.footer(
        fmt::format("The skeleton builds at once; `{}` says what remains to be written. The page for authors in "
                    "the notes walks through one exercise.\n\nExamples:\n  {}\n  {}",
                    command("self-check NAME"), command("new lecture 09_gyroscopes"),
                    command("new exercise precession_rate --lecture 09 --signature "
                            "'double precession_rate(const Vector3d& L, double torque)'")));
    add(added, new_lecture_command(), "lecture");
    add(added, new_exercise_command(), "exercise");
  }

  int run(int argc, char** argv) {
    if (std::any_of(argv + 1, argv + argc, [](const char* typed) { return *typed == '\0'; }))
      throw UsageError(fmt::format("An argument is empty. `{}` shows what there is.", command("--help")));
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
      if (problem.get_exit_code() != 0) throw UsageError(usage_sentence(app_, problem, course_file_));
      return app_.exit(problem);  // --help
    }
    const Course course = read_course();
    for (const auto& [option, require] : requirements_)
      if (option->count() > 0) require(course);
    if (typed_.require) typed_.require(course);
    return typed_.run(course);
  }

 private:
  /// @throws UsageError where --course names a file that describes none: the built one is ours, that one is not
  Course read_course() const {
    try {
      return Course(course_file_);
    } catch (const CourseFileError& problem) {
      if (app_.count("--course") == 0) throw;
      throw UsageError(problem.what());
    }
  }

  CLI::App& add(CLI::App& to, const Command& added, const std::string& name) {
    const std::size_t first_line = std::min(added.help.find('\n'), added.help.size());
    CLI::App& app = *to.add_subcommand(name, added.help.substr(0, first_line));
    app.fallthrough();  // --plain may follow the command
    std::string footer = added.help.substr(std::min(first_line + 2, added.help.size()));
    if (!added.examples.empty()) footer += "\n\nExamples:";
    for (const std::string& example : added.examples) footer += "\n  " + command(example);
    app.footer(footer);
    for (const Parameter& parameter : added.parameters) add(app, parameter);
    app.callback([this, added] { typed_ = added; });
    return app;
  }

  void add(CLI::App& to, const Parameter& parameter) {
    CLI::Option* const option = std::visit(
        [&]<class T>(T* target) {
          if constexpr (std::is_same_v<T, bool>) {
            return to.add_flag(parameter.name, *target, parameter.help);
          } else {
            // The versions of CLI11 write defaults in different ways.
            std::string help = parameter.help;
            if constexpr (std::is_arithmetic_v<T>) help += fmt::format(" ({} if not given)", *target);
            CLI::Option* const added = to.add_option(parameter.name, *target, help)->type_name(parameter.type);
            if constexpr (std::is_same_v<T, std::optional<std::uint64_t>>) added->check(trouble_of_number);
            return added;
          }
        },
        parameter.target);
    option->required(parameter.is_required);
    if (const auto [least, most] = parameter.range; least < most) option->check(in_range(least, most));
    if (*parameter.excludes != '\0') option->excludes(parameter.excludes);
    if (parameter.require) requirements_.emplace_back(option, parameter.require);
  }

  CLI::App app_;
  fs::path course_file_;
  std::vector<std::pair<const CLI::Option*, Requirement>> requirements_;
  Command typed_{.name = "", .group = students, .help = "", .examples = {}, .parameters = {}, .run = status};
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
    return CommandLine().run(argc, argv);
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
