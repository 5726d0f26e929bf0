/// @file
/// From what a witness saw to the line and the sentence of a finding. Pure.
#pragma once

#include "checker/sandbox/call_places.hpp"
#include "checker/worker/instrumented/sighting.hpp"

#include <optional>
#include <string>
#include <vector>

namespace workbook {

using SourceLines = std::vector<std::string>;

/// The line with that number, counted from 1; "" if there is none.
std::string line_of(const SourceLines& source, int line);

/// A finding without the text of its line.
struct PlacedSentence {
  int line = 0;
  std::string sentence;

  bool operator==(const PlacedSentence&) const = default;
};

/// The innermost line of the student's file in the chain of calls; 0: none.
int student_line(const sightings::Sighting& sighting, const CallPlaces& places);

/// What can be said of one sighting; nothing where it says nothing certain, or nothing of the student's file.
std::optional<PlacedSentence> sentence_of(const sightings::Sighting& sighting, const CallPlaces& places,
                                          const SourceLines& source);

/// What can be said of several answers to the question where the call is.
std::optional<PlacedSentence> sentence_of_long_run(const std::vector<sightings::Sighting>& answers,
                                                   const CallPlaces& places, bool printing);

}  // namespace workbook
