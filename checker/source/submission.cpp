#include "checker/source/submission.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace workbook {
namespace {

constexpr const char* too_large = "is larger than 1 MiB; hand in the source file only";

/// Why a file with this status is not read; empty: it is.
std::string objection(const struct stat& status) {
  if (S_ISDIR(status.st_mode)) return "is a folder; name the file with your function";
  if (S_ISLNK(status.st_mode)) return "is a symbolic link; put the file itself there";
  if (!S_ISREG(status.st_mode)) return "is not an ordinary file; save your function as an ordinary text file";
  return static_cast<std::size_t>(status.st_size) > largest_source ? too_large : "";
}

/// The first line with a character that makes screens show a text in another order than compilers read it; 0: none.
std::ptrdiff_t reordered_line(std::string_view text) {
  for (std::size_t at = 0; (at = text.find('\xe2', at)) != std::string_view::npos; ++at) {
    const std::string_view character = text.substr(at, 3);
    if ((character >= "\u202a" && character <= "\u202e") || (character >= "\u2066" && character <= "\u2069"))
      return 1 + std::ranges::count(text.substr(0, at), '\n');
  }
  return 0;
}

}  // namespace

Submission read_submission(const std::filesystem::path& path, const std::string& shown_name) {
  // Not resolved: a link is told by its own name.
  const std::string name =
      shown_name.empty() ? path.lexically_proximate(std::filesystem::current_path()).string() : shown_name;
  Submission submission{path, printable(name), {}, {}};
  std::ranges::replace_if(
      submission.shown_name, [](char letter) { return letter == '\n' || letter == '\t'; }, '?');
  const auto reject_if = [&](const std::string& reason) {
    if (!reason.empty()) throw RejectedFile(fmt::format("{} {}.", submission.shown_name, reason));
  };
  const auto reject_unreadable = [&] {
    reject_if(errno == ENOENT || errno == ENOTDIR
                  ? "does not exist; check the name and the folder"
                  : fmt::format("cannot be read ({}); check its name and permissions", std::strerror(errno)));
  };
  struct stat status {};
  // Looked at before it is opened, for opening a device can do things; and afterwards, for it may be another one then.
  if (::lstat(path.c_str(), &status) != 0) reject_unreadable();
  reject_if(objection(status));
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  if (!file || ::fstat(file.number(), &status) != 0) reject_unreadable();
  reject_if(objection(status));

  std::string& text = submission.text;
  text.resize(largest_source + 1);
  std::size_t size = 0;
  for (ssize_t got = 1; got != 0 && size < text.size(); size += static_cast<std::size_t>(got)) {
    got = TEMP_FAILURE_RETRY(::read(file.number(), text.data() + size, text.size() - size));
    if (got < 0) reject_unreadable();
  }
  text.resize(size);
  if (size > largest_source) reject_if(too_large);
  if (text.find('\0') != std::string::npos)
    reject_if("is not a text file; hand in the source file, saved as UTF-8, not a compiled one");
  if (const auto line = reordered_line(text); line > 0)
    reject_if(
        fmt::format("holds an invisible character in line {} that shows the code in another order than it has; "
                    "delete it",
                    line));
  return submission;
}

}  // namespace workbook
