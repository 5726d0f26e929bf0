/// @file
/// What the pages of the site need of a lecture's card.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace workbook::site {

struct Exercise {
  std::string name;
  double points = 0;
  std::string notes;  ///< anchor of the paragraph that teaches it
};

/// lectures/FOLDER/card.json.
struct Card {
  std::string folder;  ///< "03_inertia_tensor"
  std::string title;
  std::string summary;
  std::vector<std::string> slides;
  std::vector<std::string> builds_on;  ///< folders of other lectures
  std::string contract;                ///< its header is include/rigid/CONTRACT.hpp
  std::vector<Exercise> exercises;
};

/// The cards of the course in its order, from SOURCE/lectures/FOLDER/card.json.
/// @throws std::runtime_error with file, place and reason when a card cannot be read, or when a lecture builds on one
///         that does not come before it in the course.
std::vector<Card> read_course(const std::filesystem::path& source, const std::vector<std::string>& folders);

}  // namespace workbook::site
