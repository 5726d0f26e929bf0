// Zip files are read by libarchive, which sees bytes made by strangers: in a process that can write nothing and open
// nothing, with limits on all that comes back.
#include "checker/grading/grading.hpp"
#include "checker/sandbox/sandbox.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>

namespace workbook {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Found, path, text, refusal, is_unread)

namespace {

using nlohmann::json;

constexpr std::size_t largest_archive = std::size_t{1} << 30;  // as it is stored
constexpr std::size_t largest_inner = std::size_t{32} << 20;   // a zip file, or Gradescope's metadata
constexpr std::chrono::seconds longest{600};
#ifdef __SANITIZE_ADDRESS__
constexpr std::size_t most_memory = 0;  // its runtime reserves terabytes of addresses
#else
constexpr std::size_t most_memory = std::size_t{1} << 30;
#endif

// Of source files, in bytes.
constexpr std::size_t most_of_a_student = std::size_t{32} << 20, most_of_all = std::size_t{128} << 20;
// Entries and bytes that are unpacked stand for time, and are the same on any machine.
constexpr std::size_t work_of_an_entry = 1024, most_work_of_a_student = std::size_t{256} << 20;

/// What was read of a student.
struct Amount {
  std::size_t kept = 0, work = 0;
};

class Reader {
 public:
  Reader(bool is_class, const NeedsText& needs_text) : is_class_(is_class), needs_text_(needs_text) {}

  std::vector<Found> found;

  void read(archive* opened, const std::string& prefix, int depth) {
    archive_entry* entry = nullptr;
    for (int status = 0; (status = archive_read_next_header(opened, &entry)) != ARCHIVE_EOF;) {
      if (status < ARCHIVE_WARN) throw std::runtime_error("is damaged or no zip file");
      const char* const stored = archive_entry_pathname(entry);
      // Windows writes names in the letters of MS-DOS where it can, and some programs there "\\" between folders.
      std::string path = prefix + (stored == nullptr ? "" : in_utf8(stored, "ibm-437"));
      std::ranges::replace(path, '\\', '/');
      const std::string student = is_class_ ? student_of(path) : "";
      if (too_much_.contains(student)) continue;
      // Who has handed in nothing that is graded is of the class too.
      if (!student.empty() && student[0] != '.' && student != "__MACOSX" && path.starts_with(student + "/") &&
          !students_.contains(student))
        found.push_back({student + "/"});
      try {
        count(student, 0, work_of_an_entry);
        if (stored != nullptr) read_entry(opened, entry, path, student, depth);
      } catch (const std::runtime_error& problem) {  // too much of this student, whose other files are not read either
        if (depth > 0 || !is_class_) throw;
        too_much_.insert(student);
        add_unread(student, problem.what());
      }
    }
  }

 private:
  /// In an export of Gradescope all students are in one folder.
  static std::string student_of(const std::string& path) {
    return search(path, "^(?:assignment_[^/]*_export/)?([^/]*?)(?:(?i:\\.zip)$|/|$)")[1];
  }

  void read_entry(archive* opened, archive_entry* entry, const std::string& path, const std::string& student,
                  int depth) {
    const std::string name = path.substr(path.rfind('/') + 1);
    const bool is_archive = is_zip(name);
    if (name.starts_with('.') || path.find("__MACOSX/") != std::string::npos) return;
    // Nothing beside the students is passed over.
    const bool is_named = is_handed_in(name) || (is_class_ && name == path && !name.empty());
    if (!is_archive && !is_named) return;
    if (!is_archive && !needs_text_(name)) return found.push_back({path});
    if (is_archive && depth > 0) return add_unread(path, "is a zip file in a zip file in a zip file");
    const bool is_file = archive_entry_filetype(entry) == AE_IFREG && archive_entry_hardlink(entry) == nullptr;
    const std::size_t limit = is_archive || name == gradescope_metadata ? largest_inner : largest_source;
    std::string text;
    const std::string refusal =
        is_file ? bytes_of(opened, limit, text) : "is not an ordinary file; put the file itself there";
    count(student, 0, text.size());
    if (is_archive && refusal.empty()) return read_inner(text, path, student);
    if (is_archive) return add_unread(path, refusal);
    count(student, text.size() + path.size(), 0);
    found.push_back({path, refusal.empty() ? text : "", refusal});
  }

  void add_unread(const std::string& path, const std::string& refusal) { found.push_back({path, "", refusal, true}); }

  /// All of it or nothing; but the time that it took is gone.
  void read_inner(const std::string& bytes, const std::string& path, const std::string& student) {
    const std::unique_ptr<archive, decltype(&archive_read_free)> inner(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(inner.get());
    const std::size_t before = found.size(), kept = students_[student].kept;
    try {
      if (archive_read_open_memory(inner.get(), bytes.data(), bytes.size()) != ARCHIVE_OK)
        throw std::runtime_error("is damaged or no zip file");
      read(inner.get(), path.substr(0, path.size() - 4) + "/", 1);
    } catch (const std::runtime_error& problem) {
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(before), found.end());
      kept_ -= students_[student].kept - kept;
      students_[student].kept = kept;
      add_unread(path, problem.what());
    }
  }

  void count(const std::string& student, std::size_t kept, std::size_t work) {
    Amount& own = students_[student];
    own.kept += kept;
    own.work += work;
    kept_ += kept;
    const auto too_much = [](std::size_t most) {
      return fmt::format("holds more than {} MiB of source files", most >> 20);
    };
    if (own.kept > most_of_a_student) throw std::runtime_error(too_much(most_of_a_student));
    if (own.work > most_work_of_a_student) throw std::runtime_error("takes too long to unpack");
    // It is no std::runtime_error, so that nobody's file is skipped for it.
    if (kept_ > most_of_all) throw std::length_error(too_much(most_of_all) + "; unpack it yourself");
  }

  static std::string bytes_of(archive* opened, std::size_t limit, std::string& bytes) {
    std::array<char, 1 << 16> block{};
    while (bytes.size() <= limit) {
      const la_ssize_t got = archive_read_data(opened, block.data(), block.size());
      if (got < 0) return "cannot be unpacked: it is damaged or encrypted";
      if (got == 0) return "";
      bytes.append(block.data(), static_cast<std::size_t>(got));
    }
    return fmt::format("is larger than {} MiB; hand in the source file only", limit >> 20);
  }

  const bool is_class_;
  const NeedsText& needs_text_;
  std::size_t kept_ = 0;
  std::map<std::string, Amount> students_;
  std::set<std::string> too_much_;
};

std::string unpacked(int file, bool is_class, const NeedsText& needs_text) {
  std::string trouble;
  const std::unique_ptr<archive, decltype(&archive_read_free)> opened(archive_read_new(), archive_read_free);
  Reader reader(is_class, needs_text);
  try {
    ::setlocale(LC_CTYPE, "C.UTF-8");
    const SandboxProfile profile{.calls = SandboxProfile::Calls::build,
                                 .processor_seconds = static_cast<unsigned>(longest.count()),
                                 .memory_bytes = most_memory,
                                 .open_files = 256,  // this program may have inherited some
                                 .filter = system_call_filter(SandboxProfile::Calls::build)};
    if (const char* failed = enter_sandbox(profile, what_the_kernel_offers().landlock))
      throw std::runtime_error(std::string("cannot be read safely: ") + failed);
    archive_read_support_format_zip(opened.get());
    if (archive_read_open_fd(opened.get(), file, 65536) != ARCHIVE_OK)
      throw std::runtime_error("is damaged or no zip file");
    reader.read(opened.get(), "", 0);
  } catch (const std::exception& problem) {
    trouble = problem.what();
  }
  const std::vector<std::uint8_t> bytes = json::to_cbor(std::pair(trouble, reader.found));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<Found> read_zip(const fs::path& file, bool is_class, const NeedsText& needs_text) {
  const auto reject = [&](const std::string& reason) {
    throw RejectedFile(fmt::format("{} {}.", printable(file.filename().string()), reason));
  };
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!opened || ::fstat(opened.number(), &status) != 0) reject("cannot be opened, or is a symbolic link");
  if (!S_ISREG(status.st_mode)) reject("is not an ordinary file");
  if (static_cast<std::size_t>(status.st_size) > largest_archive) reject("is larger than 1 GiB");
  ForkedJob job([&] { return unpacked(opened.number(), is_class, needs_text); }, longest);
  std::pair<std::string, std::vector<Found>> read;  // what is wrong, and the files
  try {
    if (const std::string trouble = job.finish(); !trouble.empty()) reject("cannot be read: " + trouble);
    read = json::from_cbor(job.output()).get<decltype(read)>();
  } catch (const json::exception& problem) {
    read.first = problem.what();
  }
  if (!read.first.empty()) reject(printable(read.first));
  return read.second;
}

}  // namespace workbook
