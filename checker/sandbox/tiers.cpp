// Which sandbox a program gets on this machine.
#include "checker/base/child_process.hpp"
#include "checker/base/text.hpp"
#include "checker/sandbox/control_group.hpp"
#include "checker/sandbox/last_stage/attempts.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <nlohmann/json.hpp>

#include <sys/utsname.h>

#include <algorithm>
#include <cerrno>
#include <csignal>

namespace workbook {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SandboxStrength, filters_system_calls, landlock, holes, namespaces, no_namespaces)

namespace {

using Calls = SandboxProfile::Calls;

constexpr const char* newer_option = "--disable-userns";  ///< of bubblewrap since version 0.8

void confine_to(const SandboxStrength& strength, Launch& launch, SandboxProfile profile) {
  if (strength.filters_system_calls) profile.filter = system_call_filter(profile.calls);
  if (strength.namespaces.empty() || ::geteuid() == 0) {
    // As a user of its own no function reaches another one's process, even if a rule had a hole.
    const bool is_function = profile.calls == Calls::compute;
    launch.prepare = [is_function, profile = std::move(profile), landlock = strength.landlock] {
      const char* const failed = is_function ? become_unique_user() : nullptr;
      return failed ? failed : enter_sandbox(profile, landlock);
    };
    return;
  }
  const bool builds = profile.calls == Calls::build;
  if (!strength.control_groups.empty()) {
    // Where addresses cannot be limited, whoever starts the program watches its memory and stops it before this does.
    const std::size_t memory = profile.memory_bytes == 0 ? 2 * limits::diagnostic_memory : profile.memory_bytes;
    const unsigned processes = builds ? limits::compile_processes : limits::run_processes;
    const auto group = std::make_shared<const ControlGroup>(strength.control_groups, memory, processes);
    launch.prepare = [members = group.get()] { return members->enter(); };
    launch.held = group;
  }
  std::vector<std::string>& command = launch.namespaces;
  command = strength.namespaces;
  const bool has_files = builds && profile.file_bytes > 0 && std::ranges::count(command, newer_option) > 0;
  if (has_files)
    command.insert(command.end(), {"--size", std::to_string(limits::compile_temporary), "--tmpfs", "/tmp", "--setenv",
                                   "TMPDIR", "/tmp"});
  for (const std::string& path : profile.readable)
    if (path == "/proc/self")
      command.insert(command.end(), {"--proc", "/proc"});
    else
      command.insert(command.end(), {"--ro-bind-try", path, path});
  for (const std::string& path : profile.writable) command.insert(command.end(), {"--dev-bind-try", path, path});
  if (has_files) profile.writable.emplace_back("/tmp");
  command.insert(command.end(), {"--ro-bind", WORKBOOK_LAST_STAGE, "/last_stage", "--remount-ro", "/", "/last_stage"});
  std::ranges::move(to_arguments(profile), std::back_inserter(command));
}

/// Where shared libraries are installed, and compilers, never anybody's own files.
std::vector<std::string> system_folders(const std::string& compiler, std::initializer_list<const char*> kinds) {
  std::vector<std::string> folders = {"/etc/ld.so.cache", "/etc/alternatives", "/lib", "/lib64", "/nix/store"};
  std::error_code error;
  const std::filesystem::path program = std::filesystem::canonical(compiler, error);
  for (const std::filesystem::path& prefix :
       {std::filesystem::path("/usr"), std::filesystem::path("/usr/local"), program.parent_path().parent_path()})
    for (const char* kind : kinds)
      if (const std::string folder = (prefix / kind).string();
          !prefix.empty() && std::ranges::count(folders, folder) == 0)
        folders.push_back(folder);
  return folders;
}

/// What a program gets done that is started like every student's function and every compiler. @throws LaunchError
std::vector<std::string> holes_of(const SandboxStrength& strength) {
  std::vector<std::string> holes;
  const bool confines_files = strength.landlock > 0 || !strength.namespaces.empty();
  for (const Calls calls : {Calls::compute, Calls::compute_and_read, Calls::build}) {
    if (calls != Calls::compute && !confines_files) continue;
    Launch launch;
    launch.program = WORKBOOK_LAST_STAGE;
    launch.with_channel = calls != Calls::build;
    SandboxProfile profile{.calls = calls, .readable = {WORKBOOK_LAST_STAGE}};
    if (calls == Calls::compute_and_read) profile.readable.emplace_back("/proc/self");
    confine_to(strength, launch, profile);
    for (std::size_t k = 0; k < std::size(attempts); ++k) {
      if (calls == Calls::build && !attempts[k].is_for_compilers) continue;
      // A process for each: the filter may end it, and where the C library blocks signals nothing in it can go on.
      launch.arguments = {std::to_string(k)};
      const FinishedProgram tried = run_program(launch, std::chrono::seconds(10), 1000);
      const bool is_held = tried.succeeded() || tried.end.signal == SIGSYS;
      if (is_held || std::ranges::count(holes, attempts[k].what) > 0) continue;
      if (tried.out_of_time || tried.end.signal != 0 || tried.end.exit_status != 1)
        throw LaunchError(fmt::format("a program that tries to {} ends in no way that tells", attempts[k].what));
      holes.emplace_back(attempts[k].what);
    }
  }
  return holes;
}

/// Fills in the namespaces, or why there are none.
void try_namespaces(SandboxStrength& strength) {
  const std::string program = program_on_path("bwrap");
  if (program.empty()) {
    strength.no_namespaces = "bubblewrap is missing (on Debian: apt-get install bubblewrap)";
    return;
  }
  // The oldest versions cannot do all.
  for (const bool disables_more : {true, false}) {
    SandboxStrength full = strength;
    full.namespaces = {program, "--unshare-all", "--unshare-user"};
    if (disables_more) full.namespaces.emplace_back(newer_option);
    for (const char* word : {"--uid", "65534", "--gid", "65534", "--as-pid-1", "--die-with-parent"})
      full.namespaces.emplace_back(word);
    try {
      const std::vector<std::string> holes = holes_of(full);
      strength.no_namespaces = holes.empty() ? "" : fmt::format("a program in them can {}", fmt::join(holes, ", "));
      if (!holes.empty()) return;
      strength.namespaces = full.namespaces;
      return;
    } catch (const LaunchError& problem) {
      if (strength.no_namespaces.empty()) strength.no_namespaces = problem.what();
    }
  }
  strength.no_namespaces +=
      "; user namespaces may be turned off here (sysctl kernel.unprivileged_userns_clone=1 or "
      "kernel.apparmor_restrict_unprivileged_userns=0), or not allowed in this container";
}

/// As root, bubblewrap would leave settings of the kernel writable. @throws LaunchError
void try_namespaces_as_nobody(SandboxStrength& strength) {
  ForkedJob job(
      [&] {
        constexpr uid_t nobody = 65534;
        if (!become_user(nobody)) throw LaunchError("give up root", errno);
        try_namespaces(strength);
        return nlohmann::json(strength).dump();
      },
      std::chrono::minutes(1));
  if (job.finish().empty())
    nlohmann::json::parse(job.output()).get_to(strength);
  else
    strength.no_namespaces = "root cannot be given up here";
}

/// Fills in the control groups, or why there are none.
void try_control_groups(SandboxStrength& strength, uid_t user) {
  try {
    std::vector<std::string> groups = control_groups_for(user);
    const ControlGroup tried(groups, std::size_t{512} << 20, 16);
    strength.control_groups = std::move(groups);
  } catch (const LaunchError& problem) {
    strength.no_control_groups = problem.what();
  }
}

/// What the kernel alone holds back, tried.
SandboxStrength without_namespaces() {
  SandboxStrength strength = what_the_kernel_offers();
  try {
    strength.holes = holes_of(strength);
  } catch (const LaunchError& problem) {
    strength.holes = {fmt::format("do what you can ({})", problem.what())};
  }
  return strength;
}

/// Nothing before it was tried or chosen.
std::optional<SandboxStrength>& chosen() {
  static std::optional<SandboxStrength> strength;
  return strength;
}

/// What a result of trying depends on.
std::string circumstances(const SandboxStrength& offered) {
  utsname system{};
  ::uname(&system);
  std::error_code ignored;
  return fmt::format("{} {} {} {} {} {} {}\n", system.release, system.version,
                     read_file("/proc/sys/kernel/random/boot_id").value_or(""), ::geteuid(), offered.landlock,
                     std::filesystem::file_size(WORKBOOK_LAST_STAGE, ignored),
                     std::filesystem::last_write_time(WORKBOOK_LAST_STAGE, ignored).time_since_epoch().count());
}

}  // namespace

SandboxStrength probe_sandbox(uid_t user) {
  SandboxStrength strength = without_namespaces();
  if (strength.tier() == SandboxTier::none) return strength;
  try {
    if (::geteuid() == 0)
      try_namespaces_as_nobody(strength);
    else
      try_namespaces(strength);
    if (!strength.namespaces.empty()) try_control_groups(strength, user);
  } catch (const LaunchError& problem) {
    strength.no_namespaces = problem.what();
  }
  return strength;
}

void use_sandbox(const SandboxStrength& strength) { chosen() = strength; }

void try_sandbox_once(const std::filesystem::path& known) {
  if (chosen()) return;
  const SandboxStrength offered = what_the_kernel_offers();
  const std::string now = circumstances(offered);
  if (offered.filters_system_calls && read_file(known) == now) {
    chosen() = offered;
  } else if (sandbox_in_use().holes.empty() && sandbox_in_use().filters_system_calls) {
    write_file(known, now);  // else it is tried again
  }
}

const SandboxStrength& sandbox_in_use() {
  if (!chosen()) chosen() = without_namespaces();
  return *chosen();
}

bool can_confine_files() { return sandbox_in_use().tier() >= SandboxTier::reduced; }

void confine(Launch& launch, const SandboxProfile& profile) { confine_to(sandbox_in_use(), launch, profile); }

SandboxTier SandboxStrength::tier() const {
  if (!filters_system_calls || !holes.empty()) return SandboxTier::none;
  if (!namespaces.empty()) return control_groups.empty() ? SandboxTier::full : SandboxTier::grouped;
  return landlock > 0 ? SandboxTier::reduced : SandboxTier::minimal;
}

std::string SandboxStrength::sentence() const {
  constexpr const char* full = "a program sees no other process, no network, and of the files only what it needs";
  const std::string why = no_namespaces.empty() ? "" : fmt::format("; no namespaces: {}", no_namespaces);
  switch (tier()) {
    case SandboxTier::grouped:
      return fmt::format("full+cgroup: {}; memory and processes are limited for all that it starts together", full);
    case SandboxTier::full:
      return fmt::format("full: {} (no control groups: {})", full, no_control_groups);
    case SandboxTier::reduced:
      return "reduced: system calls are filtered, and compilers read only what they need" + why;
    case SandboxTier::minimal:
      return "minimal: system calls are filtered, but this kernel has no Landlock: a student's file can include any "
             "file that you can read" +
             why;
    default:
      return fmt::format("none: limits on time, memory and output only; a function can {}{}",
                         holes.empty() ? "do what you can" : fmt::format("{}", fmt::join(holes, ", ")), why);
  }
}

std::string to_string(SandboxTier tier) {
  constexpr const char* names[] = {"none", "minimal", "reduced", "full", "full+cgroup"};
  return names[static_cast<int>(tier)];
}

SandboxProfile run_profile() { return {}; }

SandboxProfile diagnose_profile(const std::string& compiler, const std::string& program) {
  SandboxProfile profile{.calls = Calls::compute_and_read,
                         .memory_bytes = 0,
                         .open_files = limits::diagnostic_files,
                         .readable = system_folders(compiler, {"lib", "lib64"})};
  profile.readable.insert(profile.readable.end(), {program, "/proc/self"});
  return profile;
}

SandboxProfile compile_profile(const std::string& compiler, const std::vector<std::string>& inputs,
                               const std::string& workspace) {
  SandboxProfile profile{.calls = Calls::build,
                         .processor_seconds = static_cast<unsigned>(limits::compile_time.count()),
                         .memory_bytes = limits::compile_memory,
                         .stack_bytes = limits::compile_stack,
                         .file_bytes = limits::compile_file,
                         .open_files = limits::compile_files,
                         .readable = system_folders(compiler, {"bin", "include", "lib", "lib64", "libexec"}),
                         .writable = {workspace, "/dev/null"}};
  profile.readable.insert(profile.readable.end(), inputs.begin(), inputs.end());
  return profile;
}

}  // namespace workbook
