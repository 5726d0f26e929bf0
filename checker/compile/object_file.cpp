#include "checker/compile/object_file.hpp"

#include "checker/base/child_process.hpp"
#include "checker/compile/plain_words.hpp"
#include "checker/messages/compiling.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>
#include <sstream>

namespace workbook {
namespace {

std::optional<std::string> demangled(const std::string& linker_name) {
  if (linker_name == "main") return "main()";
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
      abi::__cxa_demangle(linker_name.c_str(), nullptr, nullptr, &status), &std::free);
  if (!text) return std::nullopt;
  return std::string(text.get());
}

}  // namespace

bool ObjectFile::defines(const std::string& linker_name) const {
  return std::any_of(defined.begin(), defined.end(),
                     [&](const Symbol& symbol) { return symbol.linker_name == linker_name; });
}

ObjectFile read_object_file(const std::filesystem::path& object, const Toolchain& toolchain) {
  const std::string program = toolchain.nm.string();
  Launch launch;
  launch.program = program.c_str();
  launch.arguments = {"-p", object.string()};
  launch.environment = {"LC_ALL=C"};
  FinishedProgram listing;
  try {
    listing = run_program(launch, std::chrono::seconds(10), std::size_t{16} << 20);
  } catch (const LaunchError& error) {
    throw ToolchainError(messages::cannot_use(program, error.what()));
  }
  ObjectFile result;
  std::istringstream lines(listing.output);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string address, type, name;
    if (line.starts_with(' '))
      words >> type >> name;
    else
      words >> address >> type >> name;
    const std::optional<std::string> signature = demangled(name);
    if (!signature || signature->find('(') == std::string::npos) continue;
    const Symbol symbol{name, in_contract_words(*signature)};
    if (type == "T" || type == "t") result.defined.push_back(symbol);
    if (type == "U") result.undefined.push_back(symbol);
  }
  return result;
}

}  // namespace workbook
