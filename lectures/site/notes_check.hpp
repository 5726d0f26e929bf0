/// @file
/// What Doxygen does not notice about the page of a lecture.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace workbook::site {

/// Sentences about a lecture's notes: figures that nobody draws, figures without alternative text or caption, formulas
/// in straight quotes, and parts of the page that are derived from the card and missing. Empty when all is well.
/// @param folder   of the lecture, "03_inertia_tensor"
/// @param notes    text of its notes.md
/// @param figures  folder into which the figures were drawn, a folder per lecture
std::vector<std::string> faults_of_notes(const std::string& folder, const std::string& notes,
                                         const std::filesystem::path& figures);

}  // namespace workbook::site
