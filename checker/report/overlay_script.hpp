/// @file
/// What gnuplot is told to draw an overlay.
#pragma once

#include "checker/report/overlay.hpp"

#include <gnuplot-iostream.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace workbook {

/// Starts gnuplot with a terminal of the given name and options, and lets `script` draw into the file.
/// @throws PlotError if gnuplot is missing, or has not drawn all of it.
void draw_picture(const std::string& terminal, const std::filesystem::path& file,
                  const std::function<void(gnuplotio::Gnuplot&)>& script);

/// As draw_picture(), but what the file would hold; it lies in `directory` for a moment only.
std::string drawn_picture(const std::string& terminal, const std::filesystem::path& directory,
                          const std::function<void(gnuplotio::Gnuplot&)>& script);

/// Above the curves, below their difference.
void send_panels(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay);

/// How the curves are told apart where they are made of letters.
inline constexpr char student_letters[] = "ABCDEFGHI";
inline constexpr char reference_letters[] = ".:+";
inline constexpr char misconception_letter = '~';

/// The curves alone, made of letters, for a drawing of that many columns.
void send_letters(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay, std::size_t columns);

/// "E", or "|E|" where the sign is free.
std::string component_label(const Overlay& overlay, const PlotComponent& component);

}  // namespace workbook
