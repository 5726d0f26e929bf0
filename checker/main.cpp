/// @file
/// The command line of the checker.
#include "checker/commands/commands.hpp"
#include "checker/messages/help.hpp"
#include "checker/messages/program.hpp"
#include "checker/report/completion_script.hpp"
#include "checker/report/console.hpp"
#include "checker/report/help_formatter.hpp"
#include "checker/worker/running_programs.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace workbook;
namespace fs = std::filesystem;

/// The build writes course.json beside the program.
fs::path course_file_beside_the_program(const char* argv0) {
  std::error_code problem;
  fs::path program = fs::read_symlink("/proc/self/exe", problem);
  if (problem) program = fs::canonical(argv0, problem);
  return program.parent_path() / "course.json";
}

/// What the command line asks for, to be done once the course is read.
using Job = std::function<int(const Course&)>;

struct CommandLine {
  explicit CommandLine(const char* argv0) : course_file(course_file_beside_the_program(argv0)) {
    app.name(messages::program_name());
    app.description(messages::program_description());
    app.footer(messages::program_footer());
    app.formatter(std::make_shared<HelpFormatter>(Console::of_standard_output()));
    app.require_subcommand(0, 1);
    app.add_flag_callback(
        "--plain", [] { setenv("WORKBOOK_PLAIN", "1", 1); },
        "words in place of marks, colours and drawings, for screen readers");
    app.add_option("--course", course_file,
                   "another course.json than the one that was built (for tests of the checker)")
        ->type_name("FILE")
        ->group(messages::for_tests());
    add_check();
    add_watch();
    add_list();
    add_hint();
    add_plot();
    add_figures();
    add_report();
    add_reset();
    add_examples();
    add_handout();
    add_doctor();
    add_completion();
    add_self_check();
  }

  void add_check() {
    CLI::App* command = add_command("check", messages::for_students());
    command->add_option("name", check_options.names, "exercises or lectures, by name or number; none: the whole course")
        ->type_name("NAME");
    command->add_option("--file", file, "check this file in place of the exercise's own")->type_name("FILE");
    command->add_option("--seed", check_options.seed, "draws other random cases")
        ->type_name("NUMBER")
        ->capture_default_str();
    command->add_option("--case", check_options.case_name, "show this case in full, whether it passes or not")
        ->type_name("CASE");
    command->add_flag("--started", check_options.started, "leave out what is not started");
    command->add_flag("--full", check_options.full, "show all that the compiler says, not only its first error");
    command->add_flag("--json", check_options.json, "print one JSON document and nothing else");
    command->add_flag("--plot", check_options.plot, "draw your curve on the reference, as SVG and PNG");
    add_picture(command, check_options.picture);
    command->callback([this] {
      check_options.file = optional_path(file);
      job = [this](const Course& course) { return check(course, check_options); };
    });
  }

  void add_watch() {
    CLI::App* command = add_command("watch", messages::for_students());
    command->add_option("name", name, "where to begin: an exercise or a lecture; none: the next exercise")
        ->type_name("NAME");
    command->callback([this] { job = [this](const Course& course) { return watch(course, course_file, name); }; });
  }

  void add_list() {
    add_command("list", messages::for_students())->callback([this] { job = list; });
  }

  void add_hint() {
    CLI::App* command = add_command("hint", messages::for_students());
    command->add_option("exercise", name, "its name")->required()->type_name("EXERCISE");
    command->add_flag("--all", all, "show all hints at once");
    command->callback([this] { job = [this](const Course& course) { return hint(course, name, all); }; });
  }

  void add_plot() {
    CLI::App* command = add_command("plot", messages::for_students());
    command->add_option("name", plot_options.names, "exercises or lectures")->type_name("NAME");
    command->add_flag("--all", plot_options.all, "every exercise, and the figures of every lecture");
    command->add_option("--file", file, "use this file in place of the exercise's own")->type_name("FILE");
    command->add_option("--out", out, "the folder for the pictures")->type_name("FOLDER");
    command->add_option("--seed", plot_options.seed, "as for check")->type_name("NUMBER")->capture_default_str();
    add_picture(command, plot_options.picture);
    command->callback([this] {
      plot_options.file = optional_path(file);
      plot_options.out = optional_path(out);
      job = [this](const Course& course) { return plot(course, plot_options); };
    });
  }

  void add_figures() {
    CLI::App* command = add_command("figures", messages::for_students());
    command->add_option("lecture", figures_options.lecture, "its name, number or topic")
        ->required()
        ->type_name("LECTURE");
    command->add_option("--out", out, "the folder for the pictures")->type_name("FOLDER");
    command->add_option("--seconds", figures_options.seconds_per_figure, "the most that one figure may take")
        ->type_name("NUMBER")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->callback([this] {
      figures_options.out = optional_path(out);
      job = [this](const Course& course) { return figures(course, figures_options); };
    });
  }

  void add_report() {
    CLI::App* command = add_command("report", messages::for_students());
    command->add_option("--html", html, "the page to write; an older one is replaced")->required()->type_name("FILE");
    command
        ->add_option("names", report_options.names, "exercises or lectures, by name or number; none: the whole course")
        ->type_name("NAME");
    command->add_option("--name", report_options.student, "whose page it is")->type_name("TEXT");
    command->add_option("--file", file, "check this file in place of the exercise's own")->type_name("FILE");
    command->add_option("--seed", report_options.seed, "as for check")->type_name("NUMBER")->capture_default_str();
    command->callback([this] {
      report_options.html = html;
      report_options.file = optional_path(file);
      job = [this](const Course& course) { return report(course, report_options); };
    });
  }

  static void add_picture(CLI::App* command, PictureKind& picture) {
    static const std::map<std::string, PictureKind> kinds = {{"auto", PictureKind::automatic},
                                                             {"kitty", PictureKind::kitty},
                                                             {"sixel", PictureKind::sixel},
                                                             {"text", PictureKind::text},
                                                             {"none", PictureKind::none}};
    command->add_option("--picture", picture, "how to show the plot on the terminal")
        ->transform(CLI::CheckedTransformer(kinds).description("{auto,kitty,sixel,text,none}"))
        ->default_str("auto");
  }

  void add_reset() {
    CLI::App* command = add_command("reset", messages::for_students());
    command->add_option("exercise", name, "its name")->required()->type_name("EXERCISE");
    command->callback([this] { job = [this](const Course& course) { return reset(course, name); }; });
  }

  void add_examples() {
    CLI::App* command = add_command("examples", messages::for_students());
    command->add_option("lecture", name, "its name, number or topic")->required()->type_name("LECTURE");
    command->callback([this] { job = [this](const Course& course) { return examples(course, name); }; });
  }

  void add_handout() {
    CLI::App* command = add_command("handout", messages::for_instructors());
    command->add_option("folder", out, "a new folder for it")->required()->type_name("FOLDER");
    command->callback([this] { job = [this](const Course& course) { return handout(course, out); }; });
  }

  void add_doctor() {
    add_command("doctor", messages::for_students())->callback([this] { job = doctor; });
  }

  void add_self_check() {
    CLI::App* command = add_command("self-check", messages::for_authors());
    command->add_option("--seeds", seed_count, "how many seeds to try, from 1 on")
        ->capture_default_str()
        ->check(CLI::Range(1, 1000));
    command->callback([this] {
      job = [this](const Course& course) {
        std::vector<std::uint64_t> seeds;
        for (int seed = 1; seed <= seed_count; ++seed) seeds.push_back(static_cast<std::uint64_t>(seed));
        return self_check(course, seeds);
      };
    });
  }

  void add_completion() {
    add_command("completion", messages::for_students())->callback([this] {
      job = [this](const Course& course) {
        std::vector<std::string> exercises;
        std::vector<std::string> lectures;
        for (const Card& card : course.cards()) lectures.push_back(card.lecture);
        for (const Exercise& exercise : course.exercises()) exercises.push_back(exercise.name());
        fmt::print("{}", completion_script(app, exercises, lectures));
        return static_cast<int>(all_passed);
      };
    });
  }

  /// A command with the help that belongs to its name.
  CLI::App* add_command(const std::string& command_name, const std::string& group) {
    const messages::CommandHelp& help = messages::help_of(command_name);
    CLI::App* command = app.add_subcommand(command_name, help.description);
    command->group(group);
    command->fallthrough();  // --plain may stand behind the command as well
    command->footer(messages::examples_of(help));
    return command;
  }

  static std::optional<fs::path> optional_path(const std::string& text) {
    if (text.empty()) return std::nullopt;
    return fs::path(text);
  }

  CLI::App app;
  fs::path course_file;
  Job job = status;

 private:
  CheckOptions check_options;
  PlotOptions plot_options;
  FiguresOptions figures_options;
  ReportOptions report_options;
  std::string html;
  std::string file;
  std::string out;
  std::string name;
  bool all = false;
  int seed_count = 3;
};

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a worker that dies, or a reader like `head` that leaves, is no reason to die
  running_programs::end_with_the_checker();
  CommandLine command_line(argv[0]);
  try {
    command_line.app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    const bool asked_for_help = problem.get_exit_code() == 0;
    command_line.app.exit(problem);
    return asked_for_help ? all_passed : wrong_usage;
  }
  try {
    return command_line.job(Course(command_line.course_file));
  } catch (const UnknownName& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return wrong_usage;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return checker_failed;
  }
}
