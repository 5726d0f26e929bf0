/// @file
/// What `--help` says.
#pragma once

#include <string>

namespace workbook::messages {

/// The help of one command.
struct CommandHelp {
  std::string description;  ///< its first line stands in the list of commands
  std::string examples;     ///< what to type, line by line, without the program's name; may be empty
};

std::string program_description();

/// Environment, files and exit status.
std::string program_footer();

/// The help of a command by its name. @throws std::out_of_range for a command without help
const CommandHelp& help_of(const std::string& command);

/// "Examples:" and the examples as they are typed.
std::string examples_of(const CommandHelp& help);

/// The heading above a command's arguments, and what stands for any command.
std::string arguments_heading();
std::string command_placeholder();

/// What an option or an argument means, by its name. @throws std::out_of_range for one without help
const std::string& option_help(const std::string& option);

std::string for_students();
std::string for_instructors();
std::string for_authors();
std::string for_tests();

}  // namespace workbook::messages
