#include "checker/commands/on_demand/student_programs.hpp"
#include "checker/compile/compile.hpp"

#include <set>

namespace workbook {

namespace {

/// The student's objects that the caller needs, as the build names them. @throws RejectedFile
std::vector<std::string> objects_for(const Course& course, const Caller& caller) {
  const fs::path& build = course.build().directory;
  std::set<fs::path> needed;
  const auto file_of = [&](const Exercise& exercise) { return course.student_file(exercise); };
  for (const Submission& file : own_functions(read_file(caller.source).value_or(""), course.exercises(), file_of))
    needed.insert(file.path.filename());
  std::vector<std::string> objects;
  for (const fs::path object : lines_of(read_file(build / "student/objects").value_or("")))
    if (needed.contains(object.stem())) objects.push_back(object.lexically_relative(build).string());
  return objects;
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

}  // namespace

std::string student_program(const Course& course, const Caller& caller) {
  std::vector<std::string> objects;
  try {
    objects = objects_for(course, caller);
  } catch (const RejectedFile& reason) {
    say("{}", reason.what());
    return "";
  }
  write_or_throw(course.build().directory / "student" / (caller.target + ".objects"),
                 fmt::format("{}\n", fmt::join(objects, "\n")));
  objects.insert(objects.begin(), caller.parts.begin(), caller.parts.end());
  FinishedProgram built = make(course.build(), objects);
  if (built.succeeded()) built = make(course.build(), {caller.target});
  if (built.succeeded()) return (course.build().directory / "lectures" / caller.target).string();
  std::set<std::string> exercises;
  for (const Match& error : search_all(built.output, R"(lectures/\w+/exercises/(\w+)\.cpp:\d+:\d+: error)"))
    exercises.insert(error[1]);
  if (exercises.empty())
    throw std::runtime_error(fmt::format("{}\nThe {} could not be built.", built.output, caller.what));
  fmt::print("The {} need files of yours that do not compile:\n", caller.what);
  for (const std::string& exercise : exercises) fmt::print("  {}\n", command("check " + exercise));
  return "";
}

void print_outcome(const std::string& name, const Outcome& outcome) {
  const Console console = Console::of_standard_output();
  const bool is_good = outcome.trouble.empty();
  const std::string mark = is_good                  ? console.mark("✓", Style::good)
                           : outcome.is_not_started ? console.mark("·", Style::quiet)
                                                    : console.mark("✗", Style::bad);
  const std::size_t indent = mark.empty() ? 0 : 2;
  const std::string text = is_good ? name : name + ": " + outcome.trouble;
  fmt::print("{}{}\n", mark, console.wrapped(text, indent).substr(indent));
  std::fflush(stdout);
}

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

fs::path folder_of(const Course& course, const char* command) {
  fs::path folder = course.scratch() / command;
  std::error_code problem;
  fs::remove_all(folder, problem);
  if (!problem) fs::create_directories(folder, problem);
  if (problem)
    throw std::runtime_error(fmt::format("{} cannot be written ({}).", shown_path(folder), problem.message()));
  return folder;
}

std::string path_of_gdb() {
  const std::string gdb = program_on_path("gdb");
  if (gdb.empty()) throw std::runtime_error("This needs gdb, which is missing here (on Debian: apt-get install gdb).");
  return gdb;
}

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

}  // namespace workbook
