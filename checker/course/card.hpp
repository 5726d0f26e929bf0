/// @file
/// The card of a lecture: the one place that lists its exercises.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// The names are the keys of card.json, here and below.
struct CardExercise {
  std::string name;
  double points = 1.0;
  std::string notes;   ///< anchor of its paragraph
  std::string task;    ///< what to write, in a line or two: the comment at the head of the stub
  int difficulty = 0;  ///< of a problem, 1 to 3: its statement gives the physics, the formula is to be found; else 0
  int minutes = 0;     ///< that a problem takes about; else 0

  bool is_problem() const { return difficulty > 0; }
};

struct Card {
  std::string lecture;  ///< the folder's name, "03_inertia_tensor"; not on the card
  std::string title;
  std::string summary;
  std::vector<std::string> slides;
  std::vector<std::string> builds_on;
  std::string contract;    ///< header without folder and ending, "inertia_tensor"
  std::vector<int> facts;  ///< numbers of the facts of the slides that it teaches
  std::vector<CardExercise> exercises;
};

/// The card cannot be used: file, place and reason in one sentence.
struct CardError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads LECTURES/LECTURE/card.json. @throws CardError if it is missing, malformed, or a part has the wrong type.
Card read_card(const std::filesystem::path& lectures, const std::string& lecture);

}  // namespace workbook
