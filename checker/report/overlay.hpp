/// @file
/// The plot: the student's curve on the reference results, and the difference below.
#pragma once

#include "checker/pipeline/check_exercise.hpp"
#include "checker/sandbox/run_exercise.hpp"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace workbook {

/// No picture came about; one sentence says why and what to do.
struct PlotError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// All curves of one exercise. Where the student's function gave no value, there is NaN.
struct Overlay {
  const Sweep* sweep = nullptr;
  std::vector<Value> student;  ///< empty: only the reference is drawn
  std::string misconception;   ///< name of the recognised misconception; empty: none
  const std::vector<Value>* misconception_outputs = nullptr;
  bool magnitudes = false;  ///< compare |component|, where the sign of the result is free
};

/// Runs the student's function along the sweep. @throws LaunchError or SandboxError if the worker cannot be started.
Overlay overlay_of(const Checked& checked);

/// Where the plots of students lie, if nobody asks for another place.
std::filesystem::path plots_directory(const Course& course);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png. Returns both paths.
/// @throws PlotError if gnuplot is missing, the folder cannot be written, or gnuplot leaves no picture behind.
std::vector<std::filesystem::path> draw_overlay(const Overlay& overlay, const std::filesystem::path& directory,
                                                const std::string& name);

/// The picture as the text of an SVG file of 640 by 512 pixels, for a page; `directory` is for files on the way there.
/// @throws PlotError
std::string overlay_as_svg(const Overlay& overlay, const std::filesystem::path& directory, const std::string& name);

}  // namespace workbook
