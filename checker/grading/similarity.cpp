// Right answers that have more in common than those of people who think alike, by winnowed fingerprints of their
// tokens: S. Schleimer, D. S. Wilkerson, A. Aiken, Winnowing: local algorithms for document fingerprinting, 2003.
#include "checker/grading/grading.hpp"
#include "checker/source/source_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace workbook {
namespace {

using nlohmann::ordered_json;

// Whatever two texts share is found if it has gram + window − 1 tokens.
constexpr std::size_t gram = 8, window = 4;
// tests/grading/similarity.cpp measures them: unrelated right answers share less, renamed and reordered copies more.
constexpr double alike = 0.65;
constexpr std::size_t least_in_common = 16;  // of fingerprints: some sixty tokens; what is shorter, many write alike
constexpr std::size_t most_pairs = 50, most_of_a_text = 6000;

/// Names count as one: who copies renames.
std::size_t meaning_of(const std::vector<Token>& tokens, std::size_t at) {
  constexpr std::array kept = {"if", "else", "for", "while", "return", "const", "auto", "double", "int"};
  const std::string_view text = tokens[at].text;
  const bool is_name = std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_';
  const std::string_view before = at > 0 ? tokens[at - 1].text : "";
  const bool is_member = before == "." || before == "->" || before == "::";
  return std::hash<std::string_view>()(is_name && !is_member && std::ranges::count(kept, text) == 0 ? "name" : text);
}

std::set<std::uint32_t> fingerprints_of(const std::string& code) {
  const SourceText source(code);
  std::vector<Token> tokens = source.tokens();
  std::erase_if(tokens, &Token::in_directive);
  std::vector<std::uint32_t> hashes;
  for (std::size_t at = 0; at + gram <= tokens.size(); ++at) {
    std::uint64_t hash = 0;
    for (std::size_t k = at; k < at + gram; ++k) hash = (hash ^ meaning_of(tokens, k)) * 0x100000001b3ULL;
    hashes.push_back(static_cast<std::uint32_t>(hash >> 32));
  }
  std::set<std::uint32_t> chosen;
  for (std::size_t at = 0; at < hashes.size(); ++at)
    chosen.insert(
        *std::min_element(hashes.begin() + static_cast<std::ptrdiff_t>(at),
                          hashes.begin() + static_cast<std::ptrdiff_t>(std::min(at + window, hashes.size()))));
  return chosen;
}

}  // namespace

void SimilarAnswers::take_off(const std::string& exercise, const std::string& text) {
  of_course_[exercise].merge(fingerprints_of(text));
}

void SimilarAnswers::add(const std::string& exercise, const std::string& student, const std::string& place,
                         const std::string& text) {
  Answer& answer = answers_[exercise][fingerprint(text)];
  if (answer.students.empty()) {
    answer.text = text;
    for (const std::uint32_t print : fingerprints_of(text))
      if (!of_course_[exercise].contains(print)) answer.prints.push_back(print);
  }
  answer.students[place].push_back(student);
}

ordered_json SimilarAnswers::pairs() const {
  std::vector<ordered_json> pairs;
  const auto add = [&](const std::string& exercise, double share, const Answer& one, const Answer& other) {
    ordered_json pair = {{"exercise", exercise}, {"share", std::round(100 * share) / 100}};
    for (const Answer* answer : {&one, &other}) {
      std::vector<std::string> students;
      for (const auto& [place, ids] : answer->students)
        if (&one != &other || (place == one.students.begin()->first) == pair["answers"].empty())
          students.insert(students.end(), ids.begin(), ids.end());
      pair["answers"].push_back({{"students", students}, {"text", cut(answer->text, most_of_a_text)}});
    }
    pairs.push_back(std::move(pair));
  };
  for (const auto& [exercise, by_text] : answers_) {
    std::vector<const Answer*> answers;
    std::map<std::uint32_t, std::vector<std::size_t>> who_has;
    for (const auto& [unused, answer] : by_text) {
      for (const std::uint32_t print : answer.prints) who_has[print].push_back(answers.size());
      answers.push_back(&answer);
    }
    // What most have is how one writes it.
    const std::size_t most = std::max<std::size_t>(3, answers.size() / 2);
    std::erase_if(who_has, [&](const auto& each) { return each.second.size() > most; });
    std::vector<std::size_t> own(answers.size(), 0);
    for (const auto& [unused, having] : who_has)
      for (const std::size_t each : having) ++own[each];
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i]->students.size() > 1 && own[i] >= least_in_common) add(exercise, 1, *answers[i], *answers[i]);
      std::vector<std::size_t> common(answers.size(), 0);
      for (const std::uint32_t print : answers[i]->prints)
        if (const auto having = who_has.find(print); having != who_has.end())
          for (const std::size_t each : having->second) ++common[each];
      for (std::size_t k = i + 1; k < answers.size(); ++k) {
        const double share =
            static_cast<double>(common[k]) / static_cast<double>(std::max<std::size_t>(1, std::min(own[i], own[k])));
        if (common[k] >= least_in_common && share >= alike) add(exercise, share, *answers[i], *answers[k]);
      }
    }
  }
  std::ranges::stable_sort(pairs, std::greater<>(),
                           [](const ordered_json& pair) { return pair["share"].get<double>(); });
  pairs.resize(std::min(pairs.size(), most_pairs));
  return pairs;
}

}  // namespace workbook
