/// @file
/// How long a student waits: from saved file to verdict, beside the bare compiler and beside a plain CMake + doctest
/// project doing the same job. All in one run, in turn, because machines are noisy; medians and ratios count.
#include "checker/base/child_process.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/course/course.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace workbook;
namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

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
void run(const std::string& program, const std::vector<std::string>& arguments, const fs::path& directory = {}) {
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = arguments;
  launch.directory = directory;
  const char* path = std::getenv("PATH");
  launch.environment = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path), "HOME=/"};
  const FinishedProgram finished = run_program(launch, std::chrono::minutes(5), std::size_t{1} << 20);
  if (finished.out_of_time || finished.end.signal != 0 || finished.end.exit_status != 0) {
    throw std::runtime_error(fmt::format("{} failed:\n{}", program, finished.output));
  }
}

/// A project as one would write it without the checker. Its test only asks whether the function is there, which is less
/// work than comparing values: the comparison is in the plain project's favour.
void write_plain_project(const fs::path& folder, const Course& course, const Exercise& exercise,
                         const std::string& source) {
  fs::remove_all(folder);
  write(folder / "CMakeLists.txt",
        fmt::format("cmake_minimum_required(VERSION 3.25)\nproject(plain CXX)\nset(CMAKE_CXX_STANDARD 20)\n"
                    "find_package(Eigen3 REQUIRED NO_MODULE)\nfind_package(doctest REQUIRED)\n"
                    "add_executable(plain main.cpp test.cpp exercise.cpp)\n"
                    "target_include_directories(plain PRIVATE \"{}\")\ntarget_link_libraries(plain PRIVATE "
                    "Eigen3::Eigen doctest::doctest)\n",
                    (course.root() / "include").string()));
  write(folder / "main.cpp", "#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN\n#include <doctest/doctest.h>\n");
  write(folder / "exercise.cpp", source);
  write(folder / "test.cpp",
        fmt::format(
            "#include <doctest/doctest.h>\n#include <rigid/{}.hpp>\n"
            "TEST_CASE(\"the exercise is there\") {{ const bool there = &rigid::{} != nullptr; CHECK(there); }}\n",
            exercise.card->contract, exercise.name()));
}

/// The course once more, with files of its own that a benchmark may change. @returns its course.json
fs::path copy_course(const Course& course, const fs::path& course_file, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  fs::copy(course.lectures(), folder / "lectures", fs::copy_options::recursive);
  auto description = nlohmann::json::parse(read(course_file));
  description["root"] = folder.string();
  write(folder / "course.json", description.dump(2));
  return folder / "course.json";
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
    const char* path = std::getenv("PATH");
    Launch launch;
    launch.program = checker.c_str();
    launch.arguments = {"--course", course_file.string(), "watch"};
    launch.environment = {std::string("PATH=") + (path == nullptr ? "/usr/bin:/bin" : path)};
    return launch;
  }

  std::string checker_;
  ChildProcess process_;
  std::string output_;
};

struct Row {
  std::string exercise;
  double check, compile, watch, edit, scratch, unchanged;
};

Row measure(const Course& course, const Toolchain& toolchain, const std::string& checker, const std::string& cmake,
            RunningWatch& watch, const fs::path& watched_file, const fs::path& scratch, const Exercise& exercise,
            int runs) {
  const std::string solution = read(course.solution_file(exercise));
  const fs::path file = scratch / (exercise.name() + ".cpp");
  const fs::path plain = scratch / "plain";
  std::vector<double> check, compile, saved, edit, from_scratch, unchanged;

  std::vector<std::string> compile_arguments = toolchain.flags;
  for (const std::string& argument : {std::string("-include"), toolchain.prelude.string(), std::string("-c"),
                                      file.string(), std::string("-o"), (scratch / "object.o").string()}) {
    compile_arguments.push_back(argument);
  }
  write_plain_project(plain, course, exercise, solution);
  from_scratch.push_back(seconds([&] {
    run(cmake, {"-S", plain.string(), "-B", (plain / "build").string(), "-G", "Ninja"});
    run(cmake, {"--build", (plain / "build").string()});
    run((plain / "build/plain").string(), {});
  }));

  for (int i = 0; i < runs; ++i) {
    // A comment makes every run a file that was never seen before.
    const std::string edited = solution + fmt::format("// edit {} at {}\n", i, Clock::now().time_since_epoch().count());
    write(file, edited);
    compile.push_back(seconds([&] { run(toolchain.compiler.string(), compile_arguments); }));
    check.push_back(seconds([&] { run(checker, {"check", exercise.name(), "--file", file.string(), "--json"}); }));
    unchanged.push_back(seconds([&] { run(checker, {"check", exercise.name(), "--file", file.string(), "--json"}); }));
    saved.push_back(seconds([&] {
      write(watched_file, edited + "// saved\n");  // or the executable of the check above would be found
      watch.wait_for(exercise.name() + "  passed");
    }));
    write(plain / "exercise.cpp", edited);
    edit.push_back(seconds([&] {
      run(cmake, {"--build", (plain / "build").string()});
      run((plain / "build/plain").string(), {});
    }));
  }
  return {exercise.name(), median(check),        median(compile),  median(saved),
          median(edit),    median(from_scratch), median(unchanged)};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: benchmark CHECKER CMAKE RUNS [EXERCISE or LECTURE]...\n");
    return 2;
  }
  try {
    const std::string checker = argv[1];
    const fs::path course_file = fs::path(checker).parent_path() / "course.json";
    const Course course(course_file);
    const Toolchain toolchain = read_toolchain(course.toolchain_file());
    const fs::path scratch = course.scratch() / "benchmark";
    std::vector<Exercise> exercises;
    for (int i = 4; i < argc; ++i) {
      for (const Exercise& exercise : course.find(argv[i])) exercises.push_back(exercise);
    }
    if (argc == 4) exercises = course.exercises();

    const fs::path copy = copy_course(course, course_file, scratch / "watched");
    const Course watched(copy);
    RunningWatch watch(checker, copy);

    fmt::print(
        "Seconds, medians of {} runs in turn. check: saved file to verdict; compile: the bare compiler, same flags and "
        "precompiled\n"
        "header; watch: save to verdict through `checker watch`; edit, scratch: a plain CMake + doctest project after "
        "an "
        "edit,\nand from nothing; again: the same file unchanged.\n\n",
        argv[3]);
    fmt::print("{:<30} {:>7} {:>8} {:>7} {:>7} {:>8} {:>7}  {:>13} {:>10} {:>22}\n", "exercise", "check", "compile",
               "watch", "edit", "scratch", "again", "check/compile", "check/edit", "(watch - 0.15)/compile");
    std::vector<double> to_compile, to_edit, again, watch_to_compile;
    for (const Exercise& exercise : exercises) {
      const Row row = measure(course, toolchain, checker, argv[2], watch, watched.student_file(exercise), scratch,
                              exercise, std::stoi(argv[3]));
      to_compile.push_back(row.check / row.compile);
      to_edit.push_back(row.check / row.edit);
      again.push_back(row.unchanged);
      watch_to_compile.push_back((row.watch - 0.15) / row.compile);
      fmt::print("{:<30} {:7.3f} {:8.3f} {:7.3f} {:7.3f} {:8.3f} {:7.3f}  {:13.2f} {:10.2f} {:22.2f}\n", row.exercise,
                 row.check, row.compile, row.watch, row.edit, row.scratch, row.unchanged, to_compile.back(),
                 to_edit.back(), watch_to_compile.back());
      std::fflush(stdout);
    }
    fmt::print("{:<30} {:>7} {:>8} {:>7} {:>7} {:>8} {:7.3f}  {:13.2f} {:10.2f} {:22.2f}\n", "median", "", "", "", "",
               "", median(again), median(to_compile), median(to_edit), median(watch_to_compile));
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 3;
  }
  return 0;
}
