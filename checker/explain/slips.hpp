/// @file
/// What a file may say in C++ without meaning it. Most such places are meant so: each comes with the change that tells,
/// since it is a mistake only where all is right with the change.
#pragma once

#include "checker/explain/variants.hpp"

namespace workbook {

/// @returns of each such place the reason and the variant with the change, which carries its name and place: quotients
/// of whole numbers that have names, factors behind a quotient, methods that take too little, rows for columns, values
/// that the line above has changed, sums that go on from turn to turn, fmod of what may be negative, sizes for ends
std::pair<std::vector<Reason>, std::vector<Variant>> slips_of_language(const SourceText& source,
                                                                       const ExerciseReference& exercise);

}  // namespace workbook
