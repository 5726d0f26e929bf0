#include "checker/compile/compile.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/code_text.hpp"
#include "checker/compile/compile_mistakes.hpp"
#include "checker/compile/compiler.hpp"
#include "checker/compile/diagnostics.hpp"
#include "checker/compile/object_file.hpp"
#include "checker/compile/source_file.hpp"
#include "checker/messages/compiling.hpp"

#include <signal.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

namespace workbook {
namespace fs = std::filesystem;
namespace {

/// Ends a compilation; caught in compile().
struct Refused {
  Refusal refusal;
  std::string message;
  std::string details;
  std::vector<Finding> findings;
};

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

/// True if a line of the code defines the function as inline or as a template, which others cannot call.
bool is_marked_inline(const std::string& code, const std::string& function) {
  const std::regex marked("\\b(inline|template)\\b.*\\b" + function + "\\s*\\(");
  std::string before;  // a template's head may stand on a line of its own
  for (std::string line : lines_of(code)) {
    if (line.size() > 1000) line.resize(1000);  // std::regex recurses over the length of its text
    if (std::regex_search(before + " " + line, marked)) return true;
    before = line;
  }
  return false;
}

bool is_below(const fs::path& file, const fs::path& directory) {
  std::error_code error;
  const fs::path parent = fs::canonical(directory, error);
  return !error && std::mismatch(parent.begin(), parent.end(), file.begin(), file.end()).first == parent.end();
}

/// From the source to an executable; ends with Refused where there is a reason.
class CompilationInProgress {
 public:
  CompilationInProgress(const CompileTask& task, const Toolchain& toolchain, const Compiler& compiler)
      : task_(task), toolchain_(toolchain), compiler_(compiler) {}

  fs::path run(const std::string& source) const {
    compiler_.write(source);
    compile_unit(source);
    refuse_foreign_includes();
    return link(source);
  }

 private:
  void compile_unit(const std::string& source) const {
    // Both lists of dependencies: of the preprocessor, and of the assembler, which can include files too.
    const FinishedProgram compiled = compiler_.run(compiler_.arguments(
        {"-MD", "-MF", "../unit.includes", "-Wa,--MD,../unit.assembled", "-c", "../unit.cpp", "-o", "../unit.o"}));
    if (compiled.succeeded()) return;
    refuse_if_limit_reached(compiled);
    const std::vector<Diagnostic> found = diagnostics(compiled.output, compiler_.file_name());
    if (std::optional<Finding> error = first_error(found, source, task_.signature)) {
      const int line = error->line;
      refuse(Refusal::compile_error, messages::does_not_compile(line), compiled.output, {std::move(*error)});
    }
    const auto error = std::ranges::find(found, Severity::error, &Diagnostic::severity);
    refuse(Refusal::compile_error,
           error == found.end() ? messages::does_not_compile(0) : messages::does_not_compile(error_text(*error)),
           compiled.output);
  }

  /// A file that includes others than headers of the course and of the system could include the answers.
  void refuse_foreign_includes() const {
    for (const char* list : {"unit.includes", "unit.assembled"})
      for (const std::string& name : dependencies(compiler_.workspace() / list))
        if (!may_be_included(name)) refuse(Refusal::compile_error, messages::includes_foreign_file(printable(name)));
  }

  bool may_be_included(const std::string& name) const {
    const fs::path path = (compiler_.shown() / name).lexically_normal();
    // The compiler's own: the unit, by its path and as it calls itself in the assembler's file, which is gone again.
    if (name == "unit.cpp" || path.parent_path() == compiler_.workspace()) return true;
    // These mean something else for the compiler than for the checker.
    if (is_below(path, "/proc") || is_below(path, "/dev")) return false;
    std::error_code error;
    const fs::path file = fs::canonical(path, error);
    return !error && std::any_of(toolchain_.include_directories.begin(), toolchain_.include_directories.end(),
                                 [&](const fs::path& directory) { return is_below(file, directory); });
  }

  fs::path link(const std::string& source) const {
    fs::path executable = compiler_.workspace() / "worker";
    std::vector<std::string> arguments = {"../unit.o", toolchain_.worker_object(task_.exercise).string()};
    for (const fs::path& support : toolchain_.support) arguments.push_back(support.string());
    for (const std::string& flag : toolchain_.link_flags) arguments.push_back(flag);
    arguments.insert(arguments.end(), {"-o", executable.string()});
    const FinishedProgram linked = compiler_.run(arguments);
    if (linked.succeeded()) return executable;
    refuse_if_limit_reached(linked);
    explain_symbols(source, linked.output);
    refuse(Refusal::compile_error, messages::cannot_be_linked(), linked.output);
  }

  /// Looks for the usual reasons why linking fails.
  void explain_symbols(const std::string& source, const std::string& details) const {
    const ObjectFile student = read_object_file(compiler_.workspace() / "unit.o", toolchain_);
    const ObjectFile worker = read_object_file(toolchain_.worker_object(task_.exercise), toolchain_);
    const auto is_contract_function = [](const Symbol& symbol) { return symbol.signature.starts_with("rigid::"); };
    if (student.defines("main")) refuse(Refusal::compile_error, messages::defines_main(), details);
    for (const Symbol& needed : worker.undefined)
      if (is_contract_function(needed) && !student.defines(needed.linker_name))
        refuse(Refusal::missing_function, messages::missing_function(missing(needed, student, source)), details);
    for (const Symbol& called : student.undefined)
      if (is_contract_function(called))
        refuse(Refusal::compile_error, messages::calls_undefined(called.name()), details);
  }

  static messages::MissingFunction missing(const Symbol& needed, const ObjectFile& student, const std::string& source) {
    messages::MissingFunction missing;
    missing.needed = printable(needed.signature);
    for (const Symbol& defined : student.defined)
      if (!defined.signature.starts_with("std::") && !defined.signature.starts_with("Eigen::"))
        missing.defined.push_back(printable(defined.signature));
    const std::string plain_name = needed.name().substr(std::string("rigid::").size());
    missing.is_inline = missing.defined.empty() && is_marked_inline(code_only(source), plain_name);
    return missing;
  }

  void refuse_if_limit_reached(const FinishedProgram& program) const {
    if (!has_room()) refuse(Refusal::checker_error, messages::no_room_to_compile(), program.output);
    if (program.out_of_time) refuse(Refusal::compile_error, messages::takes_too_long_to_compile(), program.output);
    if (ran_out_of_memory(program.output))
      refuse(Refusal::compile_error, messages::takes_too_much_memory_to_compile(), program.output);
    if (grew_too_large(program.output) || program.end.signal == SIGXFSZ)
      refuse(Refusal::compile_error, messages::makes_too_large_a_program(), program.output);
  }

  /// Tried, not read from the compiler's messages: those a student can write.
  bool has_room() const {
    std::ofstream probe(compiler_.workspace() / "probe", std::ios::binary);
    return static_cast<bool>((probe << std::string(std::size_t{4} << 20, ' ')).flush());
  }

  [[noreturn]] static void refuse(Refusal refusal, std::string message, std::string details = {},
                                  std::vector<Finding> findings = {}) {
    throw Refused{refusal, std::move(message), std::move(details), std::move(findings)};
  }

  const CompileTask& task_;
  const Toolchain& toolchain_;
  const Compiler& compiler_;
};

}  // namespace

Compilation compile(const CompileTask& task, const Toolchain& toolchain, const fs::path& cache_directory,
                    const CompileLimits& limits) {
  const Clock::time_point start = Clock::now();
  Compilation result;
  const auto refuse = [&](Refusal refusal, const std::string& message) {
    result.refusal = refusal;
    result.message = message;
  };
  try {
    const std::string source = read_source(task.file);
    const std::string file_name = shown_name(task.file);
    require_complete(toolchain, task.exercise);
    const BuildCache cache(fs::absolute(cache_directory));
    const std::string key = cache_key(toolchain, task.exercise, file_name, source);
    result.executable = cache.find(key);
    result.from_cache = result.executable.has_value();
    if (!result.executable) {
      const Workspace workspace(cache.directory());
      const Compiler compiler(toolchain, limits, file_name, workspace.directory());
      result.executable = cache.keep(CompilationInProgress(task, toolchain, compiler).run(source), key);
    }
  } catch (const Refused& reason) {
    refuse(reason.refusal, reason.message);
    result.details = reason.details;
    result.findings = reason.findings;
  } catch (const RejectedFile& error) {
    refuse(Refusal::rejected_file, error.what());
  } catch (const ToolchainError& error) {
    refuse(Refusal::checker_error, error.what());
  } catch (const CacheError& error) {
    refuse(Refusal::checker_error, error.what());
  } catch (const fs::filesystem_error& error) {
    refuse(Refusal::checker_error, messages::cannot_compile(error.what()));
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

Observation refused(const Compilation& compilation) {
  Observation observation;
  observation.refusal = compilation.refusal;
  observation.refusal_message = compilation.message;
  observation.refusal_details = compilation.details;
  observation.findings = compilation.findings;
  observation.compile_seconds = compilation.seconds;
  return observation;
}

}  // namespace workbook
