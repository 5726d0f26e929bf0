// What may lie where a student's file should be.
#include "tests/running/student.hpp"

#include "checker/base/text.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

/// Why it is rejected, at once; empty: it is read.
std::string rejection(const fs::path& file) {
  const auto start = std::chrono::steady_clock::now();
  std::string reason;
  try {
    read_submission(file);
  } catch (const RejectedFile& error) {
    reason = error.what();
  }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::minutes(1));
  return reason;
}

bool is_rejected(const fs::path& file, const std::string& word) {
  return rejection(file).find(word) != std::string::npos;
}

}  // namespace

TEST_CASE("an ordinary file is read once, as it is") {
  const fs::path directory = fresh_directory("sources");
  const fs::path file = write(directory / "a.cpp", "int x;\n");
  const Submission submission = read_submission(file);
  CHECK(submission.path == file);
  CHECK(submission.text == "int x;\n");
  CHECK(submission.shown_name == file.lexically_proximate(fs::current_path()).string());
  write(file, "changed");
  CHECK(submission.text == "int x;\n");
  CHECK(read_submission(write(directory / "c.cpp", "")).text.empty());
  CHECK(read_submission(write(directory / "d.cpp", std::string(largest_source, ' '))).text.size() == largest_source);
}

TEST_CASE("what is no ordinary file is rejected without waiting") {
  const fs::path directory = fresh_directory("odd-files");
  const fs::path file = write(directory / "solution.cpp", "int x;");
  CHECK(is_rejected(directory / "absent.cpp", "absent.cpp"));
  CHECK(is_rejected(file / "below.cpp", "below.cpp"));
  CHECK(is_rejected(directory, "folder"));
  const fs::path pipe = directory / "pipe.cpp";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(is_rejected(pipe, "pipe.cpp"));
  for (const char* odd : {"/dev/zero", "/dev/null", "/proc/self/mem", "/proc/self/fd/0"})
    CHECK(is_rejected(odd, fs::path(odd).filename().string()));
  for (const fs::path& target : {file, fs::path("link.cpp"), fs::path("/dev/zero"), fs::path("/proc/self/mem")}) {
    fs::remove(directory / "link.cpp");
    fs::create_symlink(target, directory / "link.cpp");
    CHECK(is_rejected(directory / "link.cpp", "link.cpp is a symbolic link"));
  }
}

TEST_CASE("a file that is too large is rejected without reading it") {
  const fs::path directory = fresh_directory("large-files");
  const fs::path sparse = write(directory / "sparse.cpp", "");
  fs::resize_file(sparse, std::size_t{20} << 30);
  CHECK(is_rejected(sparse, "MiB"));
  CHECK(is_rejected(write(directory / "large.cpp", std::string(largest_source + 1, ' ')), "MiB"));
}

TEST_CASE("a file that is no text, or shows another text than it holds, is rejected") {
  const fs::path directory = fresh_directory("no-text");
  CHECK(is_rejected(write(directory / "program.cpp", std::string("\x7f"
                                                                 "ELF\0",
                                                                 5)),
                    "text"));
  CHECK(is_rejected(write(directory / "utf16.cpp", std::string("i\0n\0t\0", 6)), "text"));
  for (const std::string character : {"\u202a", "\u202e", "\u2066", "\u2069"})
    CHECK(is_rejected(write(directory / "reordered.cpp", "// a\nint x; // " + character + "\n"), "line 2"));
  for (const std::string harmless : {"\u2029", "\u202f", "\u2065", "\u206a", "\u00e2\u0080", "\xe2", "\xe2\x80"})
    CHECK(rejection(write(directory / "harmless.cpp", "// " + harmless)) == "");
}

TEST_CASE("a file that may not be read is rejected") {
  const fs::path file = write(fresh_directory("unreadable") / "secret.cpp", "int x;");
  fs::permissions(file, fs::perms::none);
  const bool may_read_all = ::geteuid() == 0;
  if (may_read_all) REQUIRE(::seteuid(65534) == 0);
  const std::string sentence = rejection(file);
  if (may_read_all) REQUIRE(::seteuid(0) == 0);
  CHECK(sentence.find("Permission denied") != std::string::npos);
}

TEST_CASE("a file name is shown without what could disturb a terminal, on one line") {
  CHECK(is_rejected("/nowhere/\x1b[2J\u202ename\n.cpp", "?[2J?name?.cpp"));
  CHECK(printable("θ\tω\n\x7f\xff\xc2\x85 \xe2\x82") == "θ\tω\n??? ");
}

}  // namespace workbook::testing
