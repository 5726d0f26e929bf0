#include "checker/course/stub.hpp"

#include "checker/messages/course_files.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <system_error>

namespace workbook {

namespace {

constexpr std::size_t line_width = 118;

/// The task as `//` lines.
std::string as_comment(const std::string& task) {
  std::istringstream words(task);
  std::string text;
  std::string line = "//";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > line_width) {
      text += line + "\n";
      line = "//";
    }
    line += " " + word;
  }
  return text + line + "\n";
}

/// A long list of parameters goes on below its own beginning.
std::string wrapped(const std::string& signature) {
  const std::string indent(signature.find('(') + 1, ' ');
  std::string text;
  std::string line;
  std::istringstream parts(signature);
  for (std::string part; std::getline(parts, part, ',');) {
    const bool first = line.empty();
    const std::string piece = first ? part : "," + part;
    if (!first && line.size() + piece.size() + 3 > line_width) {
      text += line + ",\n";
      line = indent + part.substr(1);
    } else {
      line += piece;
    }
  }
  return text + line;
}

}  // namespace

std::string stub_text(const std::string& task, const std::string& contract, const std::string& signature) {
  return fmt::format(
      "{}"
      "#include <rigid/{}.hpp>\n"
      "\n"
      "namespace rigid {{\n"
      "\n"
      "{} {{\n"
      "  // {}\n"
      "  throw NotStarted{{}};\n"
      "}}\n"
      "\n"
      "}}  // namespace rigid\n",
      as_comment(task), contract, wrapped(signature), messages::stub_comment());
}

bool is_begun(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return in.good() && text.str().find("throw NotStarted") == std::string::npos;
}

}  // namespace workbook
