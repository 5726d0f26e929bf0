/// @file
/// Figures of the notes: one gnuplot script, drawn as SVG for the pages and as PNG for everything else.
#pragma once

#include <gnuplot-iostream.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

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

/// One figure of a lecture by its name, and how to draw it into a folder.
struct Figure {
  std::string name;
  std::function<void(const std::filesystem::path& directory)> draw;
};

/// How a program of figures ends.
enum FigureStatus { figures_drawn = 0, figure_failed = 1, figure_wrong_usage = 2, figure_not_started = 3 };

/// The main program of a lecture's figures: `PROGRAM DIRECTORY` draws all, `PROGRAM DIRECTORY NAME` draws one, `PROGRAM
/// --list` prints the names. Each figure is tried on its own; the last line says "NAME: why" of one that failed.
/// @return a FigureStatus; figure_not_started if nothing worse happened than that a function is not written yet
int draw_figures(int argc, char** argv, const std::vector<Figure>& figures);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png: `draw` sends everything after the terminal's settings, and is
/// called once per format.
/// @throws std::runtime_error if gnuplot is missing or finds an error in the script.
void draw_figure(const std::filesystem::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw);

}  // namespace workbook
