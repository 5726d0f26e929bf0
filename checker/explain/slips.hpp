/// @file
/// What a file may say in C++ without meaning it. Most such places are meant so: each comes with the change that tells,
/// since it is a mistake only where all is right with the change.
#pragma once

#include "checker/explain/variants.hpp"

namespace workbook {

/// @returns of each such place the reason and the variant with the change, which carries its name and place. They are
/// about numbers (quotients, remainders), what a method belongs to or counts, values that lines or turns above have
/// changed, copies and second names, rows for columns, and the order of arguments.
std::pair<std::vector<Reason>, std::vector<Variant>> slips_of_language(const SourceText& source,
                                                                       const ExerciseReference& exercise);

}  // namespace workbook
