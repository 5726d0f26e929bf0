// Right answers that are alike: those of people who do not know of each other are not, renamed and reordered copies
// are.
#include "checker/base/text.hpp"
#include "checker/grading/grading.hpp"
#include "tests/support/files.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace workbook::testing;

namespace {

namespace fs = std::filesystem;

/// The right answers of the evidence that are no difference from another one, by exercise. tests/answers/answers.cpp
/// tells how they are written.
std::map<std::string, std::vector<std::string>> unrelated_answers() {
  std::map<std::string, std::vector<std::string>> answers;
  for (const fs::path& file : files_below(fs::path(WORKBOOK_ROOT) / "tests/answers")) {
    if (file.parent_path().filename() == "answers") continue;
    std::vector<std::string>& of = answers[file.parent_path().filename().string() + "/" + file.stem().string()];
    std::string head;
    bool is_right = false, is_first = true;
    for (const std::string& line : workbook::lines_of(read(file))) {
      if (line.starts_with("//! ")) {
        is_right = line.starts_with("//! right");
        is_first = false;
        if (is_right) of.emplace_back();
      } else if (is_right) {
        of.back() += line + "\n";
      } else if (is_first && !line.starts_with('#')) {
        head += line + "\n";
      }
    }
    std::erase_if(of, [](const std::string& text) { return bool(workbook::search("\n" + text, "\n[-+]")); });
    for (std::string& text : of)
      if (text.starts_with(' ')) text.insert(0, head).append("}\n");
  }
  return answers;
}

/// With other names, and of each two lines that are statements the second first.
std::string copied(const std::string& answer) {
  std::vector<std::string> lines;
  for (const std::string& line : workbook::lines_of(workbook::replaced(answer, R"(\b([a-z]\w?)\b(?!\s*\())", "my_$1")))
    if (!line.empty()) lines.push_back(line);
  const auto is_statement = [&](const std::string& line) {
    return line.ends_with(';') && line.find("return") == std::string::npos;
  };
  for (std::size_t k = 2; k + 1 < lines.size(); k += 5)
    if (is_statement(lines[k]) && is_statement(lines[k + 1])) std::swap(lines[k], lines[k + 1]);
  std::string text = "// Written all by myself.\n";
  for (const std::string& line : lines) text += line + "  // of course\n";
  return text;
}

/// @param answers  to one exercise
std::size_t pairs_among(const std::string& exercise, const std::vector<std::string>& answers) {
  workbook::SimilarAnswers similar;
  const std::string name = exercise.substr(exercise.find('/') + 1), lecture = exercise.substr(0, exercise.find('/'));
  for (const std::string& file : {"lectures/" + lecture + "/exercises/" + name, "solutions/" + exercise,
                                  "lectures/" + lecture + "/worked_examples"})
    similar.take_off(name, read(fs::path(WORKBOOK_ROOT) / (file + ".cpp")));
  for (std::size_t k = 0; k < answers.size(); ++k) similar.add(name, std::to_string(k), std::to_string(k), answers[k]);
  return similar.pairs().size();
}

}  // namespace

TEST_CASE("of unrelated right answers none are alike, and copies with other names and another order are" *
          doctest::test_suite("thorough")) {
  std::size_t answers = 0, copies = 0, long_enough = 0;
  for (const auto& [exercise, texts] : unrelated_answers()) {
    CAPTURE(exercise);
    answers += texts.size();
    CHECK(pairs_among(exercise, texts) == 0);
    for (const std::string& text : texts) {
      const bool is_long = pairs_among(exercise, {text, text}) == 1;
      long_enough += is_long ? 1 : 0;
      copies += is_long && pairs_among(exercise, {text, copied(text)}) == 1 ? 1 : 0;
    }
  }
  MESSAGE(answers, " unrelated right answers; ", copies, " of ", long_enough, " copies are found");
  CHECK(answers >= 170);
  CHECK(long_enough * 2 > answers);
  CHECK(copies * 20 >= long_enough * 19);
}

TEST_CASE("a file that several have handed in together is no copy, and what most write is nobody's") {
  const auto answers = unrelated_answers().at("03_inertia_tensor/principal_moments");
  const std::string text = *std::ranges::max_element(answers, {}, &std::string::size);  // a short one tells nothing
  workbook::SimilarAnswers group;
  for (const char* student : {"ada", "ben"}) group.add("e", student, "submission_1/e.cpp", text);
  CHECK(group.pairs().empty());
  group.add("e", "cleo", "submission_2/e.cpp", text);
  const auto pairs = group.pairs();
  REQUIRE(pairs.size() == 1);
  CHECK(pairs[0].at("share") == 1);
  CHECK(pairs[0].at("answers")[0].at("students") == nlohmann::json({"ada", "ben"}));
  CHECK(pairs[0].at("answers")[1].at("students") == nlohmann::json({"cleo"}));
  workbook::SimilarAnswers usual;
  for (int k = 0; k < 5; ++k) usual.add("e", std::to_string(k), std::to_string(k), text + "// " + std::to_string(k));
  CHECK(usual.pairs().empty());
}
