/// @file
/// What came of a class: one document, from which every table and page is made.
#pragma once

#include "checker/grading/intake.hpp"
#include "checker/pipeline/check_exercise.hpp"

#include <nlohmann/json.hpp>

#include <array>

namespace workbook {

/// Collects the results of one student after the other, and keeps of each only what the class is told.
class ClassResults {
 public:
  ClassResults(const Assignment& assignment, std::uint64_t seed, const std::string& sandbox,
               const std::vector<std::string>& problems);

  /// @param results  in the order of the assignment's exercises. @param made_from  fingerprints of what was judged
  /// @return the document about this student
  nlohmann::ordered_json add(const Student& student, const std::vector<CheckResult>& results,
                             const std::vector<std::string>& made_from);

  /// The document about the class: class.json. Nothing is added afterwards.
  nlohmann::ordered_json document();

 private:
  nlohmann::ordered_json exercise_entry(std::size_t number) const;

  const Assignment& assignment_;
  nlohmann::ordered_json head_;
  nlohmann::ordered_json students_ = nlohmann::ordered_json::array();
  std::map<std::pair<std::string, std::string>, nlohmann::ordered_json> misconceptions_;  ///< by exercise and name
  /// Students who gave the same wrong values for the same unknown reason: by exercise and fingerprint of these.
  std::map<std::pair<std::string, std::string>, nlohmann::ordered_json> outputs_;
  std::vector<std::string> not_judged_;
  std::array<int, 10> distribution_{};
};

/// Whose mark is another one than before, and why, a line each.
std::vector<std::string> changed_marks(const nlohmann::ordered_json& before, const nlohmann::ordered_json& now);

/// A document as it is written to a file.
std::string indented(const nlohmann::ordered_json& document);

// --- in the forms that other programs read
/// Texts by the names of their files.
std::map<std::string, std::string> class_exports(const nlohmann::ordered_json& document);
/// Texts by the names of the folders that hold such a file of every student. @param student  the document about one
std::map<std::string, std::string> student_exports(const nlohmann::ordered_json& student);
/// The page about the class. @param date  as it is to be read
std::string class_page(const nlohmann::ordered_json& document, const std::string& date);

}  // namespace workbook
