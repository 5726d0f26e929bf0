#include "checker/compile/source_file.hpp"

#include "checker/worker/descriptor.hpp"
#include "checker/worker/printable.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace workbook {
namespace {

[[noreturn]] void reject(const std::filesystem::path& file, const std::string& reason) {
  throw RejectedFile(printable(file.filename().string()) + " " + reason);
}

void require_regular(const std::filesystem::path& file, const struct stat& status) {
  if (S_ISREG(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) reject(file, "is a folder; name the file with your function.");
  if (S_ISLNK(status.st_mode)) reject(file, "is a symbolic link; put the file itself there.");
  reject(file, "is not an ordinary file; save your function as an ordinary text file.");
}

}  // namespace

std::string read_source(const std::filesystem::path& file) {
  struct stat status {};
  // Looked at before it is opened: opening a device can do things.
  if (::lstat(file.c_str(), &status) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) reject(file, "does not exist; check the name and the folder.");
    reject(file, "cannot be read (" + std::generic_category().message(errno) + "); check its name and permissions.");
  }
  require_regular(file, status);
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  if (!descriptor)
    reject(file, "cannot be read (" + std::generic_category().message(errno) + "); check its permissions.");
  if (::fstat(descriptor.number(), &status) != 0) reject(file, "cannot be read.");
  require_regular(file, status);

  std::string text(largest_source + 1, '\0');
  std::size_t size = 0;
  while (size < text.size() && static_cast<std::size_t>(status.st_size) <= largest_source) {
    const ssize_t got = ::read(descriptor.number(), text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) reject(file, "cannot be read (" + std::generic_category().message(errno) + ").");
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size > largest_source || static_cast<std::size_t>(status.st_size) > largest_source)
    reject(file, "is larger than 1 MiB; hand in the source file only.");
  text.resize(size);
  if (text.find('\0') != std::string::npos)
    reject(file, "is not a text file; hand in the source file, saved as UTF-8, not a compiled one.");
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

}  // namespace workbook
