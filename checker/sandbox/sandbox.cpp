#include "checker/sandbox/sandbox.hpp"

#include "checker/base/child_process.hpp"

#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/personality.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace workbook {
namespace {

// --- rules for files, by the numbers of the kernel: the headers of many systems are older than it

namespace landlock {

constexpr long create_ruleset = 444, add_rule = 445, restrict_self = 446;

struct Ruleset {
  std::uint64_t files, network, scopes;
};

struct [[gnu::packed]] PathBeneath {
  std::uint64_t allowed;
  std::int32_t parent;
};

constexpr std::uint64_t execute = 1, write_file = 2, read_file = 4, read_folder = 8, truncate = 1 << 14,
                        device = 1 << 15;
constexpr std::uint64_t reading = execute | read_file | read_folder;

bool allow(int ruleset, int file, std::uint64_t access) {
  struct stat status {};
  if (::fstat(file, &status) != 0) return false;
  if (!S_ISDIR(status.st_mode)) access &= execute | write_file | read_file | truncate | device;
  const PathBeneath rule{access, file};
  return ::syscall(add_rule, ruleset, 1, &rule, 0) == 0;
}

/// What is not there needs no rule.
bool allow(int ruleset, const std::string& path, std::uint64_t access) {
  const int file = ::open(path.c_str(), O_PATH | O_CLOEXEC);
  if (file < 0) return errno == ENOENT || errno == ENOTDIR || errno == EACCES;
  const bool allowed = allow(ruleset, file, access);
  ::close(file);
  return allowed;
}

}  // namespace landlock

const char* limit_resources(const SandboxProfile& profile) noexcept {
  const rlim_t memory = profile.memory_bytes == 0 ? RLIM_INFINITY : profile.memory_bytes;
  const rlim_t processes = profile.calls == SandboxProfile::Calls::build ? RLIM_INFINITY : 0;
  const struct {
    decltype(RLIMIT_CPU) resource;
    rlim_t soft;
    const char* step;
    rlim_t added = 0;  // to the hard limit
  } limits[] = {       // Not 0, with which a system that hands core dumps to a collector would still start it.
                {RLIMIT_CORE, 1, "limit core dumps"},
                // The hard limit ends a program that ignores the signal of the soft one.
                {RLIMIT_CPU, profile.processor_seconds, "limit its processor time", 1},
                {RLIMIT_AS, memory, "limit its memory"},
                {RLIMIT_STACK, profile.stack_bytes, "limit its stack"},
                {RLIMIT_FSIZE, profile.file_bytes, "limit the size of its files"},
                {RLIMIT_NPROC, processes, "limit its processes"},
                {RLIMIT_NOFILE, profile.open_files, "limit its open files"}};
  for (const auto& limit : limits) {
    rlimit now{};
    if (::getrlimit(limit.resource, &now) != 0) return limit.step;
    const rlimit wanted{std::min(limit.soft, now.rlim_max), std::min(limit.soft + limit.added, now.rlim_max)};
    if (::setrlimit(limit.resource, &wanted) != 0) return limit.step;
  }
  // Sanitizers of GCC 12 find no room for their tables where newer kernels scatter addresses widely.
  if (profile.calls == SandboxProfile::Calls::compute_and_read) ::personality(ADDR_NO_RANDOMIZE);
  return nullptr;
}

const char* restrict_files(const SandboxProfile& profile, int version) noexcept {
  if (version == 0) return nullptr;
  // All that a version knows: 13 kinds of access, and one more with versions 2, 3 and 5; network from 4, scopes from 6.
  const std::uint64_t all = (std::uint64_t{1} << (13 + (version >= 2) + (version >= 3) + (version >= 5))) - 1;
  const landlock::Ruleset rules{all, version >= 4 ? 3U : 0U, version >= 6 ? 3U : 0U};
  const int ruleset = static_cast<int>(::syscall(landlock::create_ruleset, &rules, sizeof rules, 0));
  bool done = ruleset >= 0;
  if (profile.calls != SandboxProfile::Calls::build && ::fcntl(program_descriptor, F_GETFD) >= 0)
    done = done && landlock::allow(ruleset, program_descriptor, landlock::reading);
  for (const std::string& path : profile.readable) done = done && landlock::allow(ruleset, path, landlock::reading);
  for (const std::string& path : profile.writable) done = done && landlock::allow(ruleset, path, all);
  done = done && ::syscall(landlock::restrict_self, ruleset, 0) == 0;
  if (ruleset >= 0) ::close(ruleset);
  return done ? nullptr : "restrict its files";
}

const char* filter_system_calls(const std::vector<std::uint64_t>& filter) noexcept {
  std::array<sock_filter, 1024> code;  // between fork and exec nothing may be allocated
  const std::size_t size = filter.size();
  if (size == 0) return nullptr;  // a kernel without: confine() says so in its tier
  if (size > code.size()) return "find its filter of system calls";
  std::memcpy(code.data(), filter.data(), size * sizeof(sock_filter));
  for (std::size_t k = 0; k < size; ++k)
    if (code[k].k == own_process) code[k].k = static_cast<std::uint32_t>(::getpid());
  const sock_fprog program{static_cast<unsigned short>(size), code.data()};
  return ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) == 0 ? nullptr : "filter its system calls";
}

}  // namespace

SandboxStrength what_the_kernel_offers() {
  constexpr unsigned ask_version = 1;
  const long version = ::syscall(landlock::create_ruleset, nullptr, 0, ask_version);
  SandboxStrength strength;
  strength.filters_system_calls = ::prctl(PR_GET_SECCOMP) >= 0 || errno != EINVAL;
  strength.landlock = std::max(0, static_cast<int>(version));
  return strength;
}

std::vector<std::string> to_arguments(const SandboxProfile& profile) {
  std::vector<std::string> words;
  for (const std::size_t number :
       {static_cast<std::size_t>(profile.calls), std::size_t{profile.processor_seconds}, profile.memory_bytes,
        profile.stack_bytes, profile.file_bytes, std::size_t{profile.open_files}, profile.filter.size(),
        profile.readable.size(), profile.writable.size()})
    words.push_back(std::to_string(number));
  for (const std::uint64_t instruction : profile.filter) words.push_back(std::to_string(instruction));
  for (const auto* paths : {&profile.readable, &profile.writable})
    words.insert(words.end(), paths->begin(), paths->end());
  return words;
}

SandboxProfile read_profile(char**& words) {
  const auto number = [&] { return std::strtoull(*words++, nullptr, 10); };
  SandboxProfile profile;
  profile.calls = static_cast<SandboxProfile::Calls>(number());
  profile.processor_seconds = static_cast<unsigned>(number());
  profile.memory_bytes = number();
  profile.stack_bytes = number();
  profile.file_bytes = number();
  profile.open_files = static_cast<unsigned>(number());
  profile.filter.resize(number());
  profile.readable.resize(number());
  profile.writable.resize(number());
  for (std::uint64_t& instruction : profile.filter) instruction = number();
  for (auto* paths : {&profile.readable, &profile.writable})
    for (std::string& path : *paths) path = *words++;
  return profile;
}

const char* enter_sandbox(const SandboxProfile& profile, int landlock) noexcept {
  if (const char* failed = limit_resources(profile)) return failed;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return "give up privileges";
  if (const char* failed = restrict_files(profile, landlock)) return failed;
  return filter_system_calls(profile.filter);
}

}  // namespace workbook
