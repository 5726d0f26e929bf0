// Executables are kept, so that an unchanged file need not be compiled again; a cache may lose anything at any time.
#include "tests/running/student.hpp"

#include <doctest/doctest.h>

#include <sys/stat.h>

#include <fstream>
#include <thread>

namespace workbook::testing {
namespace fs = std::filesystem;
namespace {

std::size_t entries(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

bool answers(const Program& executable) {
  const Observation observation = ExerciseRunner(executable, short_limits()).observe(plan_calls({twice_case(21)}), {});
  return observation.replies.at(0).value == Value{1, 1, {42.0}};
}

/// A file, and a cache of its own for it.
struct Course {
  fs::path directory;
  fs::path file = write(directory / "twice.cpp", right_twice);
  fs::path cache = directory / "cache";
  Toolchain tools = toolchain();

  Compilation check() const { return compile({read_submission(file), "twice", signature("twice")}, tools, cache); }
};

}  // namespace

TEST_CASE("an unchanged file is compiled once, a changed one again") {
  Course course{fresh_directory("cached")};
  const Compilation first = course.check();
  REQUIRE(first.executable.has_value());
  CHECK_FALSE(first.from_cache);
  const Compilation second = course.check();
  CHECK(second.from_cache);
  CHECK(second.executable == first.executable);
  CHECK(answers(*second.executable));
  CHECK(second.seconds < first.seconds);

  write(course.file, std::string(right_twice) + "// a thought\n");
  CHECK_FALSE(course.check().from_cache);
  write(course.file, right_twice);
  CHECK(course.check().from_cache);
  CHECK(entries(course.cache) == 2);

  course.tools.flags.push_back("-DANOTHER");
  CHECK_FALSE(course.check().from_cache);
}

TEST_CASE("another worker, prelude or compiler needs another executable") {
  Course course{fresh_directory("tools")};
  course.tools.directory = course.directory;  // where its worker is made
  CHECK_FALSE(course.check().from_cache);
  CHECK(course.check().from_cache);
  fs::last_write_time(course.tools.worker_object("twice"), fs::file_time_type::clock::now() + std::chrono::seconds(5));
  CHECK_FALSE(course.check().from_cache);
  fs::create_symlink(toolchain().compiler, course.directory / "compiler");
  course.tools.compiler = course.directory / "compiler";
  CHECK_FALSE(course.check().from_cache);
}

TEST_CASE("only executables enter the cache") {
  Course course{fresh_directory("failures")};
  write(course.file, "this is not C++");
  CHECK(course.check().refusal == Refusal::compile_error);
  write(course.file, "");
  CHECK(course.check().refusal == Refusal::missing_function);
  CHECK(entries(course.cache) == 0);
}

TEST_CASE("a damaged entry is compiled again") {
  Course course{fresh_directory("damaged")};
  const fs::path executable = course.check().executable.value();
  const fs::path entry = executable.parent_path();
  const auto compiled_again_after = [&](const char* damage) {
    INFO(damage);
    const Compilation again = course.check();
    CHECK_FALSE(again.from_cache);
    REQUIRE(again.executable == executable);
    CHECK(answers(executable));
    CHECK(course.check().from_cache);
    CHECK(entries(course.cache) == 1);
  };
  fs::resize_file(executable, 1000);
  compiled_again_after("a cut executable");
  {
    std::fstream file(executable, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(5000).put('?');
  }
  compiled_again_after("a wrong byte in the executable");
  fs::remove(executable);
  compiled_again_after("no executable");
  fs::remove(entry / "made_from");
  compiled_again_after("no key");
  fs::resize_file(entry / "made_from", 20);
  compiled_again_after("a cut key");
  fs::resize_file(entry / "made_from", 0);
  compiled_again_after("an empty key");
  fs::remove_all(entry);
  write(entry, "?");
  compiled_again_after("a file instead of the entry");
  fs::remove_all(course.cache);
  compiled_again_after("no cache at all");
}

TEST_CASE("the cache drops what was not used for longest") {
  const fs::path directory = fresh_directory("bounded");
  const BuildCache cache(directory / "cache", 2);
  const auto keep = [&](const std::string& name) {
    const Workspace workspace(cache.directory());
    cache.keep({.executable = write(workspace.directory() / "worker", "program " + name),
                .compiler_output = "warnings of " + name},
               "key " + name);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  };
  keep("a");
  keep("b");
  CHECK(cache.find("key a").has_value());  // used again: now "b" is the older one
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  keep("c");
  CHECK(cache.find("key a").has_value());
  CHECK_FALSE(cache.find("key b").has_value());
  REQUIRE(cache.find("key c").has_value());
  CHECK(cache.find("key c")->compiler_output == "warnings of c");
  CHECK(entries(cache.directory()) == 2);
}

TEST_CASE("an executable that is used runs on where the cache has dropped it") {
  const Course course{fresh_directory("in_use")};
  const Compilation made = course.check(), found = course.check();
  REQUIRE((made.executable && found.from_cache));
  fs::remove_all(course.cache);
  CHECK(answers(made.program()));
  CHECK(answers(found.program()));
  CHECK_FALSE(fs::exists(*made.executable));
}

TEST_CASE("what a killed checker left in the cache is cleared away after an hour") {
  const BuildCache cache(fresh_directory("left-over"));
  const fs::path old = cache.directory() / "compile-abcdef";
  const fs::path young = cache.directory() / "compile-ghijkl";
  write(old / "unit.cpp", "");
  write(young / "unit.cpp", "");
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(2));
  const Workspace workspace(cache.directory());
  cache.keep({.executable = write(workspace.directory() / "worker", "program")}, "key");
  CHECK_FALSE(fs::exists(old));
  CHECK(fs::exists(young));
}

TEST_CASE("two checkers may compile the same file at the same time") {
  Course course{fresh_directory("together")};
  Compilation one, other;
  std::thread first([&] { one = course.check(); });
  std::thread second([&] { other = course.check(); });
  first.join();
  second.join();
  REQUIRE(one.executable.has_value());
  REQUIRE(other.executable.has_value());
  CHECK(answers(*one.executable));
  CHECK(answers(*other.executable));
  CHECK(entries(course.cache) == 1);
}

TEST_CASE("decompositions by Eigen are compiled once for all files" * doctest::test_suite("thorough")) {
  Course course{fresh_directory("instantiated")};
  course.tools.directory = course.directory;
  write(
      course.file,
      R"(// EigenSolver SelfAdjointEigenSolver FromTwoVectors PartialPivLU fullPivLu colPivHouseholderQr householderQr ldlt llt
double rigid::twice(double x) { return 2 * Eigen::JacobiSVD<Matrix3d>(x * Matrix3d::Identity()).singularValues()[0]; })");
  const Compilation compilation = course.check();
  REQUIRE(compilation.executable.has_value());
  CHECK(answers(*compilation.executable));
  CHECK(instantiations(course.tools, *read_file(course.file)).size() == 10);
  course.tools.compiler = "/bin/false";
  CHECK(instantiations(course.tools, "Matrix3d LDLT").size() == 1);  // there already
  CHECK(instantiations(course.tools, "Matrix4d LDLT").empty());      // and this one cannot be made
}

TEST_CASE("a pipe in the place of a kept executable is not waited for") {
  const std::string text = "double rigid::twice(double x) { return x + x + 0; }";
  const fs::path kept = executable(text);
  fs::remove(kept);
  REQUIRE(::mkfifo(kept.c_str(), 0600) == 0);
  const Compilation again = compile_text(text);
  CHECK(again.executable.has_value());
  CHECK_FALSE(again.from_cache);
}

}  // namespace workbook::testing
