/// @file
/// Reading and writing whole files, and descriptors of open ones.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace workbook {

/// The content of a regular file, nothing if there is none, it cannot be read or is larger than `limit`.
std::optional<std::string> read_file(const std::filesystem::path& file, std::size_t limit = std::size_t{1} << 30);

/// Written under another name and renamed, so that nobody reads half a file. Makes the folder if need be.
/// @param mode  its permissions; none: those of any new file. @returns "" or the system's reason
std::string write_file(const std::filesystem::path& file, std::string_view content,
                       std::optional<std::filesystem::perms> mode = {});

/// The same where nothing can go on without it. @throws std::runtime_error naming file and reason
void write_or_throw(const std::filesystem::path& file, std::string_view content);

/// Removes what programs that were killed while they wrote have left in a folder and below.
void remove_unfinished(const std::filesystem::path& folder);

/// The fingerprint of a file's content; "" if it cannot be read.
std::string file_fingerprint(const std::filesystem::path& file);

/// FILE itself, or the first of FILE.2, FILE.3, … that is not taken.
std::filesystem::path free_name(const std::filesystem::path& file);

/// "" or why nothing can be written into a folder, which is made if need be: found out before the long work begins.
std::string folder_trouble(const std::filesystem::path& folder);

/// Why no file or folder can be made there, with the folders that it lies in; empty: it can, or is there. Leaves
/// nothing.
std::string place_trouble(const std::filesystem::path& file);

/// Is a file, or anything in a folder, newer than that file, or is that file missing?
bool is_newer(const std::filesystem::path& file_or_folder, const std::filesystem::path& than);

/// As seen from the current folder, safe to print.
std::string shown_path(const std::filesystem::path& file);

/// Its address for browsers and terminals: "file:///a%20folder/page.html".
std::string file_address(const std::filesystem::path& file);

/// Where a program lies on PATH; "" if it is not installed.
std::string program_on_path(const std::string& name);

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_ = -1;
};

/// A program that stays open: it can be started when its file is gone.
struct Program {
  std::filesystem::path file;
  std::shared_ptr<const Descriptor> opened;  ///< where it could be opened

  Program(std::filesystem::path path);  // NOLINT(google-explicit-constructor): its path stands for it
  Program(std::filesystem::path path, std::shared_ptr<const Descriptor> descriptor)
      : file(std::move(path)), opened(std::move(descriptor)) {}
};

}  // namespace workbook
