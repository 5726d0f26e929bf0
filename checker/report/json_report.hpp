/// @file
/// Verdicts as one JSON document, for programs.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace workbook {

/// The document of `check --json`; its form is described in the README.
nlohmann::ordered_json json_report(const std::vector<Checked>& results, std::uint64_t seed);

}  // namespace workbook
