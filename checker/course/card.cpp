#include "checker/course/card.hpp"

#include "checker/data/strict_json.hpp"
#include "checker/messages/course_files.hpp"

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
    if (!object.is_object()) throw CardError(messages::card_needs_an_object(file_, place_));
  }

  template <class T>
  T get(const std::string& key) const {
    if (!object_.contains(key)) throw CardError(messages::card_lacks(file_, place(key)));
    try {
      return object_.at(key).get<T>();
    } catch (const json::exception&) {
      throw CardError(messages::card_has_another_type(file_, place(key)));
    }
  }

  const json& list(const std::string& key) const {
    if (!object_.contains(key)) throw CardError(messages::card_lacks(file_, place(key)));
    if (!object_.at(key).is_array()) throw CardError(messages::card_needs_a_list(file_, place(key)));
    return object_.at(key);
  }

  /// The way to a key: "exercises[0].points".
  std::string place(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }

 private:
  std::string file_;
  std::string place_;
  const json& object_;
};

}  // namespace

Card read_card(const std::filesystem::path& lectures, const std::string& lecture) {
  const std::string file = (lectures / lecture / "card.json").string();
  std::ifstream in(file);
  if (!in) throw CardError(messages::card_is_missing(file));
  json document;
  try {
    document = parse_strictly(std::string(std::istreambuf_iterator<char>(in), {}));
  } catch (const json::parse_error& problem) {
    throw CardError(messages::card_is_not_json(file, problem.byte));
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
      throw CardError(messages::card_names_twice(file, each.place("name"), exercise.name));
    if (!(exercise.points > 0)) throw CardError(messages::card_needs_a_positive_number(file, each.place("points")));
  }
  if (card.exercises.empty()) throw CardError(messages::card_has_an_empty(file, "exercises"));
  return card;
}

}  // namespace workbook
