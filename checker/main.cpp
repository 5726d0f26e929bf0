/// @file
/// The command line of the checker.
#include "checker/commands/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
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
    app.name("checker");
    app.description(
        "Checks the exercises of the Rigid Body Workbook.\nWithout a command it says where you stand and what is "
        "next.");
    app.footer(
        "Exit status: 0 all that was asked passed, 1 something did not, 2 wrong usage, 3 the checker itself is in "
        "trouble.");
    app.require_subcommand(0, 1);
    app.add_option("--course", course_file,
                   "another course.json than the one that was built (for tests of the checker)")
        ->group("For maintainers");
    add_check();
    add_list();
    add_hint();
    add_plot();
    add_figures();
    add_report();
    add_reset();
    add_examples();
    add_doctor();
    add_self_check();
  }

  void add_check() {
    CLI::App* command = app.add_subcommand("check", "grade exercises and say what is wrong");
    command->add_option("name", check_options.names,
                        "exercises or lectures, by name or number; none: the whole course");
    command->add_option("--file", file, "check this file in place of the exercise's own");
    command->add_option("--seed", check_options.seed, "draws other random cases")->capture_default_str();
    command->add_flag("--json", check_options.json, "print one JSON document and nothing else");
    command->add_flag("--plot", check_options.plot, "draw your curve on the reference, as SVG and PNG");
    add_picture(command, check_options.picture);
    command->callback([this] {
      check_options.file = optional_path(file);
      job = [this](const Course& course) { return check(course, check_options); };
    });
  }

  void add_list() {
    app.add_subcommand("list", "show every exercise with its state")->callback([this] { job = list; });
  }

  void add_hint() {
    CLI::App* command = app.add_subcommand("hint", "show the next hint of an exercise");
    command->add_option("exercise", name, "its name")->required();
    command->add_flag("--all", all, "show all hints at once");
    command->callback([this] { job = [this](const Course& course) { return hint(course, name, all); }; });
  }

  void add_plot() {
    CLI::App* command = app.add_subcommand("plot", "draw your curve on the reference, as SVG and PNG");
    command->add_option("name", plot_options.names, "exercises or lectures");
    command->add_flag("--all", plot_options.all, "every exercise, and the figures of every lecture");
    command->add_option("--file", file, "use this file in place of the exercise's own");
    command->add_option("--out", out, "the folder for the pictures");
    command->add_option("--seed", plot_options.seed, "as for check")->capture_default_str();
    add_picture(command, plot_options.picture);
    command->callback([this] {
      plot_options.file = optional_path(file);
      plot_options.out = optional_path(out);
      job = [this](const Course& course) { return plot(course, plot_options); };
    });
  }

  void add_figures() {
    CLI::App* command = app.add_subcommand("figures", "redraw the figures of a lecture with your own functions");
    command->add_option("lecture", figures_options.lecture, "its name, number or topic")->required();
    command->add_option("--out", out, "the folder for the pictures");
    command->add_option("--seconds", figures_options.seconds_per_figure, "the most that one figure may take")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    command->callback([this] {
      figures_options.out = optional_path(out);
      job = [this](const Course& course) { return figures(course, figures_options); };
    });
  }

  void add_report() {
    CLI::App* command =
        app.add_subcommand("report", "write one page to hand in, with verdicts, plots and what to read");
    command->add_option("--html", html, "the page to write; an older one is replaced")->required();
    command->add_option("names", report_options.names,
                        "exercises or lectures, by name or number; none: the whole course");
    command->add_option("--name", report_options.student, "whose page it is");
    command->add_option("--file", file, "check this file in place of the exercise's own");
    command->add_option("--seed", report_options.seed, "as for check")->capture_default_str();
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
    CLI::App* command = app.add_subcommand("reset", "put an exercise back to the beginning; your version is kept");
    command->add_option("exercise", name, "its name")->required();
    command->callback([this] { job = [this](const Course& course) { return reset(course, name); }; });
  }

  void add_examples() {
    CLI::App* command = app.add_subcommand("examples", "run the worked examples of a lecture on your own functions");
    command->add_option("lecture", name, "its name, number or topic")->required();
    command->callback([this] { job = [this](const Course& course) { return examples(course, name); }; });
  }

  void add_doctor() {
    app.add_subcommand("doctor", "say what this machine offers")->callback([this] { job = doctor; });
  }

  void add_self_check() {
    CLI::App* command = app.add_subcommand("self-check", "for authors: is the workbook itself in order?");
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
