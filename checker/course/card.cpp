#include "checker/course/card.hpp"

#include "checker/base/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <set>

namespace workbook {

static void from_json(const nlohmann::json& part, CardExercise& exercise) {
  exercise = {part.at("name"), part.at("points"), part.at("notes"), part.at("task")};
  if (!part.contains("difficulty") && !part.contains("minutes")) return;
  part.at("difficulty").get_to(exercise.difficulty);
  part.at("minutes").get_to(exercise.minutes);
}

// The macro defines to_json as well, which nobody calls.
static void to_json(nlohmann::json& part, const CardExercise& exercise) { part = exercise.name; }
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Card, title, summary, slides, builds_on, contract, facts, exercises)

Card read_card(const std::filesystem::path& lectures, const std::string& lecture) {
  const std::filesystem::path file = lectures / lecture / "card.json";
  const auto refuse = [&](const std::string& reason) {
    throw CardError(fmt::format("{}: {}.", file.string(), reason));
  };
  const std::optional<std::string> text = read_file(file);
  if (!text) refuse("the card of the lecture is missing or cannot be read");
  Card card;
  try {
    card = nlohmann::json::parse(*text).get<Card>();
  } catch (const nlohmann::json::exception& problem) {
    const std::string reason =
        problem.what();  // "[json.exception.type_error.302] (/exercises/0/points) type must be …"
    refuse(reason.substr(reason.find(']') + 2));
  }
  card.lecture = lecture;
  std::set<std::string> names;
  for (const CardExercise& exercise : card.exercises) {
    if (!names.insert(exercise.name).second) refuse(fmt::format("the exercise '{}' is on it twice", exercise.name));
    if (!(exercise.points > 0)) refuse(fmt::format("the points of '{}' should be a positive number", exercise.name));
    if (exercise.difficulty < 0 || exercise.difficulty > 3 || (exercise.minutes > 0) != exercise.is_problem())
      refuse(fmt::format("the problem '{}' needs a difficulty from 1 to 3 and its minutes", exercise.name));
  }
  return card;
}

}  // namespace workbook
