/// @file
/// Runs the checker as a program on a copy of the tiny course, as a student would.
#pragma once

#include "tests/support/files.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace workbook::testing {

/// What one run of the program left behind.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;

  /// Standard output as JSON. @throws if it is not one document and nothing else.
  nlohmann::json json() const { return nlohmann::json::parse(out); }
};

/// A copy of the tiny course in a folder of its own, gone at the end of the test.
class CourseCopy {
 public:
  CourseCopy();
  ~CourseCopy();
  CourseCopy(const CourseCopy&) = delete;
  CourseCopy& operator=(const CourseCopy&) = delete;

  /// Runs `checker ARGUMENTS`, quoted as for a shell; `environment` stands before it ("NO_COLOR=1").
  Outcome run(const std::string& arguments, const std::string& environment = "") const;

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path exercise(const std::string& name) const {
    return root_ / "lectures/01_springs/exercises" / (name + ".cpp");
  }
  std::filesystem::path solution(const std::string& name) const {
    return root_ / "solutions/01_springs" / (name + ".cpp");
  }
  std::filesystem::path reference() const { return root_ / "reference/01_springs.json"; }
  std::filesystem::path card() const { return root_ / "lectures/01_springs/card.json"; }
  std::filesystem::path notes() const { return root_ / "lectures/01_springs/notes.md"; }

  /// Writes an answer to spring_energy whose body is `body`.
  void answer_energy(const std::string& body, const std::string& before = "") const;

 private:
  std::filesystem::path root_;
};

}  // namespace workbook::testing
