#include "tests/support/files.hpp"

#include <archive.h>
#include <archive_entry.h>
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

void write_zip(const fs::path& file, const ZipEntries& texts) {
  fs::create_directories(file.parent_path());
  archive* const zip = archive_write_new();
  archive_write_set_format_zip(zip);
  archive_write_open_filename(zip, file.c_str());
  for (const auto& [name, text] : texts) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_filetype(entry, text ? AE_IFREG : AE_IFLNK);
    archive_entry_set_perm(entry, 0644);
    if (text)
      archive_entry_set_size(entry, static_cast<la_int64_t>(text->size()));
    else
      archive_entry_set_symlink(entry, "/etc/passwd");
    if (archive_write_header(zip, entry) != ARCHIVE_OK) throw std::runtime_error(archive_error_string(zip));
    if (text) archive_write_data(zip, text->data(), text->size());
    archive_entry_free(entry);
  }
  archive_write_free(zip);
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
  const int status =
      run_in_shell(fmt::format("{{ {}\n}} </dev/null >'{}' 2>'{}'", command, out.string(), err.string()));
  return {status, read(out), read(err)};
}

}  // namespace workbook::testing
