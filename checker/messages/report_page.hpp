/// @file
/// Everything that the report page and the command that writes it say.
#pragma once

#include "checker/judging/judgement.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace workbook::messages {

/// The fixed words of the page: the name in the template, and the text.
std::vector<std::pair<std::string, std::string>> report_words();

/// "wrong value", "could not be judged".
std::string verdict_words(Verdict verdict);

std::string report_title(const std::string& student);
std::string report_date(const std::string& date, std::uint64_t seed);
std::string report_score(double points, double possible);
std::string lecture_heading(const std::string& lecture, const std::string& title);

struct VerdictCounts {
  std::size_t passed = 0;
  std::size_t to_mend = 0;
  std::size_t not_started = 0;
  std::size_t not_judged = 0;
};

std::string report_summary(const VerdictCounts& counts);

/// Our trouble is no zero: says how many points it takes out of the sum.
std::string not_judged(std::size_t exercises, double points);

/// "3 of 12 cases right, 0 of 1 points"
std::string exercise_counts(std::size_t cases_passed, std::size_t cases_total, double points, double possible,
                            bool is_judged);

/// Where to read: words that mean something on every machine.
std::string place_in_notes(const std::string& lecture, const std::string& heading);

std::string read_about(const std::string& diagnosis, const std::string& place);
std::string begin_with(const std::string& task);
std::string everything_passed();
std::string more_to_mend(std::size_t more);
std::string cut_off();

// --- the command

std::string report_folder_missing(const std::string& file, const std::string& folder);
std::string report_is_no_file(const std::string& file);
std::string report_not_written(const std::string& file, const std::string& reason);
std::string report_written(const std::string& file);
/// For authors: the template itself is at fault.
std::string report_template_damaged(const std::string& reason);
std::string report_without_pictures(const std::string& reason);

}  // namespace workbook::messages
