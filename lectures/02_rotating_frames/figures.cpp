// Figures of lecture 02.
#include "lectures/support/figure.hpp"

#include <rigid/frame_derivatives.hpp>
#include <rigid/rotating_frames.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
namespace colors = workbook::colors;

namespace {

using Curve = std::vector<std::pair<double, double>>;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr double earth_rate = 7.292115e-5;   // rad/s
constexpr double sidereal_day = 86164.0905;  // s

Vector3d turned(const Vector3d& vector, const Vector3d& omega, double t) {
  return rotated_basis(Matrix3d::Identity(), omega, t) * vector;
}

/// The puck of the worked example, seen by somebody who stands beside the turntable and by somebody who rides on it.
void draw_puck(const std::filesystem::path& directory) {
  const Vector3d omega(0, 0, 1);
  const Vector3d r0(-1, 0, 0), v0(0.5, 0.1, 0);
  const double time = 4;
  const auto outside = [&](double t) -> Vector3d { return r0 + v0 * t; };
  const auto riding = [&](double t) -> Vector3d { return turned(outside(t), omega, -t); };

  Curve rim, line, curve, line_marks, curve_marks, chalk;
  for (int k = 0; k <= 120; ++k) {
    const double t = time * k / 120;
    rim.emplace_back(1.15 * std::cos(2 * pi * k / 120), 1.15 * std::sin(2 * pi * k / 120));
    line.emplace_back(outside(t).x(), outside(t).y());
    curve.emplace_back(riding(t).x(), riding(t).y());
    const Vector3d start_on_table = turned(r0, omega, t);
    chalk.emplace_back(start_on_table.x(), start_on_table.y());
  }
  std::string numbers_line, numbers_curve;
  for (int second = 0; second <= 4; ++second) {
    const Vector3d a = outside(second), b = riding(second);
    line_marks.emplace_back(a.x(), a.y());
    curve_marks.emplace_back(b.x(), b.y());
    const Vector3d away = second == 0 ? Vector3d(0.02, -0.16, 0) : Vector3d(0.16 * b.normalized());
    numbers_line += fmt::format("set label '{}' at {:.3f},{:.3f} center front\n", second, a.x(), a.y() + 0.16);
    numbers_curve +=
        fmt::format("set label '{}' at {:.3f},{:.3f} center front\n", second, b.x() + away.x(), b.y() + away.y());
  }

  workbook::draw_figure(directory, "puck_on_turntable", {760, 430}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot
        << "set multiplot layout 1,2 margins 0.08,0.99,0.14,0.92 spacing 0.09\n"
           "unset key; set size ratio -1; set xrange [-1.35:1.35]; set yrange [-1.35:1.35]; set xtics 1; set ytics 1\n"
           "set xlabel 'x (m)' offset 0,0.4\n"
           "set title 'beside the turntable (times in s)'; set ylabel 'y (m)' offset 1.5,0\n"
        << numbers_line << "set label 'starting place' at 0,-0.55 center tc rgb '" << colors::vermilion << "'\n"
        << "plot '-' w l lw 2 lc rgb '" << colors::grey << "', '-' w l lw 3 dt 3 lc rgb '" << colors::vermilion
        << "', '-' w l lw 4 lc rgb '" << colors::blue << "', '-' w p pt 7 ps 1.2 lc rgb '" << colors::black << "'\n";
    gnuplot.send1d(rim);
    gnuplot.send1d(chalk);
    gnuplot.send1d(line);
    gnuplot.send1d(line_marks);
    gnuplot << "unset label; set title 'riding on it (times in s)'; unset ylabel\n"
            << numbers_curve << "plot '-' w l lw 2 lc rgb '" << colors::grey << "', '-' w l lw 4 dt (4,2) lc rgb '"
            << colors::blue << "', '-' w p pt 7 ps 1.2 lc rgb '" << colors::black << "'\n";
    gnuplot.send1d(rim);
    gnuplot.send1d(curve);
    gnuplot.send1d(curve_marks);
    gnuplot << "unset multiplot\n";
  });
}

/// How far to its right a shell lands that flies `range` in `time` in the given direction, to first order in the
/// Earth's rate.
double drift_to_the_right(double latitude, double azimuth, double range, double time) {
  const double g = 9.81;
  const Vector3d forward(std::sin(azimuth), std::cos(azimuth), 0);
  const Vector3d right(std::cos(azimuth), -std::sin(azimuth), 0);
  return boost::math::quadrature::gauss<double, 7>::integrate(
      [&](double t) {
        const Vector3d velocity = range / time * forward + g * (time / 2 - t) * Vector3d::UnitZ();
        return (time - t) * coriolis_acceleration(velocity, latitude, earth_rate).dot(right);
      },
      0.0, time);
}

/// Three effects of one rotation, from pole to pole.
void draw_over_latitude(const std::filesystem::path& directory) {
  Curve fall, pendulum, northward, southward;
  for (int k = -90; k <= 90; ++k) {
    const double latitude = k * degree;
    fall.emplace_back(k, 1e3 * eastward_deflection(110, latitude, 9.81, earth_rate));
    // The contract speaks of the northern hemisphere; south of the equator the plane turns the other way.
    const double hours = k == 0 ? INFINITY : foucault_period(std::abs(latitude), sidereal_day) / 3600;
    pendulum.emplace_back(k, std::copysign(360 / hours, latitude));
    northward.emplace_back(k, 1e-3 * drift_to_the_right(latitude, 0, 120e3, 176));
    southward.emplace_back(k, 1e-3 * drift_to_the_right(latitude, pi, 120e3, 176));
  }
  workbook::draw_figure(directory, "over_latitude", {720, 760}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set multiplot layout 3,1 margins 0.13,0.97,0.09,0.955 spacing 0.075\n"
               "unset key; set xrange [-90:90]; set xtics 30 format ''; set xzeroaxis lw 1.5 lc rgb '#444444'\n"
               "set arrow from first 0, graph 0 to first 0, graph 1 nohead lw 1.5 lc rgb '#444444'\n"
               "set ylabel 'mm'; set yrange [0:30]; set ytics 10\n"
               "set title 'stone from 110 m: landing to the east' offset 0,-0.6\n"
            << "plot '-' w l lw 4 lc rgb '" << colors::blue << "'\n";
    gnuplot.send1d(fall);
    gnuplot << "set ylabel '° per hour'; set yrange [-16:16]; set ytics 5\n"
               "set title 'Foucault pendulum: turn, clockwise counted positive' offset 0,-0.6\n"
            << "plot '-' w l lw 4 lc rgb '" << colors::green << "'\n";
    gnuplot.send1d(pendulum);
    gnuplot << "set ylabel 'km'; set yrange [-2.2:2.2]; set ytics 1; set xtics 30 format '%g'; set xlabel 'latitude "
               "(degrees), north positive'\n"
               "set title 'shell, 120 km in 176 s: landing to the right' offset 0,-0.6\n"
            << "set label 'fired south' at -6,0.75 right tc rgb '" << colors::vermilion << "'\n"
            << "set label 'fired north' at 12,-0.95 left tc rgb '" << colors::purple << "'\n"
            << "plot '-' w l lw 4 lc rgb '" << colors::purple << "', '-' w l lw 4 dt (4,2) lc rgb '"
            << colors::vermilion << "'\n";
    gnuplot.send1d(northward);
    gnuplot.send1d(southward);
    gnuplot << "unset multiplot\n";
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv, {{"puck_on_turntable", draw_puck}, {"over_latitude", draw_over_latitude}});
}
