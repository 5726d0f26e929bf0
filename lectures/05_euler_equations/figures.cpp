// Figures of lecture 05.
#include "lectures/support/motion.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/euler_equations.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;

namespace {

/// A bicycle wheel that hangs by one end of its axle: the torque of gravity turns L sideways.
void draw_gyroscope(const std::filesystem::path& directory) {
  Sketch sketch({0.75, -1.0, 0.5});
  const double length = 2.0, angle = 0.42;
  const Vector3d center = 0.75 * x_axis, tip = length * x_axis;
  const Vector3d later = length * Vector3d(std::cos(angle), std::sin(angle), 0);
  sketch.line(arc(origin, length, x_axis, y_axis, -0.25, 1.25), colors::grey, 1.2, "dt (5,4)");
  sketch.line({origin, 0.75 * z_axis}, colors::black, 2);
  for (int spoke = 0; spoke < 8; ++spoke) {
    const double at = 0.2 + spoke * pi / 4;
    sketch.line({center, center + 0.7 * (std::cos(at) * y_axis + std::sin(at) * z_axis)}, colors::grey, 1);
  }
  sketch.ring(center, x_axis, 0.7, 0.05, colors::grey);
  sketch.turned_body(origin, center + 0.2 * x_axis, {{0, 0}, {0, 0.03}, {1, 0.03}, {1, 0}}, colors::grey);
  const std::vector<Vector3d> spin = arc(center, 0.84, y_axis, z_axis, 0.6, 1.5);
  sketch.line({spin.begin(), spin.end() - 14}, colors::black, 2);
  sketch.arrow(*(spin.end() - 15), spin.back(), colors::black, "spin", Side::left, 2);
  sketch.arrow(origin, later, colors::blue, "{/:Bold L} + d{/:Bold L}", Side::right, 1.5);
  sketch.arrow(origin, tip, colors::blue, "{/:Bold L}", Side::below);
  sketch.arrow(tip, later, colors::green, "", Side::right, 2.5);
  sketch.text(0.6 * tip + 0.4 * later + Vector3d(0.16, 0, -0.04), "d{/:Bold L} = {/:Bold τ} dt", colors::green,
              Side::right);
  sketch.arrow(center, center - 1.0 * z_axis, colors::black, "M{/:Bold g}", Side::right);
  sketch.text(0.7 * z_axis, "rope", colors::black, Side::right);
  sketch.text(origin, "O", colors::black, Side::left);
  sketch.dot(origin, colors::black, 0.7);
  sketch.draw(directory, "gyroscope", 560, false);
}

/// A wheel and a dumbbell, each tilted on an upright axle: where L points, and the torque that the axle must supply.
void draw_skewed_bodies(const std::filesystem::path& directory) {
  const double tilt = 25 * degree;
  Sketch sketch;
  for (const bool is_wheel : {true, false}) {
    const Vector3d moments = is_wheel ? Vector3d(1, 1, 2) : Vector3d(1, 1, 0);
    const Vector3d center(is_wheel ? -1.6 : 1.6, 0, 0);
    // On the page x is across the axle, y along it; the body's axis 3 leans to the right, its axis 2 goes into the
    // page.
    const Vector3d across(std::cos(tilt), -std::sin(tilt), 0), along(std::sin(tilt), std::cos(tilt), 0);
    const auto on_page = [&](double first, double third) -> Vector3d {
      return center + first * across + third * along;
    };
    const Vector3d omega_body(-std::sin(tilt), 0, std::cos(tilt));
    const Vector3d L = moments.cwiseProduct(omega_body);
    const bool into_page = torque_to_hold_rotation(moments.asDiagonal(), omega_body).y() > 0;

    sketch.line({center - 1.15 * y_axis, center + 1.2 * y_axis}, colors::grey, 1.5, "dt (5,4)");
    sketch.line({center, on_page(0, 1.35)}, colors::grey, 1.5, "dt (5,4)");
    sketch.text(on_page(0, 1.35), "axis 3", colors::black, Side::right);
    if (is_wheel) {
      sketch.face({on_page(-1, -0.06), on_page(1, -0.06), on_page(1, 0.06), on_page(-1, 0.06)}, colors::grey, 0.8);
    } else {
      sketch.line({on_page(0, -1), on_page(0, 1)}, colors::black, 3);
      for (const double end : {-1.0, 1.0}) sketch.dot(on_page(0, end), colors::black, 2);
    }
    sketch.arrow(center, center + 1.45 * y_axis, colors::vermilion, "{/:Bold ω}", Side::left);
    const Vector3d shown = on_page(L[0], L[2]) - center;
    sketch.arrow(center, center + 1.15 * shown.normalized(), colors::blue, "{/:Bold L}",
                 is_wheel ? Side::above : Side::left);
    sketch.text(center - 1.3 * y_axis, into_page ? "{/:Bold τ} ⊗ into the page" : "{/:Bold τ} ⊙ out of the page",
                colors::green);
    sketch.text(center - 1.58 * y_axis, is_wheel ? "thin wheel, I_3 = 2 I_1" : "dumbbell, I_3 = 0");
  }
  sketch.draw(directory, "skewed_bodies", 560);
}

void draw_holding_torque(const std::filesystem::path& directory) {
  struct Shape {
    const char* name;
    double ratio;  // I₃/I₁
    const char *color, *dash;
    double label_height;
  };
  const std::array<Shape, 4> shapes{{{"thin wheel, I_3 = 2 I_1", 2.0, colors::vermilion, "solid", 0.56},
                                     {"thick disc, I_3 = 1.3 I_1", 1.3, colors::orange, "(12,4)", 0.21},
                                     {"sphere, cube: none", 1.0, colors::black, "(3,3)", 0.05},
                                     {"rod, dumbbell, I_3 = 0", 0.0, colors::blue, "(12,4,3,4)", -0.33}}};
  draw_figure(directory, "holding_torque", {560, 360}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; set xlabel 'angle α between ω and axis 3 (degrees)'\n"
               "set ylabel 'torque / (I_1 ω^2)'\n"
               "set xrange [0:90]; set xtics 15; set yrange [-0.6:0.65]; set ytics 0.25\n";
    std::string plot = "plot ";
    for (const Shape& shape : shapes) {
      gnuplot << fmt::format("set label '{}' at 45,{} center front tc rgb '{}'\n", shape.name, shape.label_height,
                             shape.color);
      plot += fmt::format("'-' with lines lw 3 dt {} lc rgb '{}', ", shape.dash, shape.color);
    }
    gnuplot << plot.substr(0, plot.size() - 2) << "\n";
    for (const Shape& shape : shapes) {
      PlaneCurve curve;
      for (int angle = 0; angle <= 90; ++angle) {
        const Vector3d omega(-std::sin(angle * degree), 0, std::cos(angle * degree));
        const Matrix3d I = Vector3d(1, 1, shape.ratio).asDiagonal();
        curve.emplace_back(angle, torque_to_hold_rotation(I, omega).y());
      }
      gnuplot.send1d(curve);
    }
  });
}

using Step = std::function<Vector3d(const Vector3d&, double)>;

const Vector3d tumbling_body(1, 2, 3), tumbling_start(0.1, 1, 0.1);

Vector3d rate(const Vector3d& omega) { return euler_equations(tumbling_body, omega, Vector3d::Zero()); }

Vector3d explicit_euler(const Vector3d& omega, double h) { return omega + h * rate(omega); }

Vector3d midpoint(const Vector3d& omega, double h) { return omega + h * rate(omega + h / 2 * rate(omega)); }

Vector3d runge_kutta(const Vector3d& omega, double h) {
  const Vector3d k1 = rate(omega), k2 = rate(omega + h / 2 * k1), k3 = rate(omega + h / 2 * k2);
  return omega + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(omega + h * k3));
}

void draw_integrators(const std::filesystem::path& directory) {
  const double h = 0.1, duration = 60;
  const int steps = static_cast<int>(std::lround(duration / h));
  struct Rule {
    const char* name;
    Step step;
    const char *color, *dash;
    double label_at;  // height of the label
    std::vector<Vector3d> omega;
  };
  std::array<Rule, 3> rules{{{"explicit Euler", explicit_euler, colors::vermilion, "solid", 9, {}},
                             {"midpoint", midpoint, colors::orange, "(12,4)", 2e-5, {}},
                             {"Runge–Kutta", runge_kutta, colors::blue, "(12,4,3,4)", 3e-9, {}}}};
  for (Rule& rule : rules) {
    rule.omega.push_back(tumbling_start);
    for (int i = 0; i < steps; ++i) rule.omega.push_back(rule.step(rule.omega.back(), h));
  }
  const auto exact = history(tumbling_body, {tumbling_start}, duration, 301);
  const double T0 = rotation_invariants(tumbling_body, tumbling_start)[0];

  draw_figure(directory, "integrators", {560, 490}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set multiplot layout 2,1\nunset key; set lmargin 9; set rmargin 2; set tmargin 1.6; set xrange [0:60]; "
               "set xtics 10\n"
               "set xlabel 'time (s)'; set ylabel 'ω (rad/s)'; set yrange [-1.95:1.95]; set ytics 1\n"
               "set title 'integrated (lines) and by explicit Euler (dots)' offset 0,-0.6\n";
    const std::array<std::pair<double, double>, 3> places{{{2.2, -0.75}, {14.6, -1.3}, {9.9, 0.62}}};
    std::string plot = "plot ";
    for (std::size_t i = 0; i < 3; ++i) {
      gnuplot << fmt::format("set label 'ω̃_{}' at {},{} center front tc rgb '{}'\n", i + 1, places[i].first,
                             places[i].second, axis_colors[i]);
      PlaneCurve line, dots;
      for (std::size_t k = 0; k < exact.size(); ++k)
        line.emplace_back(duration * static_cast<double>(k) / 300, exact[k].omega[static_cast<Eigen::Index>(i)]);
      for (std::size_t k = 0; k < rules[0].omega.size(); k += 6)
        dots.emplace_back(static_cast<double>(k) * h, rules[0].omega[k][static_cast<Eigen::Index>(i)]);
      send_block(gnuplot, fmt::format("$line{}", i), line);
      send_block(gnuplot, fmt::format("$dots{}", i), dots);
      plot += fmt::format("$line{0} with lines lw 2.5 lc rgb '{1}', $dots{0} with points pt 7 ps 0.35 lc rgb '{1}'{2}",
                          i, axis_colors[i], i < 2 ? ", " : "\n");
    }
    gnuplot << plot
            << "unset label; set title 'energy that the computation gained or lost'\n"
               "set ylabel '|ΔT| / T'; set logscale y; set format y '10^{%T}'; set yrange [1e-12:1e2]; set ytics "
               "1e-12,1e4\n";
    plot = "plot ";
    for (std::size_t r = 0; r < rules.size(); ++r) {
      gnuplot << fmt::format("set label '{}' at 58.5,{} right front tc rgb '{}'\n", rules[r].name, rules[r].label_at,
                             rules[r].color);
      PlaneCurve curve;
      for (std::size_t k = 4; k < rules[r].omega.size(); k += 4) {
        const double drift = rotation_invariants(tumbling_body, rules[r].omega[k])[0] / T0 - 1;
        curve.emplace_back(static_cast<double>(k) * h, std::max(std::abs(drift), 1e-13));
      }
      send_block(gnuplot, fmt::format("$drift{}", r), curve);
      plot += fmt::format("$drift{} with lines lw 2.5 dt {} lc rgb '{}'{}", r, rules[r].dash, rules[r].color,
                          r + 1 < rules.size() ? ", " : "\n");
    }
    gnuplot << plot << "unset multiplot\n";
  });
}

/// A book that tumbles, at eight moments: its angular momentum stays where it is.
void draw_tumbling(const std::filesystem::path& directory) {
  const double step = 1.5;
  Sketch sketch({1.0, -0.75, 0.6});
  const Vector3d right = sketch.right(), up = sketch.up();
  const Vector3d L = tumbling_body.cwiseProduct(tumbling_start).normalized();
  std::array<bool, 3> is_named{};
  for (int i = 0; i < 8; ++i) {
    const int column = i % 4, row = i / 4;
    const Vector3d center = 2.3 * column * right - 2.4 * row * up;
    const Matrix3d A = integrated(tumbling_body, {tumbling_start}, step * i).A;
    const Vector3d half(0.72, 0.5, 0.09);
    sketch.line({center - 1.05 * L, center}, colors::blue, 2, "dt (5,4)");
    const auto faces_reader = [&](int axis) { return A.col(axis).dot(sketch.towards()) > 0; };
    sketch.solid_box(center, A * half.asDiagonal(),
                     {colors::grey, colors::grey, faces_reader(2) ? colors::sky : colors::orange});
    // Axes begin at the faces that the reader sees; each has its name once.
    for (int axis = 0; axis < 3; ++axis) {
      if (!faces_reader(axis)) continue;
      const auto k = static_cast<std::size_t>(axis);
      const Vector3d from = center + half[axis] * A.col(axis);
      sketch.arrow(from, from + 0.42 * A.col(axis), axis_colors[k], "", Side::right, 2);
      if (!std::exchange(is_named[k], true))
        sketch.text(from + 0.62 * A.col(axis), fmt::format("{{/:Bold e}}_{}", axis + 1), axis_colors[k]);
    }
    sketch.arrow(center, center + 1.1 * L, colors::blue, i == 0 ? "{/:Bold L}" : "", Side::above, 3);
    sketch.text(center - 1.12 * up, fmt::format("{:.1f} s", step * i));
  }
  sketch.draw(directory, "tumbling", 600, false);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"gyroscope", draw_gyroscope},
                       {"skewed_bodies", draw_skewed_bodies},
                       {"holding_torque", draw_holding_torque},
                       {"integrators", draw_integrators},
                       {"tumbling", draw_tumbling}});
}
