// Figures of lecture 07.
#include "lectures/support/figure.hpp"

#include <rigid/euler_angles.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace rigid;

namespace {

using Curve = std::vector<std::tuple<double, double, double>>;
using PlaneCurve = std::vector<std::pair<double, double>>;

constexpr double pi = std::numbers::pi;

// ---- the three turns
// --------------------------------------------------------------------------------------------------

/// The body axes as columns, on the inertial axes.
Matrix3d triad(const Vector3d& angles) { return rotation_matrix(angles).transpose(); }

/// What one panel shows: a triad, the triad before it, and the axis about which it has turned.
struct Turn {
  const char* title;
  Vector3d before;
  Vector3d after;
  int axis;
  const char* angle_name;
  std::array<const char*, 3> old_names;
  std::array<const char*, 3> names;
};

/// The path of an axis while the turn goes on.
Curve arc(const Turn& turn, int which, double radius) {
  Curve curve;
  for (int i = 0; i <= 24; ++i) {
    const Vector3d angles = turn.before + (turn.after - turn.before) * i / 24.0;
    const Vector3d p = radius * triad(angles).col(which);
    curve.emplace_back(p.x(), p.y(), p.z());
  }
  return curve;
}

void draw_panel(gnuplotio::Gnuplot& gnuplot, const Turn& turn) {
  const Matrix3d old_axes = triad(turn.before);
  const Matrix3d new_axes = triad(turn.after);
  const std::array<const char*, 3> colors = {workbook::colors::vermilion, workbook::colors::green,
                                             workbook::colors::blue};

  gnuplot << "unset arrow; unset label\n" << fmt::format("set title '{}' offset 0,0.4\n", turn.title);
  for (int i = 0; i < 3; ++i) {
    const Vector3d old_tip = old_axes.col(i);
    const Vector3d tip = new_axes.col(i);
    const Vector3d place = (i == 2 ? 1.3 : 1.22) * tip;  // ê₃ is foreshortened: keep its name off the arrow
    if (i != turn.axis) {
      gnuplot << fmt::format("set arrow from 0,0,0 to {:.4f},{:.4f},{:.4f} nohead dt 2 lw 1.5 lc rgb '{}'\n",
                             old_tip.x(), old_tip.y(), old_tip.z(), workbook::colors::grey)
              << fmt::format("set label '{}' at {:.4f},{:.4f},{:.4f} center front tc rgb '#555555'\n",
                             turn.old_names[i], 1.3 * old_tip.x(), 1.3 * old_tip.y(), 1.3 * old_tip.z());
    }
    gnuplot << fmt::format("set arrow from 0,0,0 to {:.4f},{:.4f},{:.4f} front size 0.12,20 filled lw {} lc rgb '{}'\n",
                           tip.x(), tip.y(), tip.z(), i == turn.axis ? 5 : 2.5, colors[i])
            << fmt::format("set label '{}' at {:.4f},{:.4f},{:.4f} center front tc rgb '{}'\n", turn.names[i],
                           place.x(), place.y(), place.z(), colors[i]);
  }
  // The two axes that move leave an arc behind; the angle is written at the first of them.
  const int first = (turn.axis + 1) % 3, second = (turn.axis + 2) % 3;
  const auto middle = arc(turn, first, 0.88)[12];
  gnuplot << fmt::format("set label '{{/:Bold {}}}' at {:.4f},{:.4f},{:.4f} center front\n", turn.angle_name,
                         std::get<0>(middle), std::get<1>(middle), std::get<2>(middle));
  gnuplot << "splot '-' w l lw 2 lc rgb '#222222', '-' w l lw 2 lc rgb '#222222'\n";
  gnuplot.send1d(arc(turn, first, 0.7));
  gnuplot.send1d(arc(turn, second, 0.7));
}

void draw_three_turns(const std::filesystem::path& directory) {
  const double phi = 0.7, theta = 0.6, psi = 0.9;
  const std::vector<Turn> turns = {
      {"1: φ about ê_3^0", {0, 0, 0}, {phi, 0, 0}, 2, "φ", {"ê_1^0", "ê_2^0", ""}, {"", "ê_2′", "ê_3^0"}},
      {"2: θ about ê_2′", {phi, 0, 0}, {phi, theta, 0}, 1, "θ", {"", "", "ê_3^0"}, {"ê_1′", "ê_2′", "ê_3"}},
      {"3: ψ about ê_3", {phi, theta, 0}, {phi, theta, psi}, 2, "ψ", {"ê_1′", "ê_2′", ""}, {"ê_1", "ê_2", "ê_3"}},
  };
  workbook::draw_figure(directory, "three_turns", {420, 960}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; unset border; unset tics; unset grid\n"
               "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
               "set view 66, 168, 1.55; set view equal xyz; set xyplane 0\n"
               "set xrange [-1.05:1.05]; set yrange [-1.05:1.05]; set zrange [-0.85:1.2]\n"
               "set multiplot layout 3,1\n";
    for (const Turn& turn : turns) draw_panel(gnuplot, turn);
    gnuplot << "unset multiplot\n";
  });
}

// ---- gimbal lock
// ------------------------------------------------------------------------------------------------------

void draw_gimbal_lock(const std::filesystem::path& directory) {
  const auto condition = [](double theta) {
    Matrix3d E;
    for (int i = 0; i < 3; ++i) E.col(i) = angular_velocity_body(Vector3d(0.3, theta, 1.1), Vector3d::Unit(i));
    const Vector3d stretches = Eigen::JacobiSVD<Matrix3d>(E).singularValues();
    return stretches[0] / stretches[2];
  };
  PlaneCurve formula, computed;
  for (int i = 0; i <= 200; ++i) {
    const double theta = std::pow(10, -3 + 3.19 * i / 200);
    formula.emplace_back(theta, 1 / std::tan(theta / 2));
  }
  for (const double theta : {0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 0.7, pi / 2})
    computed.emplace_back(theta, condition(theta));

  workbook::draw_figure(directory, "gimbal_lock", {560, 420}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set logscale xy; set format xy '10^{%T}'\n"
               "set xlabel 'θ (rad)'; set ylabel 'condition number of E (pure number)'\n"
               "set xrange [0.0007:2.2]; set yrange [0.7:4000]; unset key\n"
            << fmt::format("set label 'cot(θ/2)' at 0.0042,900 left tc rgb '{}'\n", workbook::colors::blue)
            << fmt::format("set label 'θ = 0.1: {:.2f}' at 0.13,28 left tc rgb '{}'\n", condition(0.1),
                           workbook::colors::vermilion)
            << fmt::format("set label 'θ = 0.01: {:.1f}' at 0.013,280 left tc rgb '{}'\n", condition(0.01),
                           workbook::colors::vermilion)
            << fmt::format("set label 'θ = π/2: {:.0f}' at 1.1,0.95 right tc rgb '{}'\n", condition(pi / 2),
                           workbook::colors::vermilion)
            << fmt::format("plot '-' w l lw 2.5 lc rgb '{}', '-' w p pt 7 ps 1.2 lc rgb '{}'\n", workbook::colors::blue,
                           workbook::colors::vermilion);
    gnuplot.send1d(formula);
    gnuplot.send1d(computed);
  });
}

// ---- one list of numbers, two motions
// -----------------------------------------------------------------------------------

void draw_two_readings(const std::filesystem::path& directory) {
  // A nodding top: it goes round steadily and dips five times in two turns.
  const auto angles_at = [](double turns) {
    return Vector3d(2 * pi * turns, 0.7 + 0.25 * std::cos(2 * pi * 2.5 * turns), 0);
  };
  const auto tip_zyz = [&](double turns) -> Vector3d {
    return inertial_components(Vector3d::UnitZ(), angles_at(turns));
  };
  // z–x–z: the same numbers, but the second turn goes about the x′ axis.
  const auto tip_zxz = [&](double turns) -> Vector3d {
    const Vector3d angles = angles_at(turns);
    return Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) *
           (Eigen::AngleAxisd(angles[1], Vector3d::UnitX()) * Vector3d::UnitZ());
  };
  const double shown = 0.6;
  const auto track = [shown](const std::function<Vector3d(double)>& tip) {
    PlaneCurve curve;
    for (int i = 0; i <= 300; ++i) {
      const Vector3d p = tip(shown * i / 300);
      curve.emplace_back(p.x(), p.y());
    }
    return curve;
  };
  PlaneCurve horizon;
  for (int i = 0; i <= 180; ++i) horizon.emplace_back(std::cos(pi * i / 90), std::sin(pi * i / 90));

  workbook::draw_figure(directory, "two_readings", {520, 540}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot
        << "set size ratio -1; set xrange [-1.1:1.1]; set yrange [-1.1:1.1]; set xtics 0.5; set ytics 0.5; unset key\n"
           "set xlabel 'x component of ê_3 (pure number)'; set ylabel 'y component of ê_3'\n";
    const auto mark = [&gnuplot](const Vector3d& from, const Vector3d& to, const char* color, const std::string& name,
                                 double dx, double dy, const char* side) {
      gnuplot << fmt::format("set label at {:.4f},{:.4f} point pt 7 ps 1.3 lc rgb '{}' front\n", from.x(), from.y(),
                             color)
              << fmt::format(
                     "set arrow from {:.4f},{:.4f} to {:.4f},{:.4f} front size 0.07,22 filled lw 2.5 lc rgb '{}'\n",
                     from.x(), from.y(), to.x(), to.y(), color)
              << fmt::format("set label '{}' at {:.4f},{:.4f} {} front tc rgb '{}'\n", name, from.x() + dx,
                             from.y() + dy, side, color);
    };
    gnuplot << "set label 'θ = π/2' at 0,0.92 center tc rgb '#444444'\n";
    mark(tip_zyz(0), tip_zyz(0.03), workbook::colors::blue, "z–y–z", 0, -0.1, "center");
    mark(tip_zxz(0), tip_zxz(0.03), workbook::colors::vermilion, "z–x–z", 0, -0.1, "center");
    gnuplot << fmt::format(
        "plot '-' w l lw 1 lc rgb '{}', '-' w l lw 3 lc rgb '{}', '-' w l dt (12,6) lw 3 lc rgb '{}'\n",
        workbook::colors::grey, workbook::colors::blue, workbook::colors::vermilion);
    gnuplot.send1d(horizon);
    gnuplot.send1d(track(tip_zyz));
    gnuplot.send1d(track(tip_zxz));
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(
      argc, argv,
      {{"three_turns", draw_three_turns}, {"gimbal_lock", draw_gimbal_lock}, {"two_readings", draw_two_readings}});
}
