// The commands try and debug: programs that call the student's own functions, started as the student would.
#include "checker/commands/commands.hpp"
#include "checker/course/exam.hpp"

#include <cerrno>
#include <cstring>

namespace workbook {

namespace {

/// Compiles a program with the student's files that it may call. Where it does not compile, prints what the compiler
/// says and returns false. @throws std::runtime_error
bool build_program(const Course& course, const fs::path& source, const std::vector<Submission>& files,
                   const std::vector<std::string>& options, const fs::path& program) {
  const Toolchain toolchain = read_toolchain(course.toolchain_file());
  make({toolchain.setup, toolchain.build}, {toolchain.target});
  const fs::path around = program.parent_path() / "support.cpp";
  write_or_throw(around, from_skeleton("try_support.cpp"));
  std::vector<std::string> arguments = toolchain.flags;
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), {"-Wall", "-fmax-errors=20", "-include", toolchain.prelude.string(),
                                     source.string(), around.string()});
  for (const Submission& file : files) arguments.push_back(file.path.string());
  // For programs that read zip files; the checker needs this library too.
  arguments.insert(arguments.end(), {"-Wl,--as-needed", "-larchive", "-o", program.string()});
  const FinishedProgram compiled =
      run_with_path(toolchain.compiler.string(), arguments, std::chrono::duration<double>(120));
  fmt::print(stderr, "{}", printable(compiled.output));
  if (!compiled.succeeded())
    fmt::print(stderr, "The program does not compile{}.\n", compiled.out_of_time ? " within two minutes" : "");
  return compiled.succeeded();
}

/// A folder of this command, new and empty. @throws std::runtime_error
fs::path folder_of(const Course& course, const char* command) {
  fs::path folder = course.scratch() / command;
  std::error_code problem;
  fs::remove_all(folder, problem);
  if (!problem) fs::create_directories(folder, problem);
  if (problem)
    throw std::runtime_error(fmt::format("{} cannot be written ({}).", shown_path(folder), problem.message()));
  return folder;
}

/// A value as a variable of the type that the contract gives it.
std::string declaration(const std::string& name, const Value& value, Kind kind) {
  const auto number = [&](int row, int col) { return number_text(value.at(row, col), all_digits); };
  const auto list = [&](int rows, const auto& element) {
    std::vector<std::string> elements;
    for (int row = 0; row < rows; ++row) elements.push_back(element(row));
    return fmt::format("{{{}}}", fmt::join(elements, ", "));
  };
  const auto block = [&](int first_col, int cols) {
    return list(value.rows, [&](int row) { return list(cols, [&](int col) { return number(row, first_col + col); }); });
  };
  switch (kind) {
    case Kind::number:
      return fmt::format("const double {} = {};", name, number(0, 0));
    case Kind::integer:
      return fmt::format("const int {} = {};", name, number(0, 0));
    case Kind::vector2:
    case Kind::vector3:
      return fmt::format("const Vector{}d {}{};", value.rows, name,
                         list(value.rows, [&](int row) { return number(row, 0); }));
    case Kind::vector:
      if (value.rows == 0) return fmt::format("const VectorXd {}(0);", name);
      return fmt::format("const VectorXd {}{{{}}};", name, list(value.rows, [&](int row) { return number(row, 0); }));
    case Kind::matrix3:
      return fmt::format("const Matrix3d {}{};", name, block(0, 3));
    case Kind::points:
      if (value.cols == 0) return fmt::format("const Matrix3Xd {}(3, 0);", name);
      return fmt::format("const Matrix3Xd {}{};", name, block(0, value.cols));
    case Kind::matrices:
      break;
  }
  return fmt::format("const std::vector<Matrix3d> {}{};", name,
                     list(value.cols / 3, [&](int k) { return "Matrix3d" + block(3 * k, 3); }));
}

/// A program that calls the function once, at one case.
std::string program_of_case(const ExerciseReference& exercise, std::size_t index) {
  const Case& one = exercise.cases[index];
  std::string text = fmt::format("// Case {} of {}: {}\nusing namespace rigid;\n\nint main() {{\n", index + 1,
                                 exercise.name, one.name);
  text.insert(text.find("int main"), "static void compared() {}  // here the debugger shows both\n\n");
  std::vector<std::string> names;
  for (std::size_t k = 0; k < exercise.arguments.size(); ++k) {
    const Argument& argument = exercise.arguments[k];
    text += "  " + declaration(argument.name, one.inputs[k], argument.kind) + "\n";
    names.push_back(argument.name);
  }
  return text + "  " + declaration("expected", one.expected, exercise.result_kind) +
         fmt::format("\n  const auto yours = rigid::{}({});\n  compared();\n}}\n", exercise.name,
                     fmt::join(names, ", "));
}

std::string path_of_gdb() {
  const std::string gdb = program_on_path("gdb");
  if (gdb.empty()) throw std::runtime_error("This needs gdb, which is missing here (on Debian: apt-get install gdb).");
  return gdb;
}

/// Builds the program of one case of the student's file, without optimisation, and names the case. Returns its path;
/// "" where it does not compile, which it says.
fs::path case_program(const Course& course, CheckContext& context, const CheckTask& task, std::size_t index) {
  const ExerciseReference& reference = context.reference(task);
  const fs::path folder = folder_of(course, "debug");
  const fs::path source = folder / "case.cpp";
  write_or_throw(source, program_of_case(reference, index));
  const Submission submission = read_with_library(course, task);
  std::vector<Submission> files = submission.library;
  files.push_back(submission);
  fs::path program = folder / "program";
  fmt::print(stderr, "Compiling it for the debugger ...\n");
  if (!build_program(course, source, files, {"-O0", "-g", "-w"}, program)) return "";
  fmt::print("Case {} “{}” of {} is in {}.\n", index + 1, reference.cases[index].name, reference.name,
             shown_path(source));
  std::fflush(stdout);
  return program;
}

std::vector<std::string> debugger(const CheckContext& context, const std::string& gdb) {
  return {gdb, "-q", "-x", (context.toolchain().main_include / "checker/commands/on_demand/eigen.gdb.py").string()};
}

/// Every variable of the student's function at one case, as the debugger sees them.
int try_case(const Course& course, const Options& options) {
  constexpr std::chrono::seconds longest(60);
  constexpr std::size_t most_output = 1 << 20;
  const Exercise exercise = course.find_exercise(options.name);
  refuse_in_exam(course, {exercise});
  const std::string gdb = path_of_gdb();
  CheckContext context(course);
  const CheckTask task = check_task(course, exercise);
  const std::size_t index = find_case(context.reference(task), *options.case_name);
  const fs::path program = case_program(course, context, task, index);
  if (program.empty()) return something_failed;
  std::vector<std::string> words = debugger(context, gdb);
  words.insert(words.end(), {"-batch-silent", "-ex", "intermediate rigid::" + exercise.name(), program.string()});
  Launch launch;
  launch.program = gdb;
  launch.arguments = {words.begin() + 1, words.end()};
  launch.environment = {"HOME=" + program.parent_path().string()};  // where gdb keeps its index of symbols
  const FinishedProgram shown = run_program(launch, longest, most_output);
  fmt::print("{}", printable(shown.output));
  if (shown.out_of_time)
    return stop("Your function had not ended after {} s: a loop never ends, perhaps.", longest.count());
  return shown.succeeded() ? all_passed : something_failed;
}

}  // namespace

int try_out(const Course& course, const Options& options) {
  if (options.case_name) return try_case(course, options);
  const fs::path file = fs::absolute(options.file.value_or(course.lectures() / "try.cpp"));
  if (!options.file && !fs::exists(file)) {
    write_or_throw(file, from_skeleton("try.cpp"));
    fmt::print("A first experiment is in {}: change it as you like.\n\n", shown_path(file));
  }
  const Submission experiment = read_submission(file);
  const fs::path program = folder_of(course, "try") / "program";
  const auto files = own_functions(experiment.text, course.exercises(),
                                   [&](const Exercise& exercise) { return course.student_file(exercise); });
  if (!build_program(course, file, files, {}, program)) return something_failed;
  exec_program({program.string()});
}

int debug(const Course& course, const Options& options) {
  const std::string gdb = options.build_only ? "" : path_of_gdb();
  const Exercise exercise = course.find_exercise(options.name);
  CheckContext context(course);
  const CheckTask task = check_task(course, exercise, options.seed);
  std::size_t index = 0;
  if (options.case_name) {
    index = find_case(context.reference(task), *options.case_name);
  } else {
    const CheckResult checked = check_exercise(context, task);
    if (checked.observation.replies.empty() || !checked.is_started()) {
      fmt::print("{}", terminal_report(checked, course, Console::of_standard_output(), {}));
      return something_failed;
    }
    if (!checked.judgement.failing.empty()) index = checked.judgement.failing.front();
  }
  const fs::path program = case_program(course, context, task, index);
  if (program.empty()) return something_failed;
  if (options.build_only) return all_passed;
  std::vector<std::string> words = debugger(context, gdb);
  words.insert(words.end(), {"-ex", "break rigid::" + exercise.name(), "-ex", "run", program.string()});
  exec_program(words);
}

}  // namespace workbook
