#include "checker/compile/source_file.hpp"

#include "checker/base/descriptor.hpp"
#include "checker/base/printable.hpp"
#include "checker/messages/compiling.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace workbook {
namespace {

/// Refuses a file with one of the sentences for that.
template <class... Reason>
[[noreturn]] void reject(const std::filesystem::path& file,
                         std::string (*sentence)(const std::string&, const Reason&...), const Reason&... reason) {
  throw RejectedFile(sentence(printable(file.filename().string()), reason...));
}

[[noreturn]] void reject_unreadable(const std::filesystem::path& file) {
  reject(file, messages::cannot_be_read, std::generic_category().message(errno));
}

void require_regular(const std::filesystem::path& file, const struct stat& status) {
  if (S_ISREG(status.st_mode)) return;
  if (S_ISDIR(status.st_mode)) reject(file, messages::is_folder);
  if (S_ISLNK(status.st_mode)) reject(file, messages::is_symbolic_link);
  reject(file, messages::is_no_ordinary_file);
}

}  // namespace

std::string read_source(const std::filesystem::path& file) {
  struct stat status {};
  // Looked at before it is opened: opening a device can do things.
  if (::lstat(file.c_str(), &status) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) reject(file, messages::does_not_exist);
    reject_unreadable(file);
  }
  require_regular(file, status);
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  if (!descriptor) reject_unreadable(file);
  if (::fstat(descriptor.number(), &status) != 0) reject_unreadable(file);
  require_regular(file, status);

  std::string text(largest_source + 1, '\0');
  std::size_t size = 0;
  while (size < text.size() && static_cast<std::size_t>(status.st_size) <= largest_source) {
    const ssize_t got = ::read(descriptor.number(), text.data() + size, text.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) reject_unreadable(file);
    if (got == 0) break;
    size += static_cast<std::size_t>(got);
  }
  if (size > largest_source || static_cast<std::size_t>(status.st_size) > largest_source)
    reject(file, messages::is_too_large);
  text.resize(size);
  if (text.find('\0') != std::string::npos) reject(file, messages::is_no_text);
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  return text;
}

}  // namespace workbook
