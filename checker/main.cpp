/// @file
/// The command line of the checker.
#include "checker/commands/commands.hpp"
#include "checker/worker/running_programs.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
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
    add_watch();
    add_list();
    add_hint();
    add_plot();
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
    command->callback([this] {
      check_options.file = optional_path(file);
      job = [this](const Course& course) { return check(course, check_options); };
    });
  }

  void add_watch() {
    CLI::App* command = app.add_subcommand("watch", "check whatever you save, and go on when it passes");
    command->add_option("name", name, "where to begin: an exercise or a lecture; none: the next exercise");
    command->callback([this] { job = [this](const Course& course) { return watch(course, course_file, name); }; });
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
    command->add_flag("--all", plot_options.all, "every exercise of the course");
    command->add_option("--file", file, "use this file in place of the exercise's own");
    command->add_option("--out", out, "the folder for the pictures");
    command->add_option("--seed", plot_options.seed, "as for check")->capture_default_str();
    command->callback([this] {
      plot_options.file = optional_path(file);
      plot_options.out = optional_path(out);
      job = [this](const Course& course) { return plot(course, plot_options); };
    });
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
