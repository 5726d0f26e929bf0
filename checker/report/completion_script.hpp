/// @file
/// What lets bash complete the checker's command line.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace workbook {

/// A script for bash to source. Commands and options are read off the command line's own description, so that they
/// cannot differ from it; what a value or an argument may be follows from its type: EXERCISE, LECTURE, NAME (either),
/// FILE or FOLDER.
std::string completion_script(const CLI::App& app, const std::vector<std::string>& exercises,
                              const std::vector<std::string>& lectures);

}  // namespace workbook
