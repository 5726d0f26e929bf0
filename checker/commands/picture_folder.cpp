#include "checker/commands/picture_folder.hpp"

#include "checker/messages/plotting.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace workbook {

bool make_picture_folder(const std::filesystem::path& directory) {
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (!problem && access(directory.c_str(), W_OK) != 0) problem.assign(errno, std::generic_category());
  if (problem) fmt::print(stderr, "{}\n", messages::folder_not_usable(directory.string(), problem.message()));
  return !problem;
}

}  // namespace workbook
