/// @file
/// Files and programs as tests handle them.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace workbook::testing {

std::string read(const std::filesystem::path& file);
/// Returns the file. @throws if it cannot be written
std::filesystem::path write(const std::filesystem::path& file, const std::string& text);

/// Replaces the first `from` in the file. @throws if it is not there, so that a test cannot go stale unseen.
void replace_in(const std::filesystem::path& file, const std::string& from, const std::string& to);

using ZipEntries = std::vector<std::pair<std::string, std::optional<std::string>>>;
/// Writes a zip file; where there is no text it is a symbolic link to /etc/passwd.
void write_zip(const std::filesystem::path& file, const ZipEntries& texts);

/// Does the text contain the part?
bool has(const std::string& text, const std::string& part);

/// Is WebAssembly in it, also as a base64 text?
bool holds_webassembly(const std::string& text);

/// All ordinary files below a folder.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// The exit status of a shell's command, or -1 if a signal ended it.
int run_in_shell(const std::string& command);

/// What one run of a program left behind.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;

  std::string said() const { return out + err; }
  /// Standard output as JSON. @throws if it is not one document and nothing else.
  nlohmann::json json() const { return nlohmann::json::parse(out); }
  /// The first result of `check --json`.
  nlohmann::json result() const { return json().at("results").at(0); }
};

/// Runs a shell's command without input. @param scratch  a folder for what it prints
Outcome run_command(const std::string& command, const std::filesystem::path& scratch);

}  // namespace workbook::testing
