/// @file
/// Figures of the notes: one gnuplot script, drawn as SVG for the pages and as PNG for everything else.
#pragma once

#include <gnuplot-iostream.h>

#include <filesystem>
#include <functional>
#include <string>

namespace workbook {

/// Colours that the colour-blind tell apart (Okabe and Ito 2008), also by lightness in print.
namespace colors {
inline constexpr const char* black = "#000000";
inline constexpr const char* blue = "#0072B2";
inline constexpr const char* orange = "#E69F00";
inline constexpr const char* green = "#009E73";
inline constexpr const char* vermilion = "#D55E00";
inline constexpr const char* sky = "#56B4E9";
inline constexpr const char* purple = "#CC79A7";
inline constexpr const char* grey = "#7F7F7F";
}  // namespace colors

/// Size of a figure on the page, in pixels.
struct FigureSize {
  int width = 720;
  int height = 440;
};

/// The folder of the lecture's figures, from the program's one argument; explains itself and exits with 2 without it.
std::filesystem::path figure_directory(int argc, char** argv);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png: `draw` sends everything after the terminal's settings, and is
/// called once per format.
/// @throws std::runtime_error if gnuplot is missing or leaves no picture behind.
void draw_figure(const std::filesystem::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw);

}  // namespace workbook
