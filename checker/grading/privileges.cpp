#include "checker/grading/grading.hpp"

#include <pwd.h>
#include <sys/stat.h>

namespace workbook {
namespace {

constexpr uid_t first_unused = 64000, last_unused = 64999;

bool is_unused(uid_t user) { return user >= first_unused && user <= last_unused && ::getpwuid(user) == nullptr; }

}  // namespace

uid_t grading_user(const fs::path& folder) {
  if (::geteuid() != 0) return ::geteuid();
  struct stat status {};
  if (::stat(folder.c_str(), &status) == 0 && is_unused(status.st_uid)) return status.st_uid;
  if (status.st_uid != 0)
    throw GradingError(fmt::format("{} belongs to another user: grade as that user.", shown_path(folder)));
  for (uid_t user = first_unused; user <= last_unused; ++user)
    if (is_unused(user)) return user;
  throw GradingError("There is no unused user id to give up root for; grade as an ordinary user.");
}

void give_up_root(const fs::path& folder, const std::vector<fs::path>& needed, bool starts_other_users) {
  if (::geteuid() != 0) return;
  const uid_t user = grading_user(folder);
  bool done = ::lchown(folder.c_str(), user, user) == 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    struct stat status {};
    if (::lstat(entry.path().c_str(), &status) == 0 && status.st_uid != user)
      done = ::lchown(entry.path().c_str(), user, user) == 0 && done;
  }
  done = done && become_user(user, starts_other_users) && ::setuid(0) != 0;
  if (!done) throw GradingError("Root cannot be given up here; grade as an ordinary user.");
  for (const fs::path& file : needed)
    if (::access(file.c_str(), R_OK) != 0)
      throw GradingError(
          fmt::format("{} cannot be read without root: grade as an ordinary user, or move it to where all may read.",
                      shown_path(file)));
}

}  // namespace workbook
