/// @file
/// The plot: the student's curve on the reference results, and the difference below.
#pragma once

#include "checker/pipeline/check_exercise.hpp"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// There is no picture; one sentence says why and what to do.
struct PlotError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr const char* gnuplot_is_missing =
    "gnuplot is not installed (on Debian: apt-get install gnuplot-nox), so there are no plots and figures; everything "
    "else works without it.";

/// One curve per component of the result. Where there is no value, there is NaN.
struct Overlay {
  using Curves = std::vector<std::vector<double>>;

  const Sweep* sweep = nullptr;
  std::vector<std::string> labels;  ///< of the components: "E", or "|E|" where the sign is free
  Curves reference;
  Curves student;                  ///< empty: no value at all
  Curves misconception;            ///< empty: none is recognised
  std::string misconception_name;  ///< "no half"
  /// The smallest step that no line may join: an angle that starts again at −π, a whole number that changes.
  double jump = std::numeric_limits<double>::infinity();
  bool has_whole_numbers = false;
  bool has_turns = false;  ///< angles that differ by full turns are one attitude
};

/// Runs the student's function along the sweep.
/// @throws PlotError if there is no sweep, LaunchError or SandboxError if the worker cannot be started
Overlay overlay_of(const CheckResult& checked);

/// Where plots lie unless another place is asked for.
std::filesystem::path plots_directory(const Course& course);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png. Returns both paths.
/// @throws PlotError if gnuplot is missing, the folder cannot be written, or gnuplot fails
std::vector<std::filesystem::path> draw_overlay(const Overlay& overlay, const std::filesystem::path& directory,
                                                const std::string& name);

/// What gnuplot draws on a terminal of the given name and options: the curves, and below them the difference.
/// @param directory  for files on the way
/// @throws PlotError
std::string drawn_overlay(const Overlay& overlay, const std::string& terminal, const std::filesystem::path& directory);

/// The curves alone, made of letters on such a terminal, and what the letters mean.
std::string drawn_letters(const Overlay& overlay, const std::string& terminal, std::size_t columns,
                          const std::filesystem::path& directory);
std::string meaning_of_letters(const Overlay& overlay);

}  // namespace workbook
