/// @file
/// The command line of the checker.
#include "checker/base/process_registry.hpp"
#include "checker/commands/commands.hpp"
#include "checker/messages/help.hpp"
#include "checker/messages/program.hpp"
#include "checker/report/completion_script.hpp"
#include "checker/report/console.hpp"
#include "checker/report/help_formatter.hpp"

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
        "--plain", [] { setenv("WORKBOOK_PLAIN", "1", 1); }, messages::option_help("--plain"));
    app.add_option("--course", course_file, messages::option_help("--course"))
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
    command->add_option("name", check_options.names, messages::option_help("name"))->type_name("NAME");
    command->add_option("--file", file, messages::option_help("--file"))->type_name("FILE");
    command->add_option("--seed", check_options.seed, messages::option_help("--seed"))
        ->type_name("NUMBER")
        ->capture_default_str();
    command->add_option("--case", check_options.case_name, messages::option_help("--case"))->type_name("CASE");
    command->add_flag("--started", check_options.started, messages::option_help("--started"));
    command->add_flag("--full", check_options.full, messages::option_help("--full"));
    command->add_flag("--json", check_options.json, messages::option_help("--json"));
    command->add_flag("--plot", check_options.plot, messages::option_help("--plot"));
    add_picture(command, check_options.picture);
    command->callback([this] {
      check_options.file = optional_path(file);
      job = [this](const Course& course) { return check(course, check_options); };
    });
  }

  void add_watch() {
    CLI::App* command = add_command("watch", messages::for_students());
    command->add_option("name", name, messages::option_help("name"))->type_name("NAME");
    command->callback([this] { job = [this](const Course& course) { return watch(course, course_file, name); }; });
  }

  void add_list() {
    add_command("list", messages::for_students())->callback([this] { job = list; });
  }

  void add_hint() {
    CLI::App* command = add_command("hint", messages::for_students());
    command->add_option("exercise", name, messages::option_help("exercise"))->required()->type_name("EXERCISE");
    command->add_flag("--all", all, messages::option_help("--all"));
    command->callback([this] { job = [this](const Course& course) { return hint(course, name, all); }; });
  }

  void add_plot() {
    CLI::App* command = add_command("plot", messages::for_students());
    command->add_option("name", plot_options.names, messages::option_help("name"))->type_name("NAME");
    command->add_flag("--all", plot_options.all, messages::option_help("--all"));
    command->add_option("--file", file, messages::option_help("--file"))->type_name("FILE");
    command->add_option("--out", out, messages::option_help("--out"))->type_name("FOLDER");
    command->add_option("--seed", plot_options.seed, messages::option_help("--seed"))
        ->type_name("NUMBER")
        ->capture_default_str();
    add_picture(command, plot_options.picture);
    command->callback([this] {
      plot_options.file = optional_path(file);
      plot_options.out = optional_path(out);
      job = [this](const Course& course) { return plot(course, plot_options); };
    });
  }

  void add_figures() {
    CLI::App* command = add_command("figures", messages::for_students());
    command->add_option("lecture", figures_options.lecture, messages::option_help("lecture"))
        ->required()
        ->type_name("LECTURE");
    command->add_option("--out", out, messages::option_help("--out"))->type_name("FOLDER");
    command->add_option("--seconds", figures_options.seconds_per_figure, messages::option_help("--seconds"))
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
    command->add_option("--html", html, messages::option_help("--html"))->required()->type_name("FILE");
    command->add_option("name", report_options.names, messages::option_help("name"))->type_name("NAME");
    command->add_option("--name", report_options.student, messages::option_help("--name"))->type_name("TEXT");
    command->add_option("--file", file, messages::option_help("--file"))->type_name("FILE");
    command->add_option("--seed", report_options.seed, messages::option_help("--seed"))
        ->type_name("NUMBER")
        ->capture_default_str();
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
    command->add_option("--picture", picture, messages::option_help("--picture"))
        ->transform(CLI::CheckedTransformer(kinds).description(""))
        ->default_str("auto")
        ->type_name("KIND");
  }

  void add_reset() {
    CLI::App* command = add_command("reset", messages::for_students());
    command->add_option("exercise", name, messages::option_help("exercise"))->required()->type_name("EXERCISE");
    command->callback([this] { job = [this](const Course& course) { return reset(course, name); }; });
  }

  void add_examples() {
    CLI::App* command = add_command("examples", messages::for_students());
    command->add_option("lecture", name, messages::option_help("lecture"))->required()->type_name("LECTURE");
    command->callback([this] { job = [this](const Course& course) { return examples(course, name); }; });
  }

  void add_handout() {
    CLI::App* command = add_command("handout", messages::for_instructors());
    command->add_option("folder", out, messages::option_help("folder"))->required()->type_name("FOLDER");
    command->callback([this] { job = [this](const Course& course) { return handout(course, out); }; });
  }

  void add_doctor() {
    add_command("doctor", messages::for_students())->callback([this] { job = doctor; });
  }

  void add_self_check() {
    CLI::App* command = add_command("self-check", messages::for_authors());
    command->add_option("--seeds", seed_count, messages::option_help("--seeds"))
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
  process_registry::end_with_the_checker();
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
