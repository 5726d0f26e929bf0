/// @file
/// The reference results as a JSON document, and back.
#pragma once

#include "checker/data/json_place.hpp"
#include "checker/data/reference_results.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace workbook {

/// The document, its keys in the order in which one reads them.
nlohmann::ordered_json lecture_to_json(const LectureReference& lecture);

/// The document as text: what fits on a line stands on one line, and a list of plain numbers is never broken.
std::string readable_text(const nlohmann::ordered_json& document);

/// The inverse of lecture_to_json. @throws MisplacedJson with place and reason for anything that is missing, unknown,
/// of the wrong type or shape, or unusable as a number.
LectureReference lecture_from_json(const JsonPlace& document);

}  // namespace workbook
