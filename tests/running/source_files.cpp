// What may lie where a student's file should be.
#include "tests/running/student.hpp"

#include "checker/base/printable.hpp"
#include "checker/compile/source_file.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>
#include <unistd.h>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

std::string rejection(const fs::path& file) {
  try {
    read_source(file);
  } catch (const RejectedFile& reason) {
    return reason.what();
  }
  return "no rejection";
}

}  // namespace

TEST_CASE("an ordinary file is read as it is, without a byte order mark") {
  const fs::path directory = fresh_directory("sources");
  CHECK(read_source(write(directory / "a.cpp", "int x;\n")) == "int x;\n");
  CHECK(read_source(write(directory / "b.cpp", "\xef\xbb\xbfint x;\n")) == "int x;\n");
  CHECK(read_source(write(directory / "c.cpp", "")).empty());
  CHECK(read_source(write(directory / "d.cpp", std::string(largest_source, ' '))).size() == largest_source);
}

TEST_CASE("what is no ordinary file is rejected without waiting") {
  const fs::path directory = fresh_directory("odd-files");
  CHECK(rejection(directory / "absent.cpp") == "absent.cpp does not exist; check the name and the folder.");
  CHECK(rejection(directory) == "odd-files is a folder; name the file with your function.");
  CHECK(rejection(write(directory / "file", "") / "below.cpp") ==
        "below.cpp does not exist; check the name and the folder.");

  const fs::path pipe = directory / "pipe.cpp";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(rejection(pipe) == "pipe.cpp is not an ordinary file; save your function as an ordinary text file.");
  CHECK(rejection("/dev/zero") == "zero is not an ordinary file; save your function as an ordinary text file.");

  fs::create_symlink("loop.cpp", directory / "loop.cpp");
  CHECK(rejection(directory / "loop.cpp") == "loop.cpp is a symbolic link; put the file itself there.");
  fs::create_symlink(write(directory / "solution.cpp", "int x;"), directory / "link.cpp");
  CHECK(rejection(directory / "link.cpp") == "link.cpp is a symbolic link; put the file itself there.");
}

TEST_CASE("a file that is too large is rejected without reading it") {
  const fs::path directory = fresh_directory("large-files");
  const fs::path sparse = write(directory / "sparse.cpp", "");
  fs::resize_file(sparse, std::size_t{100} << 20);
  CHECK(rejection(sparse) == "sparse.cpp is larger than 1 MiB; hand in the source file only.");
  const fs::path large = write(directory / "large.cpp", std::string(largest_source + 1, ' '));
  CHECK(rejection(large) == "large.cpp is larger than 1 MiB; hand in the source file only.");
}

TEST_CASE("a file that is no text is rejected") {
  const fs::path directory = fresh_directory("no-text");
  const std::string sentence = " is not a text file; hand in the source file, saved as UTF-8, not a compiled one.";
  CHECK(rejection(write(directory / "program.cpp", std::string("\x7f"
                                                               "ELF\0",
                                                               5))) == "program.cpp" + sentence);
  CHECK(rejection(write(directory / "utf16.cpp", std::string("i\0n\0t\0", 6))) == "utf16.cpp" + sentence);
}

TEST_CASE("a file that may not be read is rejected") {
  const fs::path file = write(fresh_directory("unreadable") / "secret.cpp", "int x;");
  fs::permissions(file, fs::perms::none);
  const bool may_read_all = ::geteuid() == 0;
  if (may_read_all) REQUIRE(::seteuid(65534) == 0);
  const std::string sentence = rejection(file);
  if (may_read_all) REQUIRE(::seteuid(0) == 0);
  CHECK(sentence.starts_with("secret.cpp cannot be read (Permission denied); check its"));
}

TEST_CASE("a rejected file never reaches the compiler") {
  const fs::path directory = fresh_directory("rejected");
  const Compilation compilation = compile({directory, "twice", "double twice(double x)"}, toolchain(), shared_cache());
  CHECK(compilation.refusal == Refusal::rejected_file);
  CHECK(compilation.message == "rejected is a folder; name the file with your function.");
  CHECK_FALSE(compilation.executable.has_value());
}

TEST_CASE("a file name is shown without what could disturb a terminal") {
  CHECK(rejection("/nowhere/\x1b[2Jname.cpp") == "?[2Jname.cpp does not exist; check the name and the folder.");
  CHECK(printable("θ\tω\n\x7f\xff\xc2\x85 \xe2\x82") == "θ\tω\n??? ");
}

}  // namespace workbook::testing
