/// @file
/// Figures of the notes: one gnuplot script, drawn as SVG for the pages, which follows light and dark, and as PNG in
/// the same size and colours for everything else.
#pragma once

#include <gnuplot-iostream.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace workbook {

/// Colours that the colour-blind tell apart. Each has a counterpart for dark pages in site/style.css. Text may have all
/// but pale and sky, which are too light to read.
namespace colors {
inline constexpr const char* black = "#222222";
inline constexpr const char* grey = "#5F6B73";
inline constexpr const char* shade = "#EEF1F3";
inline constexpr const char* pale = "#CFD8DD";
inline constexpr const char* blue = "#0068A8";
inline constexpr const char* vermilion = "#B84300";
inline constexpr const char* green = "#00734F";
inline constexpr const char* purple = "#A3427F";
inline constexpr const char* orange = "#8A5A00";
inline constexpr const char* sky = "#4C9FD0";
}  // namespace colors

/// Size of a figure on the page, in pixels. Text has 16 pixels; no wider than 590, so that telephones show it legibly
/// and whole.
struct FigureSize {
  int width = 590;
  int height = 400;
};

/// Sends points as a block of data, "$fall", which can then be plotted by this name: inside `set multiplot` gnuplot 6
/// reads no data from '-'.
template <class Points>
void send_block(gnuplotio::Gnuplot& gnuplot, const std::string& name, const Points& points) {
  gnuplot << name << " << e\n";  // the line that send1d ends with
  gnuplot.send1d(points);
}

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

/// The style sheet's name for a colour, "#RRGGBB"; for one that it does not have the colour itself.
std::string name_of_color(const std::string& color);

/// Draws DIRECTORY/NAME.svg and DIRECTORY/NAME.png: `draw` sends everything after the terminal's settings, and is
/// called once per format. The SVG carries the description, if any.
/// @throws std::runtime_error if gnuplot is missing or finds an error in the script.
void draw_figure(const std::filesystem::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw, const std::string& description = "");

}  // namespace workbook
