#include "checker/course/course.hpp"

#include <boost/algorithm/string/replace.hpp>

#include <sstream>

namespace workbook {

namespace {

constexpr std::size_t stub_width = 118;

/// A long list of parameters goes on below its own beginning.
std::string wrapped_parameters(const std::string& signature) {
  const std::string margin(signature.find('(') + 1, ' ');
  std::string text;
  std::string line;
  std::istringstream parts(signature);
  for (std::string part; std::getline(parts, part, ',');) {
    if (line.empty()) {
      line = part;
    } else if (line.size() + part.size() + 4 > stub_width) {
      text += line + ",\n";
      line = margin + part.substr(1);
    } else {
      line += "," + part;
    }
  }
  return text + line;
}

}  // namespace

std::vector<std::string> read_hints(const fs::path& file) {
  const std::optional<std::string> text = read_file(file);
  if (!text) throw CourseError(fmt::format("{}: missing; take the file from the workbook again.", file.string()));
  std::vector<std::string> hints(1);
  for (const std::string& line : lines_of(*text)) {
    if (line == "---") hints.emplace_back();
    if (line != "---" && !(line.empty() && hints.back().empty())) hints.back() += line + "\n";
  }
  for (std::string& hint : hints) hint.erase(hint.find_last_not_of('\n') + 1);
  std::erase(hints, "");
  if (hints.empty())
    throw CourseError(fmt::format("{}: there is no hint in it; write three, weakest first.", file.string()));
  return hints;
}

std::map<std::string, std::string> read_headings(const fs::path& notes) {
  std::map<std::string, std::string> headings;
  for (const std::string& line : lines_of(read_file(notes).value_or("")))
    if (line.starts_with('#'))
      if (const Match heading = search(line, R"(^#+\s+(.*\S)\s*\{#(\w+)\}\s*$)"))
        headings.emplace(heading[2], heading[1]);
  return headings;
}

std::string paragraph_on_mistake(const Course& course, const std::string& name) {
  for (const Card& card : course.cards()) {
    std::string anchor;
    bool is_in_list = false;
    for (const std::string& line : lines_of(read_file(course.notes_file(card)).value_or(""))) {
      if (const Match heading = line.starts_with('#') ? search(line, R"(\{#(\w+)\}\s*$)") : Match())
        anchor = heading[1];
      is_in_list = is_in_list || line.starts_with("<!-- mistakes:");
      if (is_in_list && (" " + line + " ").find(" " + name + " ") != std::string::npos) return anchor;
      is_in_list = is_in_list && line.find("-->") == std::string::npos;
    }
  }
  return "";
}

std::string example_that_calls(const Course& course, const Exercise& exercise) {
  const std::string text = read_file(course.lectures() / exercise.lecture() / "worked_examples.cpp").value_or("");
  std::string title;
  const std::string begin = R"rx(TEST_CASE\("(?:\w+: )?([^"]+)"\) \{)rx";
  for (const Match& each : search_all(text, begin + "|\\b" + exercise.name() + "\\(")) {
    if (each[1].empty() && !title.empty()) return title;
    title = each[1];
  }
  return "";
}

std::string declared_signature(const Course& course, const Exercise& exercise) {
  const std::string header = read_file(course.contract_file(*exercise.card)).value_or("");
  const Match found = search(header, "(?:^|\n)([A-Za-z][^;{}/\n]*\\b" + exercise.name() + "\\([^;{}]*\\));");
  return replaced(found[1], "\\s+", " ");
}

std::string from_skeleton(const std::string& name, const std::map<std::string, std::string>& fields) {
  const fs::path file = fs::path(WORKBOOK_SKELETONS) / name;
  std::optional<std::string> text = read_file(file);
  if (!text) throw std::runtime_error(fmt::format("{} cannot be read.", shown_path(file)));
  for (const auto& [field, value] : fields) boost::replace_all(*text, "@" + field + "@", value);
  return *text;
}

std::string stub_text(const Exercise& exercise, const std::string& signature) {
  return from_skeleton(
      "exercise/stub.cpp",
      {{"NAME", exercise.name()}, {"CONTRACT", exercise.card->contract}, {"SIGNATURE", wrapped_parameters(signature)}});
}

bool is_begun(const fs::path& file) {
  const std::optional<std::string> text = read_file(file);
  return text && text->find("throw NotStarted") == std::string::npos;
}

}  // namespace workbook
