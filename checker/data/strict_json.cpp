#include "checker/data/strict_json.hpp"

#include "checker/messages/reference_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace workbook {

namespace {

using nlohmann::json;

/// Follows the parser on its way through a document, and knows which keys each open object has.
class Way {
 public:
  /// @throws RepeatedKey
  void step(json::parse_event_t event, const json& parsed) {
    switch (event) {
      case json::parse_event_t::object_start:
      case json::parse_event_t::array_start:
        open_.emplace_back();
        break;
      case json::parse_event_t::key:
        enter(parsed.get<std::string>());
        break;
      case json::parse_event_t::object_end:
      case json::parse_event_t::array_end:
        open_.pop_back();
        leave_value();
        break;
      case json::parse_event_t::value:
        leave_value();
        break;
    }
  }

 private:
  /// An object or a list that has begun and not ended.
  struct Open {
    std::set<std::string> keys;   ///< none in a list
    std::string key;              ///< of the value that is being read; empty in a list
    std::size_t values_read = 0;  ///< in a list, the number of the value that is being read
  };

  void enter(const std::string& key) {
    if (!open_.back().keys.insert(key).second) {
      throw RepeatedKey(messages::key_stands_twice(place(), key));
    }
    open_.back().key = key;
  }

  void leave_value() {
    if (!open_.empty()) ++open_.back().values_read;
  }

  /// The way to the innermost open object: what lies around it says where it is.
  std::string place() const {
    std::string way;
    for (auto around = open_.begin(); around != std::prev(open_.end()); ++around) {
      if (around->keys.empty()) {
        way += fmt::format("[{}]", around->values_read);
      } else {
        way += way.empty() ? around->key : "." + around->key;
      }
    }
    return way.empty() ? messages::top_level() : way;
  }

  std::vector<Open> open_;
};

}  // namespace

json parse_strictly(std::string_view text) {
  Way way;
  return json::parse(text, [&way](int, json::parse_event_t event, const json& parsed) {
    way.step(event, parsed);
    return true;
  });
}

}  // namespace workbook
