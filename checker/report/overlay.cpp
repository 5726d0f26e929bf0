#include "checker/report/overlay.hpp"

#include "checker/report/gnuplot_program.hpp"

#include <fmt/format.h>
#include <gnuplot-iostream.h>

#include <algorithm>
#include <cmath>
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

std::string component_label(const PlotComponent& component, bool magnitude) {
  return magnitude ? "|" + component.name + "|" : component.name;
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
    const std::string label = component_label(component, overlay.magnitudes);
    add(curve(sweep.x, sweep.expected, component, overlay.magnitudes),
        fmt::format("with lines lw 6 lc rgb '{}' title {}", reference_colors[k % 3], quoted(label + " reference")));
    if (!overlay.student.empty()) {
      add(curve(sweep.x, overlay.student, component, overlay.magnitudes),
          fmt::format("with linespoints lw 1.5 pt {} ps 0.6 pointinterval 4 lc rgb '{}' title {}",
                      k == 0   ? 7
                      : k == 1 ? 5
                               : 9,
                      student_colors[k % 3], quoted(label + " yours")));
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
                         student_colors[k % 3], quoted(component_label(sweep.components[k], overlay.magnitudes)));
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

void send_script(gnuplotio::Gnuplot& gnuplot, const Overlay& overlay) {
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
          << fmt::format("set xlabel {} noenhanced\nset ylabel 'yours − reference'\n", quoted(sweep.x_label))
          << fmt::format("set yrange [{}:{}]; set ytics {}; set format y '%.2g'\n", -range, range, range / 1.1);
  send_lower_panel(gnuplot, overlay);
  gnuplot << "unset multiplot\n";
}

}  // namespace

Overlay overlay_of(const Checked& checked) {
  const ExerciseReference& reference = *checked.reference;
  Overlay overlay;
  overlay.sweep = &reference.sweep;
  overlay.magnitudes =
      reference.comparison == Comparison::eigenvectors || reference.comparison == Comparison::up_to_sign;
  if (checked.executable) {
    std::vector<PlannedCall> calls;
    for (std::size_t i = 0; i < reference.sweep.x.size(); ++i) {
      const Value& expected = reference.sweep.expected[i];
      calls.push_back({reference.sweep.inputs[i], expected.rows, expected.cols});
    }
    ExerciseRunner runner(*checked.executable);
    bool any = false;
    for (const Reply& reply : runner.evaluate(calls)) {
      any = any || reply.ending == Ending::returned;
      overlay.student.push_back(reply.ending == Ending::returned ? reply.value : Value{0, 0, {}});
    }
    if (!any) overlay.student.clear();
  }
  for (const Diagnosis& diagnosis : checked.judgement.diagnoses) {
    if (diagnosis.kind != DiagnosisKind::misconception) continue;
    for (const Misconception& misconception : reference.misconceptions) {
      if (misconception.name != diagnosis.name) continue;
      overlay.misconception = misconception.name;
      std::replace(overlay.misconception.begin(), overlay.misconception.end(), '_', ' ');
      overlay.misconception_outputs = &misconception.sweep_outputs;
    }
  }
  return overlay;
}

std::vector<fs::path> draw_overlay(const Overlay& overlay, const fs::path& directory, const std::string& name) {
  if (overlay.sweep->x.empty()) throw PlotError(fmt::format("{} has no plot.", name));
  const std::string gnuplot_path = gnuplot_program();
  if (gnuplot_path.empty()) {
    throw PlotError(
        "There is no plot, because gnuplot is not installed (on Debian: apt-get install gnuplot-nox); the verdict "
        "stands without it.");
  }
  std::error_code problem;
  fs::create_directories(directory, problem);
  std::vector<fs::path> files;
  for (const std::string format : {"svg", "png"}) {
    const fs::path file = directory / fmt::format("{}.{}", name, format);
    fs::remove(file, problem);
    {
      gnuplotio::Gnuplot gnuplot(gnuplot_path + " 2>/dev/null");
      gnuplot << "set encoding utf8\n"
              << (format == "svg"
                      ? "set terminal svg noenhanced size 800,640 font 'Helvetica,14' background rgb 'white'\n"
                      : "set terminal pngcairo noenhanced size 1600,1280 font 'Helvetica,24' linewidth 2 background "
                        "rgb 'white'\n")
              << "set output " << quoted(file.string()) << "\n";
      send_script(gnuplot, overlay);
      gnuplot << "set output\n";
    }
    if (!fs::exists(file, problem) || fs::file_size(file, problem) == 0) {
      throw PlotError(fmt::format("The plot could not be written to {}; make that folder writable, or free some space.",
                                  file.string()));
    }
    files.push_back(file);
  }
  return files;
}

}  // namespace workbook
