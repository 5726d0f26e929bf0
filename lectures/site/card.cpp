#include "lectures/site/card.hpp"

#include "checker/data/json_place.hpp"
#include "lectures/site/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace workbook::site {

namespace {

std::vector<std::string> texts(const JsonPlace& list) {
  std::vector<std::string> found;
  for (const JsonPlace& item : list.items()) found.push_back(item.name());
  return found;
}

Card card_from(const std::string& folder, const JsonPlace& json) {
  Card card{.folder = folder,
            .title = json.at("title").name(),
            .summary = json.at("summary").name(),
            .slides = texts(json.at("slides")),
            .builds_on = texts(json.at("builds_on")),
            .contract = json.at("contract").name(),
            .exercises = {}};
  for (const JsonPlace& exercise : json.at("exercises").items()) {
    card.exercises.push_back({.name = exercise.at("name").name(),
                              .points = exercise.at("points").positive_number(),
                              .notes = exercise.at("notes").name()});
  }
  return card;
}

Card read_card(const std::filesystem::path& source, const std::string& folder) {
  const std::string shown = "lectures/" + folder + "/card.json";
  const std::string text = read_text(source / shown, shown);
  try {
    const nlohmann::json document = nlohmann::json::parse(text);
    return card_from(folder, JsonPlace(document));
  } catch (const nlohmann::json::parse_error& error) {
    throw std::runtime_error(fmt::format("{} is not JSON: {}", shown, error.what()));
  } catch (const MisplacedJson& error) {
    throw std::runtime_error(fmt::format("{}: {}", shown, error.what()));
  }
}

}  // namespace

std::vector<Card> read_course(const std::filesystem::path& source, const std::vector<std::string>& folders) {
  std::vector<Card> course;
  for (const std::string& folder : folders) {
    Card card = read_card(source, folder);
    for (const std::string& earlier : card.builds_on) {
      if (std::ranges::find(course, earlier, &Card::folder) == course.end()) {
        throw std::runtime_error(
            fmt::format("lectures/{}/card.json: the lecture builds on {}, which does not come before it in the course.",
                        folder, earlier));
      }
    }
    course.push_back(std::move(card));
  }
  return course;
}

}  // namespace workbook::site
