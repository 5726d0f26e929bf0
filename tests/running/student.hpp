/// @file
/// Students for the tests of compiling and running: files with made-up answers to the made-up contract.
#pragma once

#include "checker/compile/compile.hpp"
#include "checker/judging/judge.hpp"
#include "checker/sandbox/sandbox.hpp"
#include "checker/sandbox/worker_process.hpp"
#include "tests/support/files.hpp"
#include "tests/support/processes.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace workbook::testing {

/// Of all that the tests compile and run: the strongest of this machine, or WORKBOOK_TEST_SANDBOX.
SandboxTier sandbox_tier();

/// Of this tier alone: tests of several may run at the same time.
std::filesystem::path scratch();

/// The toolchain of the fixture contract.
const Toolchain& toolchain();

/// A directory for one test, empty at first.
std::filesystem::path fresh_directory(const std::string& name);

/// The directory in which all tests keep their executables, so that a second run of the tests is quick.
std::filesystem::path shared_cache();

/// A right answer to the exercise twice.
inline constexpr const char* right_twice = "double rigid::twice(double x) { return 2 * x; }\n";

/// As the contract declares an exercise.
std::string signature(const std::string& exercise);

/// The text as an answer to an exercise, handed in as EXERCISE.cpp.
Submission submit(const std::string& text, const std::string& exercise);

/// Compiles the text as an answer to an exercise of the fixture contract.
Compilation compile_text(const std::string& text, const std::string& exercise = "twice");

/// The same where it must succeed.
std::filesystem::path executable(const std::string& text, const std::string& exercise = "twice");

/// A case of `twice`.
Case twice_case(double x);

/// Short limits, so that the tests are quick.
RunLimits short_limits();

Observation run(const std::string& text, const std::vector<double>& inputs, const RunLimits& limits = short_limits());

/// A text that a student may write, as beginners.txt tells how they are kept.
struct Snippet {
  std::string title = "";
  std::string said = "";  ///< what follows |
  std::string frame = "";
  std::string text = "";  ///< a whole file, or a body where the frame is of none of twice, scaled and file

  std::string exercise() const {
    return has(text, "scaled(const Matrix3d& A") && !has(text, "double twice(") ? "scaled" : "twice";
  }
};

/// Those in a file of tests/running.
std::vector<Snippet> snippets_in(const std::string& file);

/// A file of sentences in tests/running/golden. To rewrite them all: WORKBOOK_REWRITE_GOLDEN=1 ./tests/run -R running
std::filesystem::path golden(const std::string& name);

/// Runs something in a copy of the test's process, so that what it does to itself stays there. Returns its result.
bool in_another_process(const std::function<bool()>& something);

}  // namespace workbook::testing
