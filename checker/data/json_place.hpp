/// @file
/// A strict reader of JSON that knows where it is, so that every refusal can name the place.
#pragma once

#include "checker/data/value.hpp"
#include "checker/messages/reference_files.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// "exercises[2].cases[0].expected: expected a number, found string"
struct MisplacedJson : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A part of a JSON document and the way to it. Every function throws MisplacedJson where the part is not what is
/// asked.
class JsonPlace {
 public:
  /// The document must outlive the place.
  explicit JsonPlace(const nlohmann::json& document);

  [[noreturn]] void refuse(const std::string& reason) const;

  /// The part must be an object with all required keys, perhaps with the optional ones, and no others.
  void require_keys(std::initializer_list<const char*> required,
                    std::initializer_list<const char*> optional = {}) const;

  bool has(const char* key) const;
  JsonPlace at(const char* key) const;
  std::vector<JsonPlace> items() const;

  /// As items, where the length is prescribed; `what` says by what.
  std::vector<JsonPlace> items(std::size_t length, messages::OnePer what) const;

  std::string text() const;
  /// A text that names something and therefore is not empty.
  std::string name() const;
  bool truth() const;
  int integer() const;
  std::uint64_t natural_number() const;
  double finite_number() const;
  double positive_number() const;
  Value value(Kind kind) const;
  Value finite_value(Kind kind) const;

 private:
  JsonPlace(const nlohmann::json& part, std::string path);

  const nlohmann::json* part_;
  std::string path_;
};

}  // namespace workbook
