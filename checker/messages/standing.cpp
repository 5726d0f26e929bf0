#include "checker/messages/standing.hpp"

#include "checker/messages/program.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace workbook::messages {

std::string standing(std::size_t passed, std::size_t total, double points, double all_points) {
  return fmt::format("{} of {} exercises pass, {} of {} points.", passed, total, points, all_points);
}

std::string of(std::size_t done, std::size_t total) { return fmt::format("{} of {}", done, total); }

std::string passed() { return "passed"; }

std::string changed_since_it_passed() { return "changed since it passed"; }

std::string not_started() { return "not started"; }

std::string verdict_in_words(std::string verdict) {
  std::replace(verdict.begin(), verdict.end(), '_', ' ');
  return verdict;
}

std::string points(double points) { return points == 1 ? "1 point" : fmt::format("{} points", points); }

std::string next_exercise() { return "Next"; }

std::string file_row() { return "file"; }
std::string notes_row() { return "notes"; }
std::string state_row() { return "state"; }
std::string check_row() { return "check"; }
std::string hint_row() { return "hint"; }
std::string watch_row() { return "watch"; }

std::string everything_passes(std::size_t total) {
  return fmt::format(
      "All {} exercises pass. You have written the library; `{}` runs the worked examples of a lecture on it, `{}` "
      "draws its figures.",
      total, command("examples 03"), command("figures 03"));
}

}  // namespace workbook::messages
