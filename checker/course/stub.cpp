#include "checker/course/stub.hpp"

#include "checker/base/files.hpp"
#include "checker/base/text.hpp"

#include <fmt/format.h>

#include <regex>
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

std::string declared_signature(const Course& course, const Exercise& exercise) {
  const std::string header = read_file(course.contract_file(*exercise.card)).value_or("");
  std::smatch found;
  const std::regex declaration("(?:^|\n)([A-Za-z][^;{}/\n]*\\b" + exercise.name() + "\\([^;{}]*\\));");
  if (!std::regex_search(header, found, declaration)) return "";
  return std::regex_replace(found[1].str(), std::regex("\\s+"), " ");
}

std::string stub_text(const CardExercise& entry, const std::string& contract, const std::string& signature) {
  std::string task;
  for (const std::string& line : wrapped_lines(entry.task, stub_width - 3)) task += "// " + line + "\n";
  return fmt::format(
      "{}"
      "#include <rigid/{}.hpp>\n"
      "\n"
      "namespace rigid {{\n"
      "\n"
      "{} {{\n"
      "  // TODO: write this function; the next line says that you have not started yet.\n"
      "  throw NotStarted{{}};\n"
      "}}\n"
      "\n"
      "}}  // namespace rigid\n",
      task, contract, wrapped_parameters(signature));
}

bool is_begun(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_file(file);
  return text && text->find("throw NotStarted") == std::string::npos;
}

}  // namespace workbook
