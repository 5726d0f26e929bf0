/// @file
/// Control groups of Linux (cgroups): limits that hold for a program together with all that it starts.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace workbook {

/// The folders below which a user may make groups that limit memory and processes: one with version 2, and one of each
/// controller with version 1. They lie below the groups of this program, which with version 2 must be alone in its
/// group, as `systemd-run --user --scope -p Delegate=yes` starts it, and moves one below.
/// @param user  who gets them if this program is root. @throws LaunchError that says why there are none
std::vector<std::string> control_groups_for(uid_t user);

/// The group of one program. With this object it is gone, and whatever still runs in it.
class ControlGroup {
 public:
  /// @throws LaunchError
  ControlGroup(const std::vector<std::string>& parents, std::size_t memory_bytes, unsigned processes);
  ~ControlGroup();
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  /// Moves the calling process into it. For Launch::prepare: makes system calls only. Returns the step that failed, or
  /// nullptr.
  const char* enter() const noexcept;

 private:
  std::vector<std::string> folders_;
  std::vector<std::string> members_;  ///< the files that take the numbers of processes
};

}  // namespace workbook
