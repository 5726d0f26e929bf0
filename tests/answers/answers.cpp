// Evidence that the checker can be trusted: answers as students write them, wrong ones and right ones, that were
// written without a look at the judging. No wrong one may pass; every right one must pass without a word against it.
//
// A file holds the answers to one exercise. It begins with the #include lines of all of them and the line that most of
// them begin with, the function's head. Then each answer has a line "//! right: TITLE" or "//! wrong: TITLE" and one of:
// the function's body; code of its own, without `namespace rigid { }`; or, with lines that begin with + and -, its
// difference from the last answer above that is none: a unified diff without line numbers, with "@@" between its hunks.
#include <doctest/doctest.h>
#include "checker/base/text.hpp"
#include "tests/support/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace workbook::testing;
using workbook::lines_of;

struct Answer {
  std::string exercise, title, code;
  bool is_right = false;
  // what the checker says
  std::string verdict, message;
  std::vector<std::string> reasons;
  std::set<std::string> explainers = {};  // that gave them
};

std::string environment(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

/// The code with each hunk of a difference put in. @throws if what a hunk replaces does not stand in the code just once
std::string patched(std::string code, const Answer& difference) {
  std::string before = "\n", after = "\n";
  code = "\n" + code;
  for (const std::string& line : lines_of(difference.code + "@@")) {
    if (line.empty()) continue;
    if (line != "@@") {
      if (line[0] != '+') before += line.substr(1) + "\n";
      if (line[0] != '-') after += line.substr(1) + "\n";
      continue;
    }
    const std::size_t at = code.find(before);
    if (at == std::string::npos || code.find(before, at + 1) != std::string::npos)
      throw std::runtime_error(fmt::format("{}, {}: the answer above does not have this just once:{}",
                                           difference.exercise, difference.title, before));
    code.replace(at, before.size(), after);
    before = after = "\n";
  }
  return code.substr(1);
}

/// The answers in the text of a file, as whole files that students hand in.
std::vector<Answer> answers_in(const std::string& text, const std::string& exercise) {
  std::vector<Answer> answers;
  std::string includes, head, whole;
  for (const std::string& line : lines_of(text)) {
    const bool is_right = line.starts_with("//! right: ");
    if (is_right || line.starts_with("//! wrong: "))
      answers.push_back({exercise, line.substr(std::size("//! right: ") - 1), "", is_right, "", "", {}});
    else
      (!answers.empty() ? answers.back().code : line.starts_with('#') ? includes : head) += line + "\n";
  }
  for (Answer& answer : answers) {
    if (has("\n" + answer.code, "\n+") || has("\n" + answer.code, "\n-"))
      answer.code = patched(whole, answer);
    else if (!answer.code.starts_with(' '))
      whole = answer.code;
    else if (head.empty())
      throw std::runtime_error(fmt::format("{}, {}: a body, but the file has no head", exercise, answer.title));
    else
      answer.code = whole = head + answer.code + "}\n";
    answer.code = fmt::format("{}namespace rigid {{\n{}}}  // namespace rigid\n", includes, answer.code);
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
    for (Answer& answer : answers_in(read(file), file.stem())) all.push_back(std::move(answer));
  return all;
}

/// Writes them as EXERCISE/right_1.cpp, EXERCISE/wrong_2.cpp, … numbered within their exercise.
void write_all(const std::vector<Answer>& answers, const fs::path& folder) {
  std::map<std::string, int> number;
  for (const Answer& answer : answers)
    write(folder / answer.exercise /
              fmt::format("{}_{}.cpp", answer.is_right ? "right" : "wrong", ++number[answer.exercise]),
          answer.code);
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
  for (const auto& found : result.at("findings")) {
    answer.explainers.insert(found.at("name"));
    answer.reasons.push_back(fmt::format("{} (line {}): {}", found.at("name").get<std::string>(),
                                         found.at("line").get<int>(), found.at("message").get<std::string>()));
  }
  for (const auto& found : result.at("diagnosis")) {
    answer.explainers.insert(found.at("kind"));
    answer.reasons.push_back(fmt::format("{} {}: {}", found.at("kind").get<std::string>(),
                                         found.at("name").get<std::string>(), found.at("message").get<std::string>()));
  }
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

/// Who explains how many of the wrong answers, and how many alone: what costs more than it explains can go.
void print_explainers(const std::vector<Answer>& answers) {
  std::map<std::string, std::pair<int, int>> counts;
  for (const Answer& answer : answers)
    for (const std::string& explainer : answer.explainers) {
      ++counts[explainer].first;
      counts[explainer].second += answer.explainers.size() == 1;
    }
  fmt::print("{:<30} {:>8} {:>6}\n", "explainer", "explains", "alone");
  for (const auto& [explainer, count] : counts)
    fmt::print("{:<30} {:>8} {:>6}\n", explainer, count.first, count.second);
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

TEST_CASE("an answer is a body, code of its own, or a difference from what is above it") {
  const std::string right = "#include <cmath>\ndouble f() {\n//! right: a sum\n  return 1 + 1;\n";
  const std::string before = "#include <cmath>\nnamespace rigid {\n", after = "}  // namespace rigid\n";
  const auto answers = answers_in(right +
                                      "//! wrong: a difference\n double f() {\n-  return 1 + 1;\n+  const int one = 1;\n"
                                      "+  return one - 1;\n@@\n+// the end\n }\n//! wrong: none\nint f();\n",
                                  "f");
  REQUIRE(answers.size() == 3);
  CHECK(answers[0].is_right);
  CHECK(answers[0].code == before + "double f() {\n  return 1 + 1;\n}\n" + after);
  CHECK_FALSE(answers[1].is_right);
  CHECK(answers[1].title == "a difference");
  CHECK(answers[1].code ==
        before + "double f() {\n  const int one = 1;\n  return one - 1;\n// the end\n}\n" + after);
  CHECK(answers[2].code == before + "int f();\n" + after);
  CHECK_THROWS_WITH(answers_in(right + "//! wrong: a typing mistake\n-  return 1;\n+  return 2;\n", "f"),
                    "f, a typing mistake: the answer above does not have this just once:\n  return 1;\n");
  CHECK_THROWS_WITH(answers_in("//! right: a sum\n  return 2;\n", "f"), "f, a sum: a body, but the file has no head");
  CHECK_THROWS(answers_in("//! right: twice\nint a;\nint a;\n//! wrong: which?\n-int a;\n+int b;\n", "f"));

  const std::vector<Answer> all = all_answers();
  const std::string folder = environment("WORKBOOK_WRITE_ANSWERS", "");
  CHECK_FALSE(all.empty());
  if (!folder.empty()) write_all(all, folder);
}

TEST_CASE("no wrong answer passes, and every right answer passes without a word against it") {
  std::vector<Answer> answers = all_answers();
  REQUIRE_FALSE(answers.empty());
  check_all(answers);
  if (!environment("WORKBOOK_REASONS", "").empty()) print_reasons(answers);
  print_explainers(answers);
  print_table(answers);
  for (const Answer& answer : answers) {
    INFO(answer.exercise, ": ", answer.title, "\n", answer.verdict, ": ", answer.message);
    CHECK(answer.verdict != "no_document");
    CHECK(answer.verdict != "checker_error");
    CHECK((answer.verdict == "passed") == answer.is_right);
    if (answer.is_right) CHECK(answer.reasons == std::vector<std::string>{});
  }
}
