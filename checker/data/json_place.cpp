#include "checker/data/json_place.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace workbook {

JsonPlace::JsonPlace(const nlohmann::json& document) : part_(&document) {}

JsonPlace::JsonPlace(const nlohmann::json& part, std::string path) : part_(&part), path_(std::move(path)) {}

void JsonPlace::refuse(const std::string& reason) const {
  throw MisplacedJson(fmt::format("{}: {}", path_.empty() ? "top level" : path_, reason));
}

void JsonPlace::require_keys(std::initializer_list<const char*> required,
                             std::initializer_list<const char*> optional) const {
  if (!part_->is_object()) refuse(fmt::format("expected an object, found {}", part_->type_name()));
  for (const char* key : required) {
    if (!has(key)) refuse(fmt::format("the key “{}” is missing", key));
  }
  for (const auto& [key, unused] : part_->items()) {
    const auto is_key = [&key = key](const char* known) { return key == known; };
    if (!std::ranges::any_of(required, is_key) && !std::ranges::any_of(optional, is_key)) {
      refuse(fmt::format("the key “{}” is unknown", key));
    }
  }
}

bool JsonPlace::has(const char* key) const { return part_->is_object() && part_->contains(key); }

JsonPlace JsonPlace::at(const char* key) const {
  if (!has(key)) refuse(fmt::format("the key “{}” is missing", key));
  return {part_->at(key), path_.empty() ? key : path_ + "." + key};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!part_->is_array()) refuse(fmt::format("expected a list, found {}", part_->type_name()));
  std::vector<JsonPlace> places;
  for (const nlohmann::json& item : *part_) places.push_back({item, fmt::format("{}[{}]", path_, places.size())});
  return places;
}

std::vector<JsonPlace> JsonPlace::items(std::size_t length, const char* what) const {
  std::vector<JsonPlace> places = items();
  if (places.size() != length) refuse(fmt::format("expected {} items ({}), found {}", length, what, places.size()));
  return places;
}

std::string JsonPlace::text() const {
  if (!part_->is_string()) refuse(fmt::format("expected a string, found {}", part_->type_name()));
  return part_->get<std::string>();
}

std::string JsonPlace::name() const {
  std::string text_here = text();
  if (text_here.empty()) refuse("must not be empty");
  return text_here;
}

bool JsonPlace::truth() const {
  if (!part_->is_boolean()) refuse(fmt::format("expected true or false, found {}", part_->type_name()));
  return part_->get<bool>();
}

int JsonPlace::integer() const {
  const double number = finite_number();
  if (number != std::trunc(number) || std::abs(number) > std::numeric_limits<int>::max()) {
    refuse(fmt::format("expected a whole number, found {}", part_->dump()));
  }
  return static_cast<int>(number);
}

std::uint64_t JsonPlace::natural_number() const {
  if (!part_->is_number_unsigned()) refuse(fmt::format("expected a natural number, found {}", part_->dump()));
  return part_->get<std::uint64_t>();
}

double JsonPlace::finite_number() const { return finite_value(Kind::number).numbers.front(); }

double JsonPlace::positive_number() const {
  const double number = finite_number();
  if (!(number > 0)) refuse(fmt::format("expected a positive number, found {}", number));
  return number;
}

Value JsonPlace::value(Kind kind) const {
  try {
    return value_from_json(*part_, kind);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
}

Value JsonPlace::finite_value(Kind kind) const {
  Value value_here = value(kind);
  if (!is_finite(value_here)) refuse("every number here must be finite, found null");
  return value_here;
}

}  // namespace workbook
