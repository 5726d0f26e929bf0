/// @file
/// A wrong value explained by trying: with which small change would the file be right at every case?
#pragma once

#include "checker/compile/toolchain.hpp"
#include "checker/sandbox/diagnostic_run.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace workbook {

/// The finding about the code that is the whole reason: with it fixed, all cases are right.
std::optional<Finding> decisive_finding(const DiagnosticTask& task, const std::vector<Finding>& findings,
                                        const Toolchain& toolchain, const std::filesystem::path& cache);

/// The one token with which all cases are right: its place and its kind, not the answer.
std::optional<Finding> slip_of_one_token(const DiagnosticTask& task, const Toolchain& toolchain,
                                         const std::filesystem::path& cache);

}  // namespace workbook
