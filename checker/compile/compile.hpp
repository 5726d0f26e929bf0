/// @file
/// From a student's file to an executable worker.
#pragma once

#include "checker/base/child_process.hpp"
#include "checker/compile/diagnostics.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/data/observation.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/source/submission.hpp"

namespace workbook {

/// What the compiler may use for one file.
struct CompileLimits {
  limits::Seconds time = limits::compile_time;  ///< of a processor, own functions and the linker included
  std::size_t memory_bytes = limits::compile_memory;
  std::size_t output_bytes = limits::compile_output;
  std::size_t file_bytes = limits::compile_file;  ///< of each file that it writes
};

/// A file, and the exercise that it is for.
struct CompileTask {
  const Submission& submission;
  std::string exercise;   ///< its worker is found under this name
  std::string signature;  ///< as the contract declares it
};

struct Compilation {
  std::optional<std::filesystem::path> executable = {};  ///< in the cache, which may drop it
  std::shared_ptr<const Descriptor> opened = {};         ///< which it may not
  bool from_cache = false;
  double seconds = 0.0;
  double processor_seconds = 0.0;
  std::string compiler_output = {};      ///< the warnings, for source_findings()
  std::vector<std::string> linked = {};  ///< own functions of earlier exercises that it calls, and that these call

  // Where there is no executable:
  Refusal refusal = Refusal::checker_error;
  std::string message = {};         ///< one sentence
  std::string details = {};         ///< the errors as the compiler printed them
  std::vector<Reason> errors = {};  ///< the first error, with its line

  /// @pre there is an executable
  Program program() const { return {*executable, opened}; }
};

/// Compiles the file alone and links it with the worker of its exercise, and with the functions of its library that it
/// calls. Never throws for anything that a student or a broken installation can cause.
Compilation compile(const CompileTask& task, const Toolchain& toolchain, const std::filesystem::path& cache_directory,
                    const CompileLimits& limits = {});

/// Lines for between the contracts and the text of a file, after which its own_names collide with no declaration of a
/// contract.
std::string renaming(const Submission& file);

/// What to judge where nothing could run. @pre there is no executable
Observation refused(const Compilation& compilation);

/// Mistakes in a file that compiles but fails: what its text, the compiler's warnings and the check for kept
/// expressions give away. What is certainly so and may be what is wrong, by line; a few at most. Whatever goes wrong
/// here means only that nothing is found. Where the file says `auto`, it is compiled once more for that.
std::vector<Reason> source_findings(const CompileTask& task, const Compilation& compilation, const Toolchain& toolchain,
                                    const std::filesystem::path& cache_directory,
                                    const CompileLimits& limits = {.time = limits::repair_compile_time});

/// A directory of entries, each a directory with an executable and all that it was made from. Entries appear and
/// disappear at once (by renaming), so several checkers may share a cache. A damaged entry counts as absent.
class BuildCache {
 public:
  /// @param most_entries  stub, solution and a draft of every exercise, or a check of all finds none of the last one
  /// @throws std::runtime_error if the directory cannot be made
  explicit BuildCache(std::filesystem::path directory, std::size_t most_entries = 300);

  /// What was made from exactly this key.
  std::optional<Compilation> find(const std::string& key) const;

  /// Takes the executable, a file in a directory on the same file system, into the cache; drops what was not used for
  /// longest. Returns where it is now. @throws std::runtime_error
  Compilation keep(Compilation built, const std::string& key) const;

  const std::filesystem::path& directory() const { return directory_; }

 private:
  void drop_oldest() const;

  std::filesystem::path directory_;
  std::size_t most_entries_;
};

/// A new private directory, removed with all it holds at the end.
class Workspace {
 public:
  /// @throws std::runtime_error
  explicit Workspace(const std::filesystem::path& parent);
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

/// Compilations in one directory, where the file is called unit.cpp, whatever its name is. All together end at the
/// limit of time.
class Compiler {
 public:
  Compiler(const Toolchain& toolchain, const CompileLimits& limits, std::filesystem::path workspace)
      : toolchain_(toolchain),
        limits_(limits),
        workspace_(std::move(workspace)),
        deadline_(Clock::now() +
                  std::chrono::duration_cast<Clock::duration>(limits::compile_time_on_busy_machines * limits.time)) {}

  /// Writes unit.cpp, or a file of another name; `before` stands before its first line and is not counted. Templates
  /// that are instantiated already are declared for all that is compiled from then on.
  /// @throws std::runtime_error if it cannot be written
  void write(std::string_view source, const std::string& before = {}, const std::string& name = unit_name) const;

  /// Arguments that compile with the flags of the workers, and some more.
  std::vector<std::string> arguments(const std::vector<std::string>& more) const;

  /// Runs the compiler; what it printed comes back safe to show. @throws ToolchainError if it cannot be started
  FinishedProgram run(std::vector<std::string> arguments) const {
    return run(toolchain_.compiler, std::move(arguments), limits_);
  }

  /// Runs nm, which takes a moment and little memory unless a name in the object is made to need more.
  FinishedProgram run_nm(std::vector<std::string> arguments) const {
    return run(toolchain_.nm, std::move(arguments), {.time = std::chrono::seconds(5), .memory_bytes = 256u << 20});
  }

  /// Takes apart what it printed.
  CompilerOutput read(std::string_view output, const std::string& shown_name) const;

  /// May a student's file include this one? Headers of the course and of the system only: others hold the answers.
  bool may_be_included(const std::string& file) const;

  /// What to link for the files that were written.
  const std::vector<Instantiation>& instantiated() const { return instantiated_; }

  const std::filesystem::path& workspace() const { return workspace_; }
  double processor_seconds() const { return used_; }  ///< of all that was run so far

 private:
  FinishedProgram run(const std::filesystem::path& program, std::vector<std::string> arguments,
                      const CompileLimits& limits) const;

  const Toolchain& toolchain_;
  const CompileLimits& limits_;
  const std::filesystem::path workspace_;
  const Clock::time_point deadline_;
  mutable std::vector<Instantiation> instantiated_ = {};
  mutable double used_ = 0.0;
};

}  // namespace workbook
