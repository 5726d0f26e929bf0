#include "checker/data/json_place.hpp"

#include "checker/messages/reference_files.hpp"

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
  throw MisplacedJson(fmt::format("{}: {}", path_.empty() ? messages::top_level() : path_, reason));
}

void JsonPlace::require_keys(std::initializer_list<const char*> required,
                             std::initializer_list<const char*> optional) const {
  if (!part_->is_object()) refuse(messages::expected_object(part_->type_name()));
  for (const char* key : required) {
    if (!has(key)) refuse(messages::key_is_missing(key));
  }
  for (const auto& [key, unused] : part_->items()) {
    const auto is_key = [&key = key](const char* known) { return key == known; };
    if (!std::ranges::any_of(required, is_key) && !std::ranges::any_of(optional, is_key)) {
      refuse(messages::key_is_unknown(key));
    }
  }
}

bool JsonPlace::has(const char* key) const { return part_->is_object() && part_->contains(key); }

JsonPlace JsonPlace::at(const char* key) const {
  if (!has(key)) refuse(messages::key_is_missing(key));
  return {part_->at(key), path_.empty() ? key : path_ + "." + key};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!part_->is_array()) refuse(messages::expected_list(part_->type_name()));
  std::vector<JsonPlace> places;
  for (const nlohmann::json& item : *part_) places.push_back({item, fmt::format("{}[{}]", path_, places.size())});
  return places;
}

std::vector<JsonPlace> JsonPlace::items(std::size_t length, messages::OnePer what) const {
  std::vector<JsonPlace> places = items();
  if (places.size() != length) refuse(messages::expected_items(length, what, places.size()));
  return places;
}

std::string JsonPlace::text() const {
  if (!part_->is_string()) refuse(messages::expected_string(part_->type_name()));
  return part_->get<std::string>();
}

std::string JsonPlace::name() const {
  std::string text_here = text();
  if (text_here.empty()) refuse(messages::must_not_be_empty());
  return text_here;
}

bool JsonPlace::truth() const {
  if (!part_->is_boolean()) refuse(messages::expected_truth(part_->type_name()));
  return part_->get<bool>();
}

int JsonPlace::integer() const {
  const double number = finite_number();
  if (number != std::trunc(number) || std::abs(number) > std::numeric_limits<int>::max()) {
    refuse(messages::expected_whole_number(part_->dump()));
  }
  return static_cast<int>(number);
}

std::uint64_t JsonPlace::natural_number() const {
  if (!part_->is_number_unsigned()) refuse(messages::expected_natural_number(part_->dump()));
  return part_->get<std::uint64_t>();
}

double JsonPlace::finite_number() const { return finite_value(Kind::number).numbers.front(); }

double JsonPlace::positive_number() const {
  const double number = finite_number();
  if (!(number > 0)) refuse(messages::expected_positive_number(number));
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
  if (!is_finite(value_here)) refuse(messages::must_be_finite());
  return value_here;
}

}  // namespace workbook
