#include "checker/messages/report_page.hpp"

#include "checker/messages/reporting.hpp"

#include <fmt/format.h>

namespace workbook::messages {

namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace

std::vector<std::pair<std::string, std::string>> report_words() {
  return {{"language", "en"},
          {"workbook", "Rigid Body Workbook"},
          {"next_heading", "What to do next"},
          {"contents", "All exercises"},
          {"why", "Why:"},
          {"read", "Read:"},
          {"next", "Next:"},
          {"failure", "The first case that did not pass"},
          {"printed", "What the code printed"},
          {"compiler", "What the compiler printed"},
          {"picture", "The plot"},
          {"source", "The submitted file"},
          {"not_started", "Not started yet"},
          {"footer",
           "Written by the checker of the workbook. Only values that it compared itself earn points; a diagnosis helps "
           "and is never a grade."}};
}

std::string verdict_words(Verdict verdict) {
  return verdict == Verdict::checker_error ? "could not be judged" : in_words(verdict);
}

std::string report_title(const std::string& student) {
  return student.empty() ? "Report on the exercises" : fmt::format("Report for {}", student);
}

std::string report_date(const std::string& date, std::uint64_t seed) {
  return fmt::format("Checked on {}, with the cases of seed {}.", date, seed);
}

std::string report_score(double points, double possible) {
  return fmt::format("{:g} of {:g} point{}", points, possible, possible == 1 ? "" : "s");
}

std::string lecture_heading(const std::string& lecture, const std::string& title) {
  return fmt::format("{}  {}", lecture.substr(0, lecture.find('_')), title);
}

std::string report_summary(const VerdictCounts& counts) {
  const std::size_t all = counts.passed + counts.to_mend + counts.not_started + counts.not_judged;
  std::string text = fmt::format("{} of {} passed", counts.passed, counted(all, "exercise"));
  if (counts.to_mend > 0) text += fmt::format(", {} to mend", counts.to_mend);
  if (counts.not_started > 0) text += fmt::format(", {} not started", counts.not_started);
  if (counts.not_judged > 0) text += fmt::format(", {} could not be judged", counts.not_judged);
  return text + ".";
}

std::string not_judged(std::size_t exercises, double points) {
  return fmt::format(
      "{} could not be judged because the checker itself was in trouble. That is no fault of the submission: their "
      "{:g} "
      "point{} count neither way.",
      counted(exercises, "exercise"), points, points == 1 ? "" : "s");
}

std::string exercise_counts(std::size_t cases_passed, std::size_t cases_total, double points, double possible,
                            bool is_judged) {
  if (!is_judged) return "Our fault: this exercise counts neither way.";
  const std::string score = report_score(points, possible);
  return cases_total == 0 ? score : fmt::format("{} of {} cases right, {}", cases_passed, cases_total, score);
}

std::string place_in_notes(const std::string& lecture, const std::string& heading) {
  const std::string notes = fmt::format("lectures/{}/notes.md", lecture);
  return heading.empty() ? notes : fmt::format("{}, “{}”", notes, heading);
}

std::string read_about(const std::string& diagnosis, const std::string& place) {
  return fmt::format("{} Read {}.", diagnosis, place);
}

std::string begin_with(const std::string& task) { return fmt::format("Begin with it. {}", task); }

std::string everything_passed() { return "Everything on this page passes; nothing is left to do here."; }

std::string more_to_mend(std::size_t more) {
  return fmt::format("Then the other {} below that did not pass.", counted(more, "exercise"));
}

std::string cut_off() { return "… (the rest is too long to be shown here)"; }

std::string report_folder_missing(const std::string& file, const std::string& folder) {
  return fmt::format("{} cannot be written, because there is no folder {}; make it first, or choose another place.",
                     file, folder);
}

std::string report_is_no_file(const std::string& file) {
  return fmt::format("{} is no ordinary file, and the page cannot take its place; give --html the name of a file.",
                     file);
}

std::string report_not_written(const std::string& file, const std::string& reason) {
  return fmt::format("{} could not be written ({}); choose a folder that you may write to, or free some space.", file,
                     reason);
}

std::string report_written(const std::string& file) { return fmt::format("The page is in {}.", file); }

std::string report_template_damaged(const std::string& reason) {
  return fmt::format("checker/report/report_page.html is no template: {}.", reason);
}

std::string report_without_pictures(const std::string& reason) {
  return fmt::format("This page has no plots: {}", reason);
}

}  // namespace workbook::messages
