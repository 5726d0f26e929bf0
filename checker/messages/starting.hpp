/// @file
/// Why a program that runs beside the checker could not be started.
#pragma once

#include <string>

namespace workbook::messages {

/// A step on the way to a running program. A number and no text: it also travels from the new process to the checker.
enum class LaunchStep : int {
  open_pipe,
  open_channel,
  start_process,
  open_session,
  tie_to_checker,
  tie_to_watch,
  move_descriptors,
  place_descriptors,
  enter_directory,
  limit_core_dumps,
  limit_processor_time,
  limit_memory,
  limit_stack,
  limit_file_size,
  limit_processes,
  limit_open_files,
  limit_compiler,
  give_up_privileges,
  filter_system_calls,
  start_program,
  hear_from_process
};

/// "start the program: No such file or directory", which stands in parentheses in other sentences.
/// @param reason  as the system words it
std::string launch_failed(LaunchStep step, const std::string& reason);

/// The compiled function cannot be run. @param reason  may be launch_failed()
std::string cannot_run(const std::string& reason);

/// Without a filter of system calls nothing of the student's runs, where the kernel has one.
std::string filter_cannot_be_built();

}  // namespace workbook::messages
