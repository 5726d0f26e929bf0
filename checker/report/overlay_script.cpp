#include "checker/report/overlay_script.hpp"

#include "checker/messages/plotting.hpp"
#include "checker/report/gnuplot_program.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>
#include <utility>

namespace workbook {

namespace fs = std::filesystem;

namespace {

using Points = std::vector<std::pair<double, double>>;

// Okabe and Ito's colours: told apart by the colour-blind, and by lightness in print.
constexpr const char* reference_colors[] = {"#56B4E9", "#F0B040", "#66C2A5"};
constexpr const char* student_colors[] = {"#004B7A", "#A04000", "#00604A"};

double number_at(const Value& value, const PlotComponent& component, bool magnitude) {
  if (component.row >= value.rows || component.col >= value.cols) return std::numeric_limits<double>::quiet_NaN();
  const double number = value.at(component.row, component.col);
  return magnitude ? std::abs(number) : number;
}

Points curve(const std::vector<double>& x, const std::vector<Value>& y, const PlotComponent& component,
             bool magnitude) {
  Points points;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double value = number_at(y[i], component, magnitude);
    if (std::isfinite(value)) points.emplace_back(x[i], value);
  }
  // gnuplot refuses an empty block; a point that is not a number draws nothing.
  if (points.empty()) points.emplace_back(x.front(), std::numeric_limits<double>::quiet_NaN());
  return points;
}

Points difference(const Overlay& overlay, const PlotComponent& component) {
  Points points;
  for (std::size_t i = 0; i < overlay.sweep->x.size(); ++i) {
    const double value = number_at(overlay.student[i], component, overlay.magnitudes) -
                         number_at(overlay.sweep->expected[i], component, overlay.magnitudes);
    if (std::isfinite(value)) points.emplace_back(overlay.sweep->x[i], value);
  }
  if (points.empty()) points.emplace_back(overlay.sweep->x.front(), std::numeric_limits<double>::quiet_NaN());
  return points;
}

/// Text inside gnuplot's single quotes.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "''" : std::string(1, letter);
  return result + "'";
}

void send_upper_panel(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay) {
  const Sweep& sweep = *overlay.sweep;
  std::vector<Points> data;
  std::string plots;
  const auto add = [&](Points points, const std::string& how) {
    plots += (plots.empty() ? "plot " : ", ") + std::string("'-' ") + how;
    data.push_back(std::move(points));
  };
  for (std::size_t k = 0; k < sweep.components.size(); ++k) {
    const PlotComponent& component = sweep.components[k];
    const std::string label = component_label(overlay, component);
    add(curve(sweep.x, sweep.expected, component, overlay.magnitudes),
        fmt::format("with lines lw 6 lc rgb '{}' title {}", reference_colors[k % 3],
                    quoted(messages::reference_label(label))));
    if (!overlay.student.empty()) {
      add(curve(sweep.x, overlay.student, component, overlay.magnitudes),
          fmt::format("with linespoints lw 1.5 pt {} ps 0.6 pointinterval 4 lc rgb '{}' title {}",
                      k == 0   ? 7
                      : k == 1 ? 5
                               : 9,
                      student_colors[k % 3], quoted(messages::student_label(label))));
    }
    if (overlay.misconception_outputs != nullptr) {
      add(curve(sweep.x, *overlay.misconception_outputs, component, overlay.magnitudes),
          fmt::format("with lines lw 2 dt (8,6) lc rgb '#000000' title {}",
                      k == 0 ? quoted(overlay.misconception) : "''"));
    }
  }
  gnuplot << plots << "\n";
  for (const Points& points : data) gnuplot.send1d(points);
}

void send_lower_panel(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay) {
  const Sweep& sweep = *overlay.sweep;
  std::string plots = "plot 0 with lines lw 1 lc rgb '#888888' notitle";
  for (std::size_t k = 0; k < sweep.components.size(); ++k) {
    plots += fmt::format(", '-' with linespoints lw 1.5 pt {} ps 0.6 pointinterval 4 lc rgb '{}' title {}",
                         k == 0   ? 7
                         : k == 1 ? 5
                                  : 9,
                         student_colors[k % 3], quoted(component_label(overlay, sweep.components[k])));
  }
  gnuplot << plots << "\n";
  for (const PlotComponent& component : sweep.components) gnuplot.send1d(difference(overlay, component));
}

/// Differences smaller than rounding would fill the panel with noise; the range never shrinks below this.
double smallest_range(const Overlay& overlay) {
  double largest = 0.0;
  for (const Value& value : overlay.sweep->expected) {
    for (const PlotComponent& component : overlay.sweep->components) {
      largest = std::max(largest, std::abs(number_at(value, component, true)));
    }
  }
  return largest > 0 ? 1e-9 * largest : 1e-9;
}

double largest_difference(const Overlay& overlay) {
  double largest = 0.0;
  for (const PlotComponent& component : overlay.sweep->components) {
    for (const auto& [x, y] : difference(overlay, component)) {
      if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    }
  }
  return largest;
}

/// The curve with many more points, along straight lines: letters then follow it without gaps.
Points densely(const Points& points, std::size_t count) {
  Points dense;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto& [x0, y0] = points[i];
    const auto& [x1, y1] = points[i + 1];
    const std::size_t steps = std::max<std::size_t>(1, count / points.size());
    for (std::size_t k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(steps);
      dense.emplace_back(x0 + t * (x1 - x0), y0 + t * (y1 - y0));
    }
  }
  dense.push_back(points.back());
  return dense;
}

/// Every few points only, so that the letters stand apart and what is below them shows.
Points sparsely(const Points& points, std::size_t most) {
  const std::size_t stride = std::max<std::size_t>(1, (points.size() + most - 1) / most);
  Points sparse;
  for (std::size_t i = 0; i < points.size(); i += stride) sparse.push_back(points[i]);
  return sparse;
}

/// Text inside the shell's single quotes.
std::string shell_quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) result += letter == '\'' ? "'\\''" : std::string(1, letter);
  return result + "'";
}

// Neither dark nor light: they read on black and on white.
constexpr const char* letter_colors[] = {"#3794D0", "#C8781E", "#3A9E6B"};

}  // namespace

std::string component_label(const Overlay& overlay, const PlotComponent& component) {
  return overlay.magnitudes ? "|" + component.name + "|" : component.name;
}

void draw_picture(const std::string& terminal, const fs::path& file,
                  const std::function<void(gnuplotio::Gnuplot&)>& script) {
  const std::string gnuplot_path = gnuplot_program();
  if (gnuplot_path.empty()) throw PlotError(messages::gnuplot_missing_for_plot());
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  // Under another name until it is whole: two checkers may draw the same plot at the same time.
  const fs::path part = fmt::format("{}.{}.part", file.string(), getpid());
  if (!std::ofstream(part)) throw PlotError(messages::plot_not_written(file.string()));
  // After an error gnuplot goes on and leaves half a picture. Only its exit status tells, and the library drops it: so
  // the shell writes this file where all went well.
  const fs::path witness = part.string() + ".complete";
  {
    gnuplotio::Gnuplot gnuplot(
        fmt::format("if {} 2>/dev/null; then : >{}; fi", shell_quoted(gnuplot_path), shell_quoted(witness.string())));
    gnuplot << "set encoding utf8\nset terminal " << terminal << "\nset output " << quoted(part.string()) << "\n";
    script(gnuplot);
    gnuplot << "set output\n";
  }
  const bool complete = fs::remove(witness, problem) && fs::file_size(part, problem) > 0 && !problem;
  if (!complete) {
    fs::remove(part, problem);
    throw PlotError(messages::plot_not_drawn(file.string()));
  }
  fs::rename(part, file, problem);
  if (problem) {
    fs::remove(part, problem);
    throw PlotError(messages::plot_not_written(file.string()));
  }
}

std::string drawn_picture(const std::string& terminal, const fs::path& directory,
                          const std::function<void(gnuplotio::Gnuplot&)>& script) {
  const fs::path file = directory / fmt::format("picture-{}", getpid());
  draw_picture(terminal, file, script);
  std::ifstream in(file, std::ios::binary);
  std::string picture{std::istreambuf_iterator<char>(in), {}};
  in.close();
  std::error_code ignored;
  fs::remove(file, ignored);
  return picture;
}

void send_panels(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay) {
  const Sweep& sweep = *overlay.sweep;
  gnuplot << "set grid lc rgb '#DDDDDD' lt 1\n"
             "set border lc rgb '#444444'\n"
             // The key stands above the curves, where it covers none of them.
             "set key outside top center horizontal maxrows 4 width -1\n"
          << fmt::format("set xrange [{}:{}]\n", sweep.x.front(), sweep.x.back())
          << (overlay.student.empty() ? "" : "set multiplot\n") << "set lmargin 13; set rmargin 3\n"
          << fmt::format("set title {} noenhanced\n", quoted(sweep.title))
          << fmt::format("set ylabel {} noenhanced\n", quoted(sweep.y_label));
  if (overlay.student.empty()) {
    gnuplot << fmt::format("set xlabel {} noenhanced\n", quoted(sweep.x_label));
    send_upper_panel(gnuplot, overlay);
    return;
  }
  gnuplot << "set size 1,0.68; set origin 0,0.32; set bmargin 1; set format x ''\n";
  send_upper_panel(gnuplot, overlay);
  const double range = 1.1 * std::max(smallest_range(overlay), largest_difference(overlay));
  gnuplot << "unset title; set size 1,0.32; set origin 0,0; set tmargin 0.5; set bmargin 3.5; set format x; unset key\n"
          << fmt::format("set xlabel {} noenhanced\nset ylabel {}\n", quoted(sweep.x_label),
                         quoted(messages::difference_label()))
          << fmt::format("set yrange [{}:{}]; set ytics {}; set format y '%.2g'\n", -range, range, range / 1.1);
  send_lower_panel(gnuplot, overlay);
  gnuplot << "unset multiplot\n";
}

void send_letters(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay, std::size_t columns) {
  const Sweep& sweep = *overlay.sweep;
  gnuplot << "unset key\nset border 3\nset tics nomirror out scale 0.5\n"
          << fmt::format("set xrange [{}:{}]\n", sweep.x.front(), sweep.x.back())
          << fmt::format("set title {} noenhanced\n", quoted(sweep.title))
          << fmt::format("set xlabel {} noenhanced\n", quoted(sweep.x_label))
          << fmt::format("set ylabel {} noenhanced\n", quoted(sweep.y_label));
  std::string plots;
  std::vector<Points> data;
  const auto add = [&](const Points& points, char letter, const char* color) {
    plots += fmt::format("{} '-' with points pt '{}' lc rgb '{}'", plots.empty() ? "plot" : ",", letter, color);
    data.push_back(points);
  };
  const auto component_curve = [&](const std::vector<Value>& values, std::size_t k) {
    return curve(sweep.x, values, sweep.components[k], overlay.magnitudes);
  };
  for (std::size_t k = 0; k < sweep.components.size(); ++k)
    add(densely(component_curve(sweep.expected, k), 3 * columns), reference_letters[k % 3], letter_colors[k % 3]);
  for (std::size_t k = 0; overlay.misconception_outputs != nullptr && k < sweep.components.size(); ++k)
    add(densely(component_curve(*overlay.misconception_outputs, k), columns), misconception_letter, "#808080");
  // The student's letters come last: nothing may hide them.
  for (std::size_t k = 0; !overlay.student.empty() && k < sweep.components.size(); ++k)
    add(sparsely(component_curve(overlay.student, k), columns / 5), student_letters[k % 9], letter_colors[k % 3]);
  gnuplot << plots << "\n";
  for (const Points& points : data) gnuplot.send1d(points);
}

}  // namespace workbook
