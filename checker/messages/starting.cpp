#include "checker/messages/starting.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string in_words(LaunchStep step) {
  switch (step) {
    case LaunchStep::open_pipe:
      return "open a pipe";
    case LaunchStep::open_channel:
      return "open a channel";
    case LaunchStep::start_process:
      return "start a process";
    case LaunchStep::open_session:
      return "open its own session";
    case LaunchStep::tie_to_checker:
      return "tie its life to the checker";
    case LaunchStep::tie_to_watch:
      return "tie its life to the watch";
    case LaunchStep::move_descriptors:
      return "move its descriptors";
    case LaunchStep::place_descriptors:
      return "place its descriptors";
    case LaunchStep::enter_directory:
      return "enter its directory";
    case LaunchStep::limit_core_dumps:
      return "limit core dumps";
    case LaunchStep::limit_processor_time:
      return "limit its processor time";
    case LaunchStep::limit_memory:
      return "limit its memory";
    case LaunchStep::limit_stack:
      return "limit its stack";
    case LaunchStep::limit_file_size:
      return "limit the size of its files";
    case LaunchStep::limit_processes:
      return "limit its processes";
    case LaunchStep::limit_open_files:
      return "limit its open files";
    case LaunchStep::limit_compiler:
      return "limit the compiler";
    case LaunchStep::give_up_privileges:
      return "give up privileges";
    case LaunchStep::filter_system_calls:
      return "filter its system calls";
    case LaunchStep::start_program:
      return "start the program";
    case LaunchStep::hear_from_process:
      return "hear from the new process";
  }
  return "start";
}

}  // namespace

std::string launch_failed(LaunchStep step, const std::string& reason) {
  return fmt::format("{}: {}", in_words(step), reason);
}

std::string cannot_run(const std::string& reason) {
  return fmt::format("The checker could not run the compiled function ({}); this is not your mistake.", reason);
}

std::string filter_cannot_be_built() { return "the filter of system calls cannot be built on this machine"; }

}  // namespace workbook::messages
