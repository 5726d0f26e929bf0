/// @file
/// How long a student waits: from a saved file to the verdict, by `check` and in `watch`, over the bare compiler with
/// the same flags and the same precompiled header. All in turn, because machines are noisy; medians and ratios count.
#include "checker/base/child_process.hpp"
#include "checker/base/files.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/course/course.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

using namespace workbook;
namespace fs = std::filesystem;

namespace {

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 == 1 ? numbers[middle] : (numbers[middle - 1] + numbers[middle]) / 2;
}

double seconds(const std::function<void()>& work) {
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Runs a program that must succeed; a benchmark of failures would mean nothing.
void run(const std::string& program, const std::vector<std::string>& arguments) {
  const FinishedProgram finished = run_with_path(program, arguments, std::chrono::minutes(5));
  if (!finished.succeeded()) throw std::runtime_error(fmt::format("{} failed:\n{}", program, finished.output));
}

/// `checker watch`, read by a program.
class RunningWatch {
 public:
  RunningWatch(std::string checker, const fs::path& course_file)
      : checker_(std::move(checker)), process_(launch(checker_, course_file)) {
    wait_for("Next: ");
  }

  /// Waits until the watch has said that once more.
  void wait_for(const std::string& words) {
    while (output_.find(words) == std::string::npos) {
      pollfd source{process_.output(), POLLIN, 0};
      if (::poll(&source, 1, 60'000) <= 0) throw std::runtime_error("the watch says nothing:\n" + output_);
      char buffer[4096];
      const ssize_t got = ::read(process_.output(), buffer, sizeof buffer);
      if (got <= 0) throw std::runtime_error("the watch ended:\n" + output_);
      output_.append(buffer, static_cast<std::size_t>(got));
    }
    output_.clear();
  }

 private:
  static Launch launch(const std::string& checker, const fs::path& course_file) {
    Launch launch;
    launch.program = checker.c_str();
    launch.arguments = {"--course", course_file.string(), "watch"};
    launch.environment = {std::string("PATH=") + std::getenv("PATH")};
    return launch;
  }

  std::string checker_;
  ChildProcess process_;
  std::string output_;
};

/// The lectures once more, with exercises that a benchmark may solve. @returns its course.json
fs::path copy_course(const Course& course, const fs::path& course_file, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::copy(course.lectures(), folder / "lectures", fs::copy_options::recursive);
  auto description = nlohmann::json::parse(read_file(course_file).value());
  description["root"] = folder.string();
  write_file(folder / "course.json", description.dump(2));
  return folder / "course.json";
}

struct Times {
  double compile, check, watch;
};

void measure(const std::string& checker, int runs, const std::vector<std::string>& names) {
  const fs::path course_file = fs::path(checker).parent_path() / "course.json";
  const Course course(course_file);
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  const fs::path scratch = course.scratch() / "benchmark";
  const fs::path copied = copy_course(course, course_file, scratch / "watched");
  const Course watched(copied);
  RunningWatch watch(checker, copied);

  const auto measured = [&](const Exercise& exercise) {
    const std::string solution = read_file(course.solution_file(exercise)).value();
    const fs::path file = scratch / (exercise.name() + ".cpp");
    std::vector<std::string> compile = toolchain.flags;
    for (const std::string& argument : {std::string("-include"), toolchain.prelude.string(), std::string("-c"),
                                        file.string(), std::string("-o"), (scratch / "object.o").string()})
      compile.push_back(argument);
    course.reference(exercise.lecture(), 1);
    require_complete(toolchain, exercise.name());
    std::vector<double> to_compile, to_check, to_watch;
    for (int i = 0; i < runs; ++i) {
      // A comment makes every run a file that was never seen before.
      const std::string edited = solution + fmt::format("// {}\n", Clock::now().time_since_epoch().count());
      write_file(file, edited);
      to_compile.push_back(seconds([&] { run(toolchain.compiler.string(), compile); }));
      to_check.push_back(seconds([&] { run(checker, {"check", exercise.name(), "--file", file.string(), "--json"}); }));
      to_watch.push_back(seconds([&] {
        write_file(watched.student_file(exercise), edited + "// saved\n");
        watch.wait_for(exercise.name() + "  passed");
      }));
    }
    return Times{median(to_compile), median(to_check), median(to_watch)};
  };

  fmt::print(
      "Seconds, medians of {} runs in turn: the bare compiler; saved file to verdict by `check`; in `watch`.\n\n",
      runs);
  fmt::print("{:<30} {:>8} {:>7} {:>7} {:>14} {:>14}\n", "exercise", "compile", "check", "watch", "check/compile",
             "watch/compile");
  std::vector<double> check, watching;
  for (const Exercise& exercise : course.choose(names)) {
    const Times times = measured(exercise);
    check.push_back(times.check / times.compile);
    watching.push_back(times.watch / times.compile);
    fmt::print("{:<30} {:8.3f} {:7.3f} {:7.3f} {:14.2f} {:14.2f}\n", exercise.name(), times.compile, times.check,
               times.watch, check.back(), watching.back());
    std::fflush(stdout);
  }
  fmt::print("{:<30} {:>8} {:>7} {:>7} {:14.2f} {:14.2f}\n", "median", "", "", "", median(check), median(watching));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: benchmark CHECKER RUNS [EXERCISE or LECTURE]...\n");
    return 2;
  }
  try {
    measure(argv[1], std::stoi(argv[2]), {argv + 3, argv + argc});
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 3;
  }
  return 0;
}
