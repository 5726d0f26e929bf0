#include "checker/compile/source_findings.hpp"

#include "checker/compile/code_text.hpp"
#include "checker/compile/kept_expressions.hpp"
#include "checker/compile/source_file.hpp"
#include "checker/compile/text_mistakes.hpp"
#include "checker/compile/warning_mistakes.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <iterator>
#include <string>
#include <utility>

namespace workbook {
namespace {

constexpr std::size_t most = 4;  // more than these help nobody

constexpr const char* file_name = "looked_at.cpp";  // nobody sees it

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  for (Finding& finding : more) {
    const bool known = std::ranges::any_of(
        all, [&](const Finding& other) { return other.line == finding.line && other.sentence == finding.sentence; });
    if (!known) all.push_back(std::move(finding));
  }
}

std::vector<Diagnostic> said_by(const Compiler& compiler, std::vector<std::string> flags) {
  return diagnostics(compiler.run(compiler.arguments(std::move(flags))).output, compiler.file_name());
}

/// Compiled as far as the assembler's text: with -fsyntax-only the compiler does not notice variables without a value.
std::vector<Finding> warned_of(const Compiler& compiler, const std::string& source) {
  compiler.write(source);
  std::vector<std::string> flags = warning_flags();
  // The file itself and not the unit: behind a #line the compiler looks at no indentation.
  flags.insert(flags.end(), {"-S", file_name, "-o", "../unit.s"});
  return warning_mistakes(said_by(compiler, std::move(flags)), source);
}

std::vector<Finding> kept_in(const Compiler& compiler, const std::string& source) {
  const DemandingCopy copy = demanding_copy(source);
  if (copy.source.empty()) return {};
  compiler.write(copy.source, copy.before);
  return kept_expressions(said_by(compiler, {"-fsyntax-only", "../unit.cpp"}), copy, source);
}

}  // namespace

std::vector<Finding> source_findings(const CompileTask& task, const Toolchain& toolchain,
                                     const std::filesystem::path& cache_directory, Depth depth,
                                     const CompileLimits& limits) {
  try {
    const std::string source = read_source(task.file);
    std::vector<Finding> found = text_mistakes(source);
    if (depth == Depth::compiler) {
      const BuildCache cache(std::filesystem::absolute(cache_directory));
      const auto with_compiler = [&](auto look) {
        const Workspace workspace(cache.directory());
        return look(Compiler(toolchain, limits, file_name, workspace.directory()), source);
      };
      // Side by side: the student waits for both.
      auto kept = std::async(std::launch::async, [&] { return with_compiler(kept_in); });
      std::vector<Finding> warned = with_compiler(warned_of);
      append(found, kept.get());
      append(found, std::move(warned));
    }
    if (found.size() > most) found.resize(most);
    std::ranges::stable_sort(found, {}, &Finding::line);
    return found;
  } catch (const std::exception&) {
    return {};  // it is a help only; what matters has been judged
  }
}

}  // namespace workbook
