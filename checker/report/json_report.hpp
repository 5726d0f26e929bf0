/// @file
/// Verdicts as one JSON document, for programs.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace workbook {

/// The document of `check --json`; its form is described in the README.
std::string json_report(const std::vector<CheckResult>& results, std::uint64_t seed);

}  // namespace workbook
