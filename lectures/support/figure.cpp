#include "lectures/support/figure.hpp"

#include <rigid/vocabulary.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
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

/// Text inside the shell's single quotes.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

}  // namespace

int draw_figures(int argc, char** argv, const std::vector<Figure>& figures) {
  // gnuplot may end before we have told it everything; that is a figure that failed, not the end of the program.
  std::signal(SIGPIPE, SIG_IGN);
  const std::string first = argc > 1 ? argv[1] : "";
  if (argc == 2 && first == "--list") {
    for (const Figure& figure : figures) fmt::print("{}\n", figure.name);
    return figures_drawn;
  }
  const std::string wanted = argc == 3 ? argv[2] : "";
  const bool known = wanted.empty() || std::any_of(figures.begin(), figures.end(),
                                                   [&](const Figure& figure) { return figure.name == wanted; });
  if (argc < 2 || argc > 3 || !known) {
    fmt::print(stderr, "usage: {} DIRECTORY [FIGURE], or --list\nDraws the figures of the lecture into DIRECTORY.\n",
               argv[0]);
    return figure_wrong_usage;
  }
  FigureStatus worst = figures_drawn;
  const auto fails = [&](const Figure& figure, FigureStatus status, const std::string& why) {
    if (worst != figure_failed) worst = status;
    std::fflush(stdout);
    fmt::print(stderr, "{}: {}\n", figure.name, why);
  };
  for (const Figure& figure : figures) {
    if (!wanted.empty() && figure.name != wanted) continue;
    try {
      std::filesystem::create_directories(first);
      figure.draw(first);
    } catch (const rigid::NotStarted&) {
      fails(figure, figure_not_started, "needs a function that is not started");
    } catch (const std::exception& problem) {
      fails(figure, figure_failed, problem.what());
    } catch (...) {
      fails(figure, figure_failed, "something was thrown that is no std::exception");
    }
  }
  return worst;
}

void draw_figure(const std::filesystem::path& directory, const std::string& name, FigureSize size,
                 const std::function<void(gnuplotio::Gnuplot&)>& draw) {
  for (const std::string format : {"svg", "png"}) {
    const std::filesystem::path file = directory / fmt::format("{}.{}", name, format);
    std::filesystem::remove(file);
    // After an error gnuplot goes on and leaves half a picture. Only its exit status tells, and the library drops it:
    // so the shell writes this file where all went well.
    const std::filesystem::path witness = file.string() + ".complete";
    {
      gnuplotio::Gnuplot gnuplot(fmt::format("if gnuplot; then : >{}; fi", shell_quoted(witness.string())));
      gnuplot << "set encoding utf8\n"
              << terminal(format, size) << "set output '" << file.string() << "'\n"
              << common_style;
      draw(gnuplot);
      gnuplot << "\nset output\n";
    }
    if (!std::filesystem::remove(witness) || !std::filesystem::exists(file) || std::filesystem::file_size(file) == 0) {
      std::filesystem::remove(file);
      throw std::runtime_error(
          fmt::format("gnuplot could not draw {}.{}: is it installed, and is every number finite?", name, format));
    }
  }
}

}  // namespace workbook
