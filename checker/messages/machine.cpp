#include "checker/messages/machine.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string good_mark() { return "good: "; }
std::string bad_mark() { return "not good: "; }

std::string about_compiler() { return "compiler"; }
std::string about_reference() { return "reference"; }
std::string about_sandbox() { return "sandbox"; }
std::string about_gnuplot() { return "gnuplot"; }
std::string about_folder() { return "folder"; }
std::string about_notes() { return "notes"; }
std::string about_terminal() { return "terminal"; }

std::string results_are_there(std::size_t lectures, std::size_t exercises) {
  return fmt::format("results of {} {}, {} {}", lectures, lectures == 1 ? "lecture" : "lectures", exercises,
                     exercises == 1 ? "exercise" : "exercises");
}

std::string sandbox_is_whole() {
  return "Students' functions run behind a filter of system calls, with limits on time, memory and output.";
}

std::string kernel_has_no_filter() {
  return "This kernel has no filter of system calls: students' functions run with limits on time, memory and output "
         "only.";
}

std::string built_without_filter() {
  return "The checker was built without libseccomp: students' functions run with limits on time, memory and output "
         "only.";
}

std::string gnuplot_is_missing() {
  return "missing: checks work, plots do not (on Debian: apt-get install gnuplot-nox)";
}

std::string folder_is_writable(const std::string& folder) { return fmt::format("{} is writable", folder); }

std::string folder_is_not_writable(const std::string& folder) {
  return fmt::format("{} is not writable: progress and resets cannot be saved", folder);
}

std::string notes_are_not_built() {
  return "not built as pages; read lectures/*/notes.md, or build the target `notes`";
}

std::string terminal_is(std::size_t columns, bool has_color) {
  return has_color ? fmt::format("{} columns, colour", columns) : fmt::format("{} columns, no colour", columns);
}

std::string disk_may_be_full() { return "is the disk full?"; }

}  // namespace workbook::messages
