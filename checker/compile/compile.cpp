#include "checker/compile/compile.hpp"

#include "checker/compile/diagnostics.hpp"
#include "checker/compile/object_file.hpp"
#include "checker/compile/source_file.hpp"
#include "checker/worker/child_process.hpp"
#include "checker/worker/printable.hpp"

#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

namespace workbook {
namespace fs = std::filesystem;
namespace {

/// Ends a compilation; caught in compile().
struct Refused {
  Refusal refusal;
  std::string message;
  std::string details;
};

constexpr const char* not_yours = "; this is not your mistake.";

std::string quoted(const std::string& code) { return "`" + code + "`"; }

/// Changes whenever the file does.
std::string stamp(const fs::path& file) {
  std::error_code ignored;
  std::ostringstream text;
  text << file.string() << ' ' << fs::file_size(file, ignored) << ' '
       << fs::last_write_time(file, ignored).time_since_epoch().count() << '\n';
  return text.str();
}

/// All that an executable depends on.
std::string cache_key(const Toolchain& toolchain, const std::string& exercise, const std::string& file_name,
                      const std::string& source) {
  fs::path precompiled = toolchain.prelude;
  precompiled += ".gch";
  std::string key = stamp(toolchain.compiler) + stamp(toolchain.prelude) + stamp(precompiled) +
                    stamp(toolchain.worker_object(exercise));
  for (const fs::path& object : toolchain.support) key += stamp(object);
  for (const std::string& flag : toolchain.flags) key += flag + '\n';
  for (const std::string& flag : toolchain.link_flags) key += flag + '\n';
  return key + file_name + '\n' + source;
}

/// The name as a string literal of C++.
std::string literal(const std::string& name) {
  std::string text;
  for (const char letter : name) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return '"' + text + '"';
}

void write_file(const fs::path& file, const std::string& content) {
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << content).flush())
    throw CacheError("The checker cannot write " + file.string() + " (is the disk full?)" + not_yours);
}

/// The files of a list of dependencies as compilers write it for make: "unit.o: a.hpp \\ b\\ c.hpp".
std::vector<std::string> dependencies(const fs::path& list) {
  std::ifstream stream(list, std::ios::binary);
  std::vector<std::string> names(1);
  for (char letter = 0; stream.get(letter);) {
    if (letter == '\\' || letter == '$') {
      char escaped = 0;
      if (stream.get(escaped) && escaped != '\n') names.back() += escaped;
    } else if (letter != ' ' && letter != '\n') {
      names.back() += letter;
    } else if (!names.back().empty()) {
      names.emplace_back();
    }
  }
  if (names.back().empty()) names.pop_back();
  if (!names.empty()) names.erase(names.begin());  // the target, "unit.o:"
  return names;
}

bool is_below(const fs::path& file, const fs::path& directory) {
  std::error_code error;
  const fs::path parent = fs::canonical(directory, error);
  return !error && std::mismatch(parent.begin(), parent.end(), file.begin(), file.end()).first == parent.end();
}

/// One compilation in its own directory:
///   unit.cpp, unit.o, worker   fixed names, whatever the student's file is called
///   shown/NAME                 where the compiler starts, and finds the lines that it shows in its messages
class CompilationInProgress {
 public:
  CompilationInProgress(const CompileTask& task, const Toolchain& toolchain, const CompileLimits& limits,
                        std::string file_name, const fs::path& workspace)
      : task_(task), toolchain_(toolchain), limits_(limits), file_name_(std::move(file_name)), workspace_(workspace) {}

  fs::path run(const std::string& source) {
    fs::create_directory(shown());
    write_file(shown() / file_name_, source);
    write_file(workspace_ / "unit.cpp", "#line 1 " + literal(file_name_) + "\n" + source);
    compile_unit();
    refuse_foreign_includes();
    return link();
  }

 private:
  fs::path shown() const { return workspace_ / "shown"; }
  fs::path object() const { return workspace_ / "unit.o"; }

  void compile_unit() {
    std::vector<std::string> arguments = toolchain_.flags;
    for (const char* argument : {"-fdiagnostics-color=never", "-fmax-errors=20", "-x", "c++", "-include"})
      arguments.push_back(argument);
    arguments.push_back(toolchain_.prelude.string());
    // Both lists of dependencies: of the preprocessor, and of the assembler, which can include files too.
    for (const char* argument :
         {"-MD", "-MF", "../unit.includes", "-Wa,--MD,../unit.assembled", "-c", "../unit.cpp", "-o", "../unit.o"})
      arguments.push_back(argument);
    const FinishedProgram compiled = run_compiler(arguments);
    if (succeeded(compiled)) return;
    refuse_if_limit_reached(compiled);
    const std::optional<FirstError> error = first_error(compiled.output, file_name_);
    std::string message = "Your file does not compile";
    if (error && error->line > 0) message += ": line " + std::to_string(error->line);
    if (error) message += ": " + error->text;
    refuse(Refusal::compile_error, message + ".", compiled.output);
  }

  /// A file that includes others than headers of the course and of the system could include the answers.
  void refuse_foreign_includes() const {
    for (const char* list : {"unit.includes", "unit.assembled"})
      for (const std::string& name : dependencies(workspace_ / list))
        if (!may_be_included(name))
          refuse(Refusal::compile_error, "Your file includes " + printable(name) +
                                             ", but it is compiled alone: include only headers of the course, "
                                             "of Eigen and of the standard library.");
  }

  bool may_be_included(const std::string& name) const {
    const fs::path path = (shown() / name).lexically_normal();
    // The compiler's own: the unit, by its path and as it calls itself in the assembler's file, which is gone again.
    if (name == "unit.cpp" || path.parent_path() == workspace_) return true;
    // These mean something else for the compiler than for the checker.
    if (is_below(path, "/proc") || is_below(path, "/dev")) return false;
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    return !error && std::any_of(toolchain_.include_directories.begin(), toolchain_.include_directories.end(),
                                 [&](const fs::path& directory) { return is_below(file, directory); });
  }

  fs::path link() {
    fs::path executable = workspace_ / "worker";
    std::vector<std::string> arguments = {"../unit.o", toolchain_.worker_object(task_.exercise).string()};
    for (const fs::path& support : toolchain_.support) arguments.push_back(support.string());
    for (const std::string& flag : toolchain_.link_flags) arguments.push_back(flag);
    arguments.insert(arguments.end(), {"-o", executable.string()});
    const FinishedProgram linked = run_compiler(arguments);
    if (succeeded(linked)) return executable;
    refuse_if_limit_reached(linked);
    explain_symbols(linked.output);
    refuse(Refusal::compile_error, "Your file compiles, but cannot be linked into a program; see the linker's message.",
           linked.output);
  }

  /// Looks for the usual reasons why linking fails.
  void explain_symbols(const std::string& details) const {
    const ObjectFile student = read_object_file(object(), toolchain_);
    const ObjectFile worker = read_object_file(toolchain_.worker_object(task_.exercise), toolchain_);
    const auto is_contract_function = [](const Symbol& symbol) { return symbol.signature.starts_with("rigid::"); };
    if (student.defines("main"))
      refuse(Refusal::compile_error, "Your file defines main(); leave it out, the checker calls your function itself.",
             details);
    for (const Symbol& needed : worker.undefined)
      if (is_contract_function(needed) && !student.defines(needed.linker_name))
        refuse(Refusal::missing_function, missing(needed, student), details);
    for (const Symbol& called : student.undefined)
      if (is_contract_function(called))
        refuse(Refusal::compile_error,
               "Your file calls " + quoted(called.name()) +
                   ", which it does not define; each file is compiled alone, so write what you need into this one.",
               details);
  }

  std::string missing(const Symbol& needed, const ObjectFile& student) const {
    std::string message = "Your file does not define " + quoted(task_.signature);
    const std::string plain_name = needed.name().substr(std::string("rigid::").size());
    for (const Symbol& defined : student.defined) {
      if (defined.name() == needed.name())
        return message + "; it defines " + quoted(defined.signature) + ", whose parameters differ.";
      if (defined.name() == plain_name)
        return message + "; it defines " + quoted(defined.signature) + " outside the namespace rigid.";
    }
    std::string others;
    int count = 0;
    for (const Symbol& defined : student.defined) {
      if (defined.signature.starts_with("std::") || defined.signature.starts_with("Eigen::") || ++count > 3) continue;
      others += (others.empty() ? "" : ", ") + quoted(defined.signature);
    }
    if (others.empty()) return message + "; it defines no function at all.";
    return message + "; it defines " + others + (count > 3 ? " and others." : ".");
  }

  FinishedProgram run_compiler(const std::vector<std::string>& arguments) const {
    const std::string program = toolchain_.compiler.string();
    const char* const path = std::getenv("PATH");
    Launch launch;
    launch.program = program.c_str();
    launch.arguments = arguments;
    launch.environment = {std::string("PATH=") + (path ? path : "/usr/local/bin:/usr/bin:/bin"), "LC_ALL=C",
                          "TMPDIR=" + workspace_.string()};
    launch.directory = shown();
    const rlimit memory{limits_.memory_bytes, limits_.memory_bytes};
    const auto seconds = static_cast<rlim_t>(std::ceil(limits_.time.count()));
    const rlimit processor{seconds, seconds + 1};
    const rlimit core{0, 0};
    const rlimit file{limits_.file_bytes, limits_.file_bytes};
    launch.prepare = [&]() -> const char* {
      const bool limited = ::setrlimit(RLIMIT_AS, &memory) == 0 && ::setrlimit(RLIMIT_CPU, &processor) == 0 &&
                           ::setrlimit(RLIMIT_CORE, &core) == 0 && ::setrlimit(RLIMIT_FSIZE, &file) == 0;
      return limited ? nullptr : "limit the compiler";
    };
    try {
      FinishedProgram finished = run_program(launch, limits_.time, limits_.output_bytes);
      finished.output = printable(finished.output);
      return finished;
    } catch (const LaunchError& error) {
      throw ToolchainError("The compiler " + program + " cannot be used (" + error.what() +
                           "); build the workbook again.");
    }
  }

  static bool succeeded(const FinishedProgram& program) {
    return program.end.signal == 0 && program.end.exit_status == 0 && !program.out_of_time && !program.too_much_output;
  }

  void refuse_if_limit_reached(const FinishedProgram& program) const {
    if (!has_room())
      refuse(Refusal::checker_error,
             std::string("There is no room to compile your file (is the disk full?)") + not_yours, program.output);
    if (program.out_of_time)
      refuse(Refusal::compile_error,
             "Your file takes too long to compile; look for a template or an #include that never ends.",
             program.output);
    if (ran_out_of_memory(program.output))
      refuse(Refusal::compile_error,
             "Compiling your file takes too much memory; look for a template or an #include that never ends.",
             program.output);
    if (grew_too_large(program.output) || program.end.signal == SIGXFSZ)
      refuse(Refusal::compile_error, "Your file makes a program that is too large; look for a huge array.",
             program.output);
  }

  /// Tried, not read from the compiler's messages: those a student can write.
  bool has_room() const {
    std::ofstream probe(workspace_ / "probe", std::ios::binary);
    return static_cast<bool>((probe << std::string(std::size_t{4} << 20, ' ')).flush());
  }

  [[noreturn]] static void refuse(Refusal refusal, std::string message, std::string details = {}) {
    throw Refused{refusal, std::move(message), std::move(details)};
  }

  const CompileTask& task_;
  const Toolchain& toolchain_;
  const CompileLimits& limits_;
  const std::string file_name_;
  const fs::path workspace_;
};

}  // namespace

Compilation compile(const CompileTask& task, const Toolchain& toolchain, const fs::path& cache_directory,
                    const CompileLimits& limits) {
  const Clock::time_point start = Clock::now();
  Compilation result;
  const auto refuse = [&](Refusal refusal, const std::string& message, const std::string& details = {}) {
    result.refusal = refusal;
    result.message = message;
    result.details = details;
  };
  try {
    const std::string source = read_source(task.file);
    std::string file_name = printable(task.file.filename().string());
    std::replace(file_name.begin(), file_name.end(), '\n', '?');
    require_complete(toolchain, task.exercise);
    const BuildCache cache(fs::absolute(cache_directory));
    const std::string key = cache_key(toolchain, task.exercise, file_name, source);
    result.executable = cache.find(key);
    result.from_cache = result.executable.has_value();
    if (!result.executable) {
      const Workspace workspace(cache.directory());
      CompilationInProgress compilation(task, toolchain, limits, file_name, workspace.directory());
      result.executable = cache.keep(compilation.run(source), key);
    }
  } catch (const Refused& reason) {
    refuse(reason.refusal, reason.message, reason.details);
  } catch (const RejectedFile& error) {
    refuse(Refusal::rejected_file, error.what());
  } catch (const ToolchainError& error) {
    refuse(Refusal::checker_error, error.what());
  } catch (const CacheError& error) {
    refuse(Refusal::checker_error, error.what());
  } catch (const fs::filesystem_error& error) {
    refuse(Refusal::checker_error,
           "The checker could not compile your file (" + std::string(error.what()) + ")" + not_yours);
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

Observation refused(const Compilation& compilation) {
  Observation observation;
  observation.refusal = compilation.refusal;
  observation.refusal_message = compilation.message;
  observation.refusal_details = compilation.details;
  observation.compile_seconds = compilation.seconds;
  return observation;
}

}  // namespace workbook
