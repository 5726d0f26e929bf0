#include "lectures/support/figure.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace workbook {

namespace {

/// What all figures share: a white ground, quiet axes, a light grid, lines that stay visible in print.
constexpr const char* common_style =
    "set border lc rgb '#444444'\n"
    "set grid lc rgb '#DDDDDD' lt 1\n"
    "set key opaque box lc rgb '#DDDDDD'\n"
    "set tics textcolor rgb '#222222'\n";

std::string terminal(const std::string& format, FigureSize size) {
  if (format == "svg") {
    return fmt::format("set terminal svg enhanced size {},{} font 'Helvetica,15' background rgb 'white'\n", size.width,
                       size.height);
  }
  // Twice the pixels, for sharp text in print and on dense screens.
  return fmt::format(
      "set terminal pngcairo enhanced size {},{} font 'Helvetica,24' linewidth 2 background rgb 'white'\n",
      2 * size.width, 2 * size.height);
}

}  // namespace

std::filesystem::path figure_directory(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} DIRECTORY\nDraws the figures of the lecture into DIRECTORY.\n", argv[0]);
    std::exit(2);
  }
  std::filesystem::create_directories(argv[1]);
  return argv[1];
}

void draw_figure(const std::filesystem::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  for (const std::string format : {"svg", "png"}) {
    const std::filesystem::path file = directory / fmt::format("{}.{}", name, format);
    std::filesystem::remove(file);
    {
      gnuplotio::Gnuplot gnuplot("gnuplot");
      gnuplot << "set encoding utf8\n"
              << terminal(format, size) << "set output '" << file.string() << "'\n"
              << common_style;
      draw(gnuplot);
      gnuplot << "\nset output\n";
    }
    if (!std::filesystem::exists(file) || std::filesystem::file_size(file) == 0) {
      throw std::runtime_error(
          fmt::format("gnuplot drew no {}: is gnuplot installed, and the script above free of errors?", file.string()));
    }
  }
}

}  // namespace workbook
