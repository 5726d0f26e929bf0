#include "checker/commands/on_demand/given_away.hpp"

#include "checker/source/source_text.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace workbook {

namespace {

constexpr std::size_t fewest_letters = 20;  // of a formula that is not everybody's
constexpr std::size_t fewest_tokens = 12;   // the same of code

using Words = std::vector<std::string>;

std::string whole_text(const fs::path& file) { return read_file(file).value_or(""); }

/// What stands between two marks, each time.
Words between(std::string_view text, std::string_view from, std::string_view to) {
  Words all;
  for (std::size_t begin = text.find(from); begin != std::string_view::npos; begin = text.find(from, begin)) {
    begin += from.size();
    const std::size_t end = text.find(to, begin);
    if (end == std::string_view::npos) break;
    all.emplace_back(text.substr(begin, end - begin));
    begin = end + to.size();
  }
  return all;
}

/// The lines that one sees without a click.
std::string unfolded(const std::string& text) {
  std::string seen;
  bool is_folded = false;
  for (const std::string& line : lines_of(text)) {
    if (search(line, R"(^\s*\\(folded|solved)\{|^\s*\\answer\s*$)")) is_folded = true;
    if (!is_folded) seen += line + "\n";
    if (search(line, R"(^\s*\\(endfolded|endanswer)\b)")) is_folded = false;
  }
  return seen;
}

/// The members of the equations in a formula, without what only sets them in type.
Words members_of(const std::string& formula) {
  std::string text = replaced(formula, R"(\\(qquad|quad|Longrightarrow)\b|\\\\(\[\w+\])?|\\text\{[^}]*\})", "=");
  text = replaced(text, R"(\\(begin|end)\{\w+\}|\\(left|right|[bB]igg?[lr]?|vec|mat|unit|hat|mathrm)\b|\\[,;:! ])", "");
  text = replaced(replaced(text, R"(\\[td]frac\b)", R"(\frac)"), R"([\s{}&])", "");
  Words members;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find('=', begin);
    members.push_back(replaced(text.substr(begin, end - begin), "^[,.:;]+|[,.:;]+$", ""));
  }
  std::erase_if(members, [](const std::string& member) { return member.size() < fewest_letters; });
  return members;
}

std::set<std::string> formulas_in(const std::string& text) {
  std::set<std::string> all;
  for (const auto& [from, to] : {std::pair{R"(\f[)", R"(\f])"}, std::pair{R"(\f$)", R"(\f$)"}})
    for (const std::string& formula : between(text, from, to))
      for (const std::string& member : members_of(formula)) all.insert(member);
  return all;
}

/// What the last display of a derivation says, before second routes and remarks, of what stands on its left side.
Words answers_of(const std::string& derivation) {
  const Match remarks = search(derivation, R"(\n\*(Second route|Digits|Wrong turns|As a sum)\b)");
  const Words displays =
      between(derivation.substr(0, remarks ? remarks.offsets[0] : derivation.size()), R"(\f[)", R"(\f])");
  return displays.empty() ? Words() : members_of(displays.back().substr(displays.back().find('=') + 1));
}

/// Tokens of a piece of code. Variables have a mark in front; functions, types and members keep their names.
Words tokens_of(const std::string& code) {
  const SourceText source(code);
  Words words;
  const std::vector<Token>& tokens = source.tokens();
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string word(tokens[i].text);
    if (word == "std" || word == "::") continue;
    const bool is_name = search(word, "^[A-Za-z_]").groups.size() > 0;
    const bool is_called = i + 1 < tokens.size() && tokens[i + 1].text == "(";
    const bool is_member = i > 0 && (tokens[i - 1].text == "." || tokens[i - 1].text == "->");
    words.push_back(is_name && !is_called && !is_member ? "$" + word : word);
  }
  return words;
}

/// The same code but for the names of variables, one to one.
bool stands_at(const Words& code, std::size_t at, const Words& wanted) {
  std::map<std::string, std::string> name, back;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const std::string &here = code[at + i], &there = wanted[i];
    if (here[0] != '$' || there[0] != '$') {
      if (here != there) return false;
    } else if (name.emplace(there, here).first->second != here || back.emplace(here, there).first->second != there) {
      return false;
    }
  }
  return true;
}

bool holds(const Words& code, const Words& wanted) {
  for (std::size_t at = 0; at + wanted.size() <= code.size(); ++at)
    if (stands_at(code, at, wanted)) return true;
  return false;
}

}  // namespace

std::vector<GivenAway> answers_given_away(const Course& course, const Exercise& problem) {
  std::vector<GivenAway> found;
  const fs::path notes_file = course.notes_file(*problem.card), hints_file = course.hints_file(problem);
  const std::string notes = unfolded(whole_text(notes_file));
  std::vector<std::pair<fs::path, std::string>> texts = {
      {notes_file, notes}, {course.contract_file(*problem.card), whole_text(course.contract_file(*problem.card))}};
  Words hints = read_hints(hints_file);
  hints.resize(std::min<std::size_t>(hints.size(), 2));
  for (const std::string& hint : hints) texts.emplace_back(hints_file, hint);
  const Words answers = answers_of(whole_text(course.derivation_file(problem)));
  for (const auto& [file, text] : texts) {
    const std::set<std::string> formulas = formulas_in(text);
    for (const std::string& answer : answers)
      if (formulas.contains(answer))
        found.push_back(
            {file, fmt::format("gives away the formula of the problem {0} (its derivation ends with `{1}`); "
                               "put it behind `\\solved{{{0}}}`, or say it in words.",
                               problem.name(), answer)});
  }

  std::vector<Words> returned;
  for (const std::string& expression : between(whole_text(course.solution_file(problem)), "return ", ";"))
    if (const Words tokens = tokens_of(expression); tokens.size() >= fewest_tokens) returned.push_back(tokens);
  for (const Match& quote : search_all(notes, R"(\\snippet\s+(\S+)\s+([^\n]*\S)|\\computed\{([^,}]+),([^}]+)\})")) {
    const bool is_snippet = !quote[1].empty();
    const fs::path file = course.lectures() / (is_snippet ? quote[1] : quote[3] + "/worked_examples.cpp");
    const std::string mark = "//! [" + (is_snippet ? quote[2] : quote[4] + " in brief") + "]";
    for (const std::string& region : between(whole_text(file), mark, mark))
      if (const Words code = tokens_of(region);
          std::ranges::any_of(returned, [&](const Words& each) { return holds(code, each); }))
        found.push_back(
            {file, fmt::format("`{}` shows what the solution of the problem {} returns; show another curve or "
                               "another body there.",
                               mark, problem.name())});
  }
  return found;
}

}  // namespace workbook
