#include "checker/messages/watching.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string passed_of(std::size_t passed, std::size_t total) { return fmt::format("{} of {}", passed, total); }

std::vector<std::string> keys() {
  return {"h hint", "l list", "p plot", "n next", "b back", "c compiler", "r again", "q quit"};
}

std::string no_keyboard() { return "Ctrl-C ends the watch."; }

std::string part_shown(std::size_t first, std::size_t last, std::size_t total) {
  const bool more_below = last < total;
  return fmt::format("Lines {}–{} of {}: {}", first, last, total,
                     more_below ? "space or ↓ shows more" : "↑ goes back up");
}

std::string unknown_key(const std::string& key) {
  return key.empty() ? "That key does nothing; these do:" : fmt::format("The key “{}” does nothing; these do:", key);
}

std::string waiting(const std::string& exercise) { return fmt::format("Waiting for a save of {}.", exercise); }

std::string checking(const std::string& exercise, long seconds) {
  return seconds < 1 ? fmt::format("checking {} …", exercise) : fmt::format("checking {} … {} s", exercise, seconds);
}

std::string working_for(const std::string& exercise, long seconds) {
  return seconds < 1 ? fmt::format("working for {} …", exercise)
                     : fmt::format("working for {} … {} s", exercise, seconds);
}

std::string label_of_exercise(bool passed) { return passed ? "Passed" : "Next"; }

std::string all_pass(const std::string& scope, std::size_t total) {
  if (scope.empty())
    return fmt::format("All {} exercises of the course pass. Whatever you save is still checked.", total);
  return fmt::format("All {} exercises of {} pass. Whatever you save is still checked; n goes on in the course.", total,
                     scope);
}

std::string passes_already(const std::string& exercise) { return fmt::format("{} passes. n goes on.", exercise); }

std::string first_of_the_course() { return "This is the first exercise of the course."; }

std::string last_one_left(const std::string& exercise) {
  return fmt::format("All others pass: {} is the last one.", exercise);
}

std::string check_died(const std::string& exercise, int signal) {
  return fmt::format(
      "The check of {} ended unexpectedly (signal {}); this is not your mistake. The key r checks again.", exercise,
      signal);
}

std::string command_died(int signal) {
  return fmt::format("That ended unexpectedly (signal {}); this is not your mistake. Press the key again.", signal);
}

std::string check_cannot_start(const std::string& exercise, const std::string& reason) {
  return fmt::format(
      "The check of {} could not be started ({}); this is not your mistake. End other programs, then press r.",
      exercise, reason);
}

std::string command_cannot_start(const std::string& reason) {
  return fmt::format(
      "That could not be started ({}); this is not your mistake. End other programs, then press the key again.",
      reason);
}

std::string cannot_listen_to_signals() { return "The watch cannot listen to signals"; }

std::string no_events(const std::string& reason) {
  return fmt::format("The system sends no news of files here ({}), so the files are looked at four times a second.",
                     reason);
}

std::string polling_wanted() { return "WORKBOOK_POLL is set, so the files are looked at four times a second."; }

std::string folder_gone(const std::string& folder) {
  return fmt::format("The folder {} is gone. Put it back and watching goes on.", folder);
}

std::string folder_back(const std::string& folder) { return fmt::format("The folder {} is back.", folder); }

std::string more_verdicts(std::size_t count) { return fmt::format("… and {} more before; l lists all.", count); }

std::string goodbye(std::size_t passed, std::size_t total, const std::string& next) {
  if (next.empty()) return fmt::format("All {} exercises pass.", total);
  return fmt::format("{} of {} exercises pass; next is {}.", passed, total, next);
}

std::string nothing_to_watch() { return "This course has no exercises, so there is nothing to watch."; }

}  // namespace workbook::messages
