/// @file
/// A closer look at a file that compiles, but fails: mistakes that the text gives away.
#pragma once

#include "checker/compile/compile.hpp"
#include "checker/compile/toolchain.hpp"
#include "checker/data/observation.hpp"

#include <filesystem>
#include <vector>

namespace workbook {

/// How far to look.
enum class Depth {
  text,     ///< at the text alone, which costs no time
  compiler  ///< at what the compiler warns of as well, which takes as long as compiling
};

/// What is certainly so in the file and may be what is wrong, by line; a few at most. Whatever goes wrong here means
/// only that nothing is found.
std::vector<Finding> source_findings(const CompileTask& task, const Toolchain& toolchain,
                                     const std::filesystem::path& cache_directory, Depth depth,
                                     const CompileLimits& limits = {.time = std::chrono::seconds(3)});

}  // namespace workbook
