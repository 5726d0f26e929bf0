#include "checker/sandbox/control_group.hpp"

#include "checker/base/child_process.hpp"
#include "checker/base/text.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace workbook {
namespace {

namespace fs = std::filesystem;

constexpr const char* members = "/cgroup.procs";
constexpr const char* own_name = "workbook-checker";

/// Into a file of the kernel: in one piece, and never creating it.
bool put(const std::string& file, std::string_view text) noexcept {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  const bool done = descriptor >= 0 && ::write(descriptor, text.data(), text.size()) >= 0;
  const int problem = errno;
  if (descriptor >= 0) ::close(descriptor);
  errno = problem;
  return done;
}

/// The group of this program.
/// @param controller  of version 1; "" for version 2. @returns "" if there is none
std::string own_group(const std::string& controller) {
  const auto line_of = [](const char* file, const std::string& pattern) {
    return search(read_file(file).value_or(""), "(?:^|\n)" + pattern);
  };
  const std::string name = controller.empty() ? "" : "(?:[^:\n]*,)?" + controller + "(?:,[^:\n]*)?";
  const std::string type = controller.empty() ? "cgroup2 " : "cgroup \\S+ (?:\\S+,)?" + controller + "[,\n]";
  const Match own = line_of("/proc/self/cgroup", "\\d+:" + name + ":([^\n]*)");  // "4:memory:/a/b", "0::/a/b"
  // "32 31 0:29 ROOT PLACE rw - TYPE NAME rw,memory"
  const Match mount = line_of("/proc/self/mountinfo", "\\S+ \\S+ \\S+ (\\S+) (\\S+) [^\n]*- " + type);
  if (!own || !mount) return "";
  std::string group = own[1];
  if (mount[1] != "/" && group.starts_with(mount[1])) group.erase(0, mount[1].size());
  return mount[2] + (group == "/" ? "" : group);
}

bool give_to(uid_t user, std::initializer_list<std::string> files) {
  return std::ranges::all_of(
      files, [&](const std::string& file) { return ::geteuid() != 0 || ::lchown(file.c_str(), user, user) == 0; });
}

constexpr std::string_view group_prefix = "run-";  ///< "run-PID-NUMBER"

/// What earlier runs have left that were killed. Groups of others that run now stay, although some are still empty.
void remove_groups_below(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(group_prefix)) continue;
    const auto maker = static_cast<pid_t>(std::strtol(name.c_str() + group_prefix.size(), nullptr, 10));
    if (maker > 0 && ::kill(maker, 0) != 0 && errno == ESRCH) ::rmdir(entry.path().c_str());
  }
}

/// Of version 2, whose groups have either processes or groups of their own. @throws LaunchError
std::string unified_group_for(uid_t user) {
  std::string group = own_group("");
  if (group.ends_with(own_name)) return fs::path(group).parent_path().string();
  const std::string controllers = read_file(group + "/cgroup.controllers").value_or("");
  if (group.empty() || !search(controllers, "\\bmemory\\b") || !search(controllers, "\\bpids\\b"))
    throw LaunchError("no control group with the controllers memory and pids is handed over to this program");
  const std::string own = group + "/" + own_name, pid = std::to_string(::getpid());
  const bool moved = (::mkdir(own.c_str(), 0755) == 0 || errno == EEXIST) && put(own + members, pid);
  if (moved && put(group + "/cgroup.subtree_control", "+memory +pids") && give_to(user, {group, group + members}))
    return group;
  const LaunchError problem(fmt::format("the control group {} cannot be divided ({})", group, std::strerror(errno)));
  if (moved) put(group + members, pid);
  ::rmdir(own.c_str());
  throw problem;
}

}  // namespace

std::vector<std::string> control_groups_for(uid_t user) {
  std::vector<std::string> folders;
  for (const char* controller : {"memory", "pids"}) {
    const std::string own = own_group(controller);
    if (own.empty()) break;
    const std::string folder = fmt::format("{}/workbook-{}", own, user);
    if ((::mkdir(folder.c_str(), 0755) != 0 && errno != EEXIST) || !give_to(user, {folder}))
      throw LaunchError(fmt::format("{} cannot be made ({})", folder, std::strerror(errno)));
    folders.push_back(folder);
  }
  if (folders.size() < 2) folders = {unified_group_for(user)};
  std::ranges::for_each(folders, remove_groups_below);
  return folders;
}

ControlGroup::ControlGroup(const std::vector<std::string>& parents, std::size_t memory_bytes, unsigned processes) {
  static std::atomic<unsigned> made = 0;
  const std::string name = fmt::format("/{}{}-{}", group_prefix, ::getpid(), ++made);
  const std::string memory = std::to_string(memory_bytes), count = std::to_string(processes);
  for (const std::string& parent : parents) {
    const std::string folder = folders_.emplace_back(parent + name);
    members_.push_back(folder + members);
    bool done = ::mkdir(folder.c_str(), 0755) == 0 || errno == EEXIST;
    // Which of them are there depends on the version, and on whether the kernel counts what is swapped out.
    for (const auto& [file, limit] : {std::pair{"/memory.max", memory.c_str()},
                                      {"/memory.swap.max", "0"},
                                      {"/memory.limit_in_bytes", memory.c_str()},
                                      {"/memory.memsw.limit_in_bytes", memory.c_str()},
                                      {"/pids.max", count.c_str()}})
      done = done && (put(folder + file, limit) || errno == ENOENT);
    if (done) continue;
    const int problem = errno;
    for (const std::string& each : folders_) ::rmdir(each.c_str());
    throw LaunchError("make a control group", problem);
  }
}

ControlGroup::~ControlGroup() {
  for (std::size_t k = 0; k < folders_.size(); ++k)
    for (int attempt = 0; ::rmdir(folders_[k].c_str()) != 0 && errno == EBUSY && attempt < 1000; ++attempt) {
      std::ifstream left(members_[k]);
      for (pid_t process = 0; left >> process;) ::kill(process, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

const char* ControlGroup::enter() const noexcept {
  return std::ranges::all_of(members_, [](const std::string& file) { return put(file, "0"); })
             ? nullptr
             : "enter a control group";
}

}  // namespace workbook
