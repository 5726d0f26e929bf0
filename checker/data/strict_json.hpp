/// @file
/// JSON for files that people write: a key that stands twice in one object is noticed. The library alone would keep the
/// last one and say nothing.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <stdexcept>
#include <string_view>

namespace workbook {

/// "exercises[2].cases[0]: the key “scale” stands here twice"
struct RepeatedKey : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The document in a text.
/// @throws RepeatedKey at the first key that its object already has.
/// @throws nlohmann::json::exception for all that is not JSON.
nlohmann::json parse_strictly(std::string_view text);

}  // namespace workbook
