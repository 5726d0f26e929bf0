// Evidence that the checker can be trusted: answers as students write them, wrong ones and right ones, that were
// written without a look at the judging. No wrong one may pass; every right one must pass without a word against it.
#include <doctest/doctest.h>
#include "tests/support/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;

struct Answer {
  std::string exercise, title, code;
  bool is_right = false;
  // what the checker says
  std::string verdict, message;
  std::vector<std::string> reasons;
};

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

/// The answers of one file, which begin with lines "//! wrong: TITLE" or "//! right: TITLE".
std::vector<Answer> answers_in(const fs::path& file) {
  std::vector<Answer> answers;
  std::istringstream lines(read(file));
  for (std::string line; std::getline(lines, line);) {
    const bool is_right = line.starts_with("//! right: ");
    if (is_right || line.starts_with("//! wrong: ")) {
      answers.push_back({file.stem(), line.substr(std::size("//! right: ") - 1), "", is_right, "", "", {}});
    } else {
      if (answers.empty()) throw std::runtime_error(file.string() + " does not begin with //! wrong: or //! right:");
      answers.back().code += line + "\n";
    }
  }
  return answers;
}

std::vector<Answer> all_answers() {
  const std::string chosen = environment("WORKBOOK_ANSWERS", "");
  std::vector<fs::path> files;
  for (const fs::path& file : files_below(WORKBOOK_TEST_ANSWERS))
    if (file.extension() == ".cpp" && file.parent_path() != WORKBOOK_TEST_ANSWERS && has(file.string(), chosen))
      files.push_back(file);
  std::sort(files.begin(), files.end());
  std::vector<Answer> all;
  for (const fs::path& file : files)
    for (Answer& answer : answers_in(file)) all.push_back(std::move(answer));
  return all;
}

void check(Answer& answer, const fs::path& scratch) try {
  const fs::path file = write(scratch / (answer.exercise + ".cpp"), answer.code);
  const Outcome checked = run_command(fmt::format("'{}' check {} --file '{}' --seed {} --json", WORKBOOK_TEST_CHECKER,
                                                  answer.exercise, file.string(), environment("WORKBOOK_SEED", "1")),
                                      scratch);
  if (!checked.err.empty()) throw std::runtime_error(checked.err);  // of what explains, and is left out if it crashes
  const auto result = checked.result();
  answer.verdict = result.at("verdict");
  answer.message = result.at("message");
  for (const auto& found : result.at("findings"))
    answer.reasons.push_back(fmt::format("{} (line {}): {}", found.at("name").get<std::string>(),
                                         found.at("line").get<int>(), found.at("message").get<std::string>()));
  for (const auto& found : result.at("diagnosis"))
    answer.reasons.push_back(fmt::format("{} {}: {}", found.at("kind").get<std::string>(),
                                         found.at("name").get<std::string>(), found.at("message").get<std::string>()));
} catch (const std::exception& problem) {
  answer.verdict = "no_document";
  answer.message = problem.what();
}

void check_all(std::vector<Answer>& answers) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&](const fs::path& scratch) {
    for (std::size_t i = next++; i < answers.size(); i = next++) check(answers[i], scratch);
  };
  const fs::path scratch = WORKBOOK_TEST_SCRATCH;
  std::jthread other(work, scratch / "one");
  work(scratch / "two");
}

/// For a person who judges whether each reason is true.
void print_reasons(const std::vector<Answer>& answers) {
  for (const Answer& answer : answers) {
    if (answer.is_right) continue;
    fmt::print("{}: {}\n    {}: {}\n", answer.exercise, answer.title, answer.verdict, answer.message);
    for (const std::string& reason : answer.reasons) fmt::print("    - {}\n", reason);
  }
}

struct Counts {
  int wrong = 0, rejected = 0, explained = 0, right = 0, passed = 0;
};

void print_table(const std::vector<Answer>& answers) {
  std::map<std::string, Counts> table;
  for (const Answer& answer : answers) {
    const bool passed = answer.verdict == "passed";
    for (const std::string& row : {answer.exercise, std::string("~ all")}) {  // the tilde sorts last
      Counts& counts = table[row];
      counts.wrong += !answer.is_right;
      counts.rejected += !answer.is_right && !passed;
      counts.explained += !answer.is_right && !passed && !answer.reasons.empty();
      counts.right += answer.is_right;
      counts.passed += answer.is_right && passed;
    }
  }
  fmt::print("{:<30} {:>6} {:>9} {:>14} {:>6} {:>7}\n", "exercise", "wrong", "rejected", "with a reason", "right",
             "passed");
  for (const auto& [row, counts] : table)
    fmt::print("{:<30} {:>6} {:>9} {:>14} {:>6} {:>7}\n", row, counts.wrong, counts.rejected, counts.explained,
               counts.right, counts.passed);
}

}  // namespace

TEST_CASE("no wrong answer passes, and every right answer passes without a word against it") {
  std::vector<Answer> answers = all_answers();
  REQUIRE_FALSE(answers.empty());
  check_all(answers);
  if (!environment("WORKBOOK_REASONS", "").empty()) print_reasons(answers);
  print_table(answers);
  for (const Answer& answer : answers) {
    INFO(answer.exercise, ": ", answer.title, "\n", answer.verdict, ": ", answer.message);
    CHECK(answer.verdict != "no_document");
    CHECK(answer.verdict != "checker_error");
    CHECK((answer.verdict == "passed") == answer.is_right);
    if (answer.is_right) CHECK(answer.reasons == std::vector<std::string>{});
  }
}
