#include "checker/compile/toolchain.hpp"

#include "checker/messages/compiling.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace workbook {
namespace {

constexpr int current_format = 1;

std::vector<std::filesystem::path> paths(const nlohmann::json& list) {
  const auto strings = list.get<std::vector<std::string>>();
  return {strings.begin(), strings.end()};
}

void require_file(const std::filesystem::path& file, messages::ToolchainPart part) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored))
    throw ToolchainError(messages::part_is_missing(part, file.string()));
}

}  // namespace

Toolchain read_toolchain(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw ToolchainError(messages::toolchain_cannot_be_read(file.string()));
  try {
    const nlohmann::json json = nlohmann::json::parse(stream);
    if (json.at("format") != current_format) throw ToolchainError(messages::toolchain_of_another_format(file.string()));
    Toolchain toolchain;
    toolchain.compiler = json.at("compiler").get<std::string>();
    toolchain.flags = json.at("flags").get<std::vector<std::string>>();
    toolchain.prelude = json.at("prelude").get<std::string>();
    toolchain.include_directories = paths(json.at("include_directories"));
    toolchain.workers = json.at("workers").get<std::string>();
    toolchain.support = paths(json.at("support"));
    toolchain.link_flags = json.at("link_flags").get<std::vector<std::string>>();
    toolchain.nm = json.at("nm").get<std::string>();
    toolchain.second_look = json.value("second_look", "");
    toolchain.addr2line = json.value("addr2line", "");
    return toolchain;
  } catch (const nlohmann::json::exception& error) {
    throw ToolchainError(messages::toolchain_is_damaged(file.string(), error.what()));
  }
}

void require_complete(const Toolchain& toolchain, const std::string& exercise) {
  using messages::ToolchainPart;
  require_file(toolchain.compiler, ToolchainPart::compiler);
  require_file(toolchain.prelude, ToolchainPart::prelude);
  require_file(toolchain.worker_object(exercise), ToolchainPart::worker);
  for (const std::filesystem::path& object : toolchain.support) require_file(object, ToolchainPart::part_of_worker);
}

}  // namespace workbook
