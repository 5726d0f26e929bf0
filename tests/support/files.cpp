#include "tests/support/files.hpp"

#include <fmt/format.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace workbook::testing {

namespace fs = std::filesystem;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

fs::path write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + file.string());
  return file;
}

void replace_in(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = read(file);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error(fmt::format("'{}' is not in {}", from, file.string()));
  write(file, text.replace(at, from.size(), to));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool holds_webassembly(const std::string& text) {
  // Its first eight bytes, or these in base64; in two parts, for this file is a part of what is searched.
  return has(text, {"\0asm\1\0\0\0", 8}) || has(text, std::string("AGFzbQ") + "EAAAA");
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  return files;
}

int run_in_shell(const std::string& command) {
  const int raw = std::system(command.c_str());
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
}

Outcome run_command(const std::string& command, const fs::path& scratch) {
  fs::create_directories(scratch);
  const fs::path out = scratch / "stdout.txt", err = scratch / "stderr.txt";
  const int status = run_in_shell(fmt::format("{} </dev/null >'{}' 2>'{}'", command, out.string(), err.string()));
  return {status, read(out), read(err)};
}

}  // namespace workbook::testing
