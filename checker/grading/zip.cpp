// Zip files are read by libarchive, which sees bytes made by strangers: in a process that can write nothing and open
// nothing, with limits on all that comes back.
#include "checker/grading/grading.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>

namespace workbook {
namespace {

using nlohmann::json;

constexpr std::size_t most_zipped = 200'000;
constexpr std::size_t most_bytes = std::size_t{32} << 20;      // of all files that are taken
constexpr std::size_t largest_archive = std::size_t{1} << 30;  // as it is stored
constexpr std::size_t largest_inner = std::size_t{32} << 20;
constexpr std::chrono::seconds longest{60};
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t most_memory = 0;  // its runtime reserves terabytes of addresses
#else
constexpr std::size_t most_memory = std::size_t{512} << 20;
#endif

class Reader {
 public:
  explicit Reader(const std::vector<std::string>& names) : names_(names) {}

  json found = json::array();

  void read(archive* opened, const std::string& prefix, bool is_inner) {
    archive_entry* entry = nullptr;
    for (int status = 0; (status = archive_read_next_header(opened, &entry)) != ARCHIVE_EOF;) {
      if (status < ARCHIVE_WARN) throw std::runtime_error("is damaged or no zip file");
      if (++entries_ > most_zipped) throw std::runtime_error("holds too many files");
      const char* const stored = archive_entry_pathname(entry);
      if (stored == nullptr) continue;
      const std::string path = prefix + stored;
      const std::string name = path.substr(path.rfind('/') + 1);
      const bool is_archive = name.ends_with(".zip") && !is_inner;
      if (!is_archive && std::ranges::none_of(names_, [&](const auto& known) { return name.ends_with(known); }))
        continue;
      const bool is_file = archive_entry_filetype(entry) == AE_IFREG && archive_entry_hardlink(entry) == nullptr;
      std::string text;
      const std::string refusal = !is_file ? "is not an ordinary file; put the file itself there"
                                           : bytes_of(opened, is_archive ? largest_inner : largest_source, text);
      if (is_archive && refusal.empty()) {
        read_inner(text, path.substr(0, path.size() - 4) + "/");
      } else {
        add(path, refusal.empty() ? text : "", refusal);
      }
    }
  }

 private:
  void add(const std::string& path, const std::string& text, const std::string& refusal) {
    bytes_ += text.size() + path.size();
    if (bytes_ > most_bytes) throw std::runtime_error("holds more than 32 MiB of source files; unpack it yourself");
    found.push_back({json::binary({path.begin(), path.end()}), json::binary({text.begin(), text.end()}), refusal});
  }

  void read_inner(const std::string& bytes, const std::string& prefix) {
    const std::unique_ptr<archive, decltype(&archive_read_free)> inner(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(inner.get());
    try {
      if (archive_read_open_memory(inner.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
        throw std::runtime_error("is damaged or no zip file");
      read(inner.get(), prefix, true);
    } catch (const std::runtime_error& problem) {
      add(prefix.substr(0, prefix.size() - 1) + ".zip", "", problem.what());
    }
  }

  static std::string bytes_of(archive* opened, std::size_t limit, std::string& bytes) {
    bytes.resize(limit + 1);
    std::size_t size = 0;
    for (la_ssize_t got = 1; got != 0 && size < bytes.size(); size += static_cast<std::size_t>(got)) {
      got = archive_read_data(opened, bytes.data() + size, bytes.size() - size);
      if (got < 0) return "cannot be unpacked: it is damaged or encrypted";
    }
    bytes.resize(size);
    return size > limit ? fmt::format("is larger than {} MiB; hand in the source file only", limit >> 20) : "";
  }

  const std::vector<std::string>& names_;
  std::size_t entries_ = 0, bytes_ = 0;
};

std::string unpacked(int file, const std::vector<std::string>& names) {
  json answer = {{"problem", ""}};
  const std::unique_ptr<archive, decltype(&archive_read_free)> opened(archive_read_new(), archive_read_free);
  Reader reader(names);
  try {
    ::setlocale(LC_CTYPE, "C.UTF-8");
    const Sandbox sandbox({.calls = SandboxProfile::Calls::build,
                           .processor_seconds = static_cast<unsigned>(longest.count()),
                           .memory_bytes = most_memory,
                           .open_files = 256});  // this program may have inherited some
    if (const char* failed = sandbox.enter()) throw std::runtime_error(std::string("cannot be read safely: ") + failed);
    archive_read_support_format_zip(opened.get());
    if (archive_read_open_fd(opened.get(), file, 65536) != ARCHIVE_OK)
      throw std::runtime_error("is damaged or no zip file");
    reader.read(opened.get(), "", false);
  } catch (const std::exception& problem) {
    answer["problem"] = problem.what();
    reader.found.clear();
  }
  answer["found"] = std::move(reader.found);
  const std::vector<std::uint8_t> bytes = json::to_cbor(answer);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<Zipped> read_zip(const fs::path& file, const std::vector<std::string>& names) {
  const auto reject = [&](const std::string& reason) {
    throw RejectedFile(fmt::format("{} {}.", printable(file.filename().string()), reason));
  };
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!opened || ::fstat(opened.number(), &status) != 0) reject("cannot be opened, or is a symbolic link");
  if (!S_ISREG(status.st_mode)) reject("is not an ordinary file");
  if (static_cast<std::size_t>(status.st_size) > largest_archive) reject("is larger than 1 GiB");
  ForkedJob job([&] { return unpacked(opened.number(), names); }, longest);
  std::vector<Zipped> files;
  try {
    if (const std::string trouble = job.finish(); !trouble.empty())
      throw std::runtime_error("cannot be read: " + trouble);
    const json answer = json::from_cbor(job.output());
    if (const std::string problem = answer.at("problem"); !problem.empty()) throw std::runtime_error(problem);
    const auto text = [](const json& bytes) {
      return std::string(bytes.get_binary().begin(), bytes.get_binary().end());
    };
    for (const json& each : answer.at("found")) files.push_back({text(each.at(0)), text(each.at(1)), each.at(2)});
  } catch (const std::exception& problem) {
    reject(printable(problem.what()));
  }
  return files;
}

}  // namespace workbook
