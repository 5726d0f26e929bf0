/// @file
/// The sandbox: what a program that comes from a student, or reads a student's file, may do and use. Resource limits, a
/// filter of system calls (seccomp) and rules for files (Landlock), set up in the new process before the program
/// starts. In the strongest tier that process stands in namespaces of its own (bubblewrap), where nothing else exists.
#pragma once

#include "checker/sandbox/limits.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace workbook {

struct Launch;

/// From weakest to strongest.
enum class SandboxTier {
  none,     ///< limits on time, memory and output only
  minimal,  ///< and a filter of system calls: a function reaches nothing, but a compiler can read every file
  reduced,  ///< and rules for files, for the compiler too
  full,     ///< and namespaces: no network, no other process, no file but those that the program needs
  grouped   ///< and a control group, which limits a program together with all that it starts
};

/// What sandboxes hold back on this machine.
struct SandboxStrength {
  bool filters_system_calls = false;
  int landlock = 0;                     ///< its version; 0: this kernel has none
  std::vector<std::string> holes;       ///< what a program in a sandbox could do although it must not: "read a file"
  std::vector<std::string> namespaces;  ///< the beginning of the command that makes them; empty: there are none
  std::string no_namespaces;            ///< why there are none, and what to do about it
  std::vector<std::string> control_groups;  ///< below which each program gets one of its own; empty: there are none
  std::string no_control_groups;            ///< why there are none

  SandboxTier tier() const;
  std::string sentence() const;
};

/// Found out by starting programs that try; what root must not start, as a user without rights.
/// @param user  who will use it, if this program is root and gives that up
SandboxStrength probe_sandbox(uid_t user = ::geteuid());

/// Of the kernel alone.
SandboxStrength what_the_kernel_offers();

/// From now on all programs get as strong a sandbox as that, apart from root's, who gets no namespaces. Before, it is
/// what the kernel offers: a single check is a student's own code, and starts quicker without namespaces.
void use_sandbox(const SandboxStrength& strength);

/// Unless a sandbox was chosen: tries what the kernel offers, or takes it from a file in which an earlier call wrote
/// that everything is held back on this kernel. Trying starts a program for every wall, half the time of a check.
void try_sandbox_once(const std::filesystem::path& known);

/// The first call tries what the kernel offers, unless a sandbox was chosen: make it before starting processes that use
/// it.
const SandboxStrength& sandbox_in_use();

/// Are there both a filter of system calls and rules for files?
bool can_confine_files();

/// "reduced"
std::string to_string(SandboxTier tier);

/// What one kind of program may do. Everything that is not named is denied.
struct SandboxProfile {
  enum class Calls {
    compute,           ///< compute, print, sleep, look at the clock
    compute_and_read,  ///< and open files for reading
    build              ///< all but what no compiler needs
  };

  Calls calls = Calls::compute;
  unsigned processor_seconds = static_cast<unsigned>(limits::run_processor_time.count());
  std::size_t memory_bytes = limits::run_memory;  ///< of addresses; 0: not limited
  std::size_t stack_bytes = limits::run_stack;
  std::size_t file_bytes = 0;  ///< of each file that is written
  unsigned open_files = limits::run_files;
  std::vector<std::uint64_t> filter = {};  ///< of system calls, as confine() sets it: instructions for the kernel
  std::vector<std::string> readable = {};  ///< files and folders with all that is in them; programs there may be run
  std::vector<std::string> writable = {};  ///< the same
};

/// A student's function in its worker: linked statically, no files.
SandboxProfile run_profile();

/// The same function beside the sanitizers' runtimes, which reserve terabytes of addresses and read shared libraries,
/// their own program and what the kernel tells of it. Whoever starts it must watch its memory.
SandboxProfile diagnose_profile(const std::string& compiler, const std::string& program);

/// Compiler, assembler and linker.
/// @param inputs  what they read besides the folders of the system and of the compiler. @param workspace  where they
/// write
SandboxProfile compile_profile(const std::string& compiler, const std::vector<std::string>& inputs,
                               const std::string& workspace);

/// Stands in a filter for the number of the new process. No process has it: Linux numbers end at 2²².
inline constexpr std::uint32_t own_process = 0x5e1f5e1f;

/// What the kernel runs at every system call of such a program. @throws LaunchError
const std::vector<std::uint64_t>& system_call_filter(SandboxProfile::Calls calls);

/// As words of a command, and back: `words` is moved past what was read.
std::vector<std::string> to_arguments(const SandboxProfile& profile);
SandboxProfile read_profile(char**& words);

/// Starts it in a sandbox of the tier in use.
void confine(Launch& launch, const SandboxProfile& profile);

/// For Launch::prepare: sets up limits, rules and filter in the new process. Makes system calls only.
/// @param landlock  its version; 0: there are no rules for files. @returns the step that failed, or nullptr
const char* enter_sandbox(const SandboxProfile& profile, int landlock) noexcept;

}  // namespace workbook
