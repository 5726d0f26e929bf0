#include "checker/course/card.hpp"

#include "checker/data/strict_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace workbook {

namespace {

using nlohmann::json;

/// Reads one key of an object; a missing or mistyped one is named by file and place.
class Reader {
 public:
  Reader(std::string file, std::string place, const json& object)
      : file_(std::move(file)), place_(std::move(place)), object_(object) {
    if (!object.is_object()) fail("", "should be an object in braces");
  }

  template <class T>
  T get(const std::string& key) const {
    if (!object_.contains(key)) fail(key, "is missing");
    try {
      return object_.at(key).get<T>();
    } catch (const json::exception&) {
      fail(key, "has the wrong type");
    }
  }

  const json& list(const std::string& key) const {
    if (!object_.contains(key)) fail(key, "is missing");
    if (!object_.at(key).is_array()) fail(key, "should be a list");
    return object_.at(key);
  }

  [[noreturn]] void fail(const std::string& key, const std::string& reason) const {
    const std::string separator = place_.empty() || key.empty() ? "" : ".";
    const std::string place = place_ + separator + key;
    throw CardError(fmt::format("{}: {} {}.", file_, place.empty() ? "the card" : place, reason));
  }

 private:
  std::string file_;
  std::string place_;
  const json& object_;
};

}  // namespace

Card read_card(const std::filesystem::path& lectures, const std::string& lecture) {
  const std::string file = (lectures / lecture / "card.json").string();
  std::ifstream in(file);
  if (!in) throw CardError(fmt::format("{}: the card of the lecture is missing or cannot be read.", file));
  json document;
  try {
    document = parse_strictly(std::string(std::istreambuf_iterator<char>(in), {}));
  } catch (const json::parse_error& problem) {
    throw CardError(fmt::format("{}: not valid JSON near byte {}.", file, problem.byte));
  } catch (const RepeatedKey& problem) {
    throw CardError(fmt::format("{}: {}.", file, problem.what()));
  }

  const Reader reader(file, "", document);
  Card card;
  card.lecture = lecture;
  card.title = reader.get<std::string>("title");
  card.summary = reader.get<std::string>("summary");
  card.slides = reader.get<std::vector<std::string>>("slides");
  card.builds_on = reader.get<std::vector<std::string>>("builds_on");
  card.contract = reader.get<std::string>("contract");
  card.facts = reader.get<std::vector<int>>("facts");
  std::set<std::string> names;
  for (const json& entry : reader.list("exercises")) {
    const Reader each(file, fmt::format("exercises[{}]", card.exercises.size()), entry);
    card.exercises.push_back({each.get<std::string>("name"), each.get<double>("points"), each.get<std::string>("notes"),
                              each.get<std::string>("task")});
    const CardExercise& exercise = card.exercises.back();
    if (!names.insert(exercise.name).second)
      each.fail("name", fmt::format("'{}' stands on the card twice", exercise.name));
    if (!(exercise.points > 0)) each.fail("points", "should be a positive number");
  }
  if (card.exercises.empty()) reader.fail("exercises", "is empty");
  return card;
}

}  // namespace workbook
