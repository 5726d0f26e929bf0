#include "checker/base/files.hpp"

#include "checker/base/text.hpp"

#include <fcntl.h>
#include <signal.h>

#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace workbook {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const fs::path& file, std::size_t limit) {
  std::error_code problem;
  // A pipe or a device would never end.
  if (!fs::is_regular_file(file, problem) || fs::file_size(file, problem) > limit || problem) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();  // in blocks: executables and reference results are read at every check
  std::string content = std::move(text).str();
  if (in.bad() || content.size() > limit) return std::nullopt;
  return content;
}

std::string write_file(const fs::path& file, std::string_view content, std::optional<fs::perms> mode) {
  std::error_code problem;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), problem);
  const fs::path unfinished = fmt::format("{}.{}.unfinished", file.string(), ::getpid());
  errno = 0;
  std::ofstream out(unfinished, std::ios::binary);
  out << content;
  out.close();
  problem = out ? std::error_code() : std::error_code(errno == 0 ? EIO : errno, std::generic_category());
  if (!problem && mode) fs::permissions(unfinished, *mode, problem);
  if (!problem) fs::rename(unfinished, file, problem);
  std::error_code ignored;
  if (problem) fs::remove(unfinished, ignored);
  return problem ? problem.message() : "";
}

void remove_unfinished(const fs::path& folder) {
  std::error_code problem, ignored;
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator next(folder, options, problem), end; !problem && next != end;
       next.increment(problem)) {
    const fs::path& file = next->path();
    if (file.extension() != ".unfinished") continue;
    const std::string writer = file.stem().extension().string();  // .NUMBER
    const pid_t number = writer.empty() ? 0 : std::atoi(writer.c_str() + 1);
    if (number > 0 && ::kill(number, 0) != 0 && errno == ESRCH) fs::remove(file, ignored);
  }
}

void write_or_throw(const fs::path& file, std::string_view content) {
  if (const std::string reason = write_file(file, content); !reason.empty())
    throw std::runtime_error(fmt::format("{} cannot be written ({}).", shown_path(file), reason));
}

std::string file_fingerprint(const fs::path& file) {
  const auto content = read_file(file);
  return content ? fingerprint(*content) : "";
}

fs::path free_name(const fs::path& file) {
  std::error_code ignored;
  fs::path name = file;
  for (int number = 2; fs::exists(fs::symlink_status(name, ignored)); ++number)
    name = fmt::format("{}.{}", file.string(), number);
  return name;
}

std::string folder_trouble(const fs::path& folder) {
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return problem.message();
  return access(folder.c_str(), W_OK) == 0 ? "" : std::strerror(errno);
}

std::string place_trouble(const fs::path& file) {
  std::error_code problem, ignored;
  fs::path first_missing;
  for (fs::path place = fs::absolute(file).lexically_normal(); !fs::exists(place, ignored); place = place.parent_path())
    first_missing = place;
  if (first_missing.empty()) return "";
  // Only trying tells: permissions say nothing of a file system that takes no files.
  if (fs::create_directory(first_missing, problem)) fs::remove(first_missing, ignored);
  return problem ? problem.message() : "";
}

bool is_newer(const fs::path& file_or_folder, const fs::path& than) {
  std::error_code problem, ignored;
  const auto time = fs::last_write_time(than, problem);
  const auto is_later = [&](const fs::path& file) { return fs::last_write_time(file, ignored) > time; };
  if (problem) return true;
  if (!fs::is_directory(file_or_folder, ignored)) return is_later(file_or_folder);
  // Its own time is that of any file that came and went, an editor's for example.
  constexpr auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator next(file_or_folder, options, problem), end; !problem && next != end;
       next.increment(problem))  // which a folder that vanishes meanwhile ends
    if (is_later(next->path())) return true;
  return false;
}

std::string file_address(const fs::path& file) {
  std::string address = "file://";
  for (const char letter : fs::absolute(file).string())
    address += std::isalnum(static_cast<unsigned char>(letter)) != 0 || std::strchr("/._~-", letter) != nullptr
                   ? std::string(1, letter)
                   : fmt::format("%{:02X}", static_cast<unsigned char>(letter));
  return address;
}

std::string shown_path(const fs::path& file) {
  std::error_code problem;
  const fs::path nearer = fs::proximate(file, problem);
  return printable((problem ? file : nearer).string());
}

Program::Program(fs::path path)
    : file(std::move(path)), opened(std::make_shared<Descriptor>(::open(file.c_str(), O_PATH | O_CLOEXEC))) {}

std::string program_on_path(const std::string& name) {
  std::istringstream folders(environment("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path program = fs::path(folder) / name;
    std::error_code problem;
    if (fs::is_regular_file(program, problem) && ::access(program.c_str(), X_OK) == 0) return program.string();
  }
  return "";
}

}  // namespace workbook
