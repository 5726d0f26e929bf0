/// @file
/// Mistakes in a file that compiles but fails: what its text, the compiler's warnings and the check for kept
/// expressions give away.
#pragma once

#include "checker/compile/compile.hpp"

#include <filesystem>
#include <vector>

namespace workbook {

/// What is certainly so in the file and may be what is wrong, by line; a few at most. Whatever goes wrong here means
/// only that nothing is found. Where the file says `auto`, it is compiled once more for that.
std::vector<Finding> source_findings(const CompileTask& task, const Compilation& compilation,
                                     const Toolchain& toolchain, const std::filesystem::path& cache_directory,
                                     const CompileLimits& limits = {.time = std::chrono::seconds(3)});

/// Is it only odd, and no reason why a function crashes or stops?
bool is_remark(const Finding& finding);

}  // namespace workbook
