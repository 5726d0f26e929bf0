#include "checker/messages/course_files.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

namespace workbook::messages {

std::string course_file_is_missing(const std::string& file) {
  return fmt::format("{}: the course's file is missing; build the workbook again.", file);
}

std::string course_file_is_not_usable(const std::string& file, const std::string& reason) {
  return fmt::format("{}: not usable ({}); build the workbook again.", file, reason);
}

std::string no_such_exercise(const std::string& name, const std::string& proposal) {
  if (proposal.empty()) return fmt::format("There is no exercise '{}'. `{}` shows all names.", name, command("list"));
  return fmt::format("There is no exercise '{}'. Did you mean '{}'? `{}` shows all names.", name, proposal,
                     command("list"));
}

std::string no_such_exercise_or_lecture(const std::string& name, const std::string& proposal) {
  if (proposal.empty())
    return fmt::format("There is no exercise or lecture '{}'. `{}` shows all names.", name, command("list"));
  return fmt::format("There is no exercise or lecture '{}'. Did you mean '{}'? `{}` shows all names.", name, proposal,
                     command("list"));
}

std::string card_is_missing(const std::string& file) {
  return fmt::format("{}: the card of the lecture is missing or cannot be read.", file);
}

std::string card_is_not_json(const std::string& file, std::size_t byte) {
  return fmt::format("{}: not valid JSON near byte {}.", file, byte);
}

std::string card_needs_an_object(const std::string& file, const std::string& place) {
  if (place.empty()) return fmt::format("{}: the card should be an object in braces.", file);
  return fmt::format("{}: {} should be an object in braces.", file, place);
}

std::string card_lacks(const std::string& file, const std::string& place) {
  return fmt::format("{}: {} is missing.", file, place);
}

std::string card_has_another_type(const std::string& file, const std::string& place) {
  return fmt::format("{}: {} has the wrong type.", file, place);
}

std::string card_needs_a_list(const std::string& file, const std::string& place) {
  return fmt::format("{}: {} should be a list.", file, place);
}

std::string card_needs_a_positive_number(const std::string& file, const std::string& place) {
  return fmt::format("{}: {} should be a positive number.", file, place);
}

std::string card_has_an_empty(const std::string& file, const std::string& place) {
  return fmt::format("{}: {} is empty.", file, place);
}

std::string card_names_twice(const std::string& file, const std::string& place, const std::string& name) {
  return fmt::format("{}: {}: '{}' stands on the card twice.", file, place, name);
}

std::string stub_comment() { return "TODO: write this function; the next line says that you have not started yet."; }

std::string hints_are_missing(const std::string& file) {
  return fmt::format("{}: the hints are missing; take the file from the workbook again.", file);
}

std::string no_hint_in(const std::string& file) {
  return fmt::format("{}: there is no hint in it; write three, weakest first.", file);
}

}  // namespace workbook::messages
