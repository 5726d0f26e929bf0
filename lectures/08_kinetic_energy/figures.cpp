// Figures of lecture 08.
#include "lectures/support/figure.hpp"

#include <rigid/kinetic_energy.hpp>

#include <fmt/format.h>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace rigid;

namespace {

constexpr double pi = std::numbers::pi;

using PlaneCurve = std::vector<std::pair<double, double>>;
using SpaceCurve = std::vector<std::tuple<double, double, double>>;

/// Free motion in Euler angles at equal steps of time: the angles, column by column.
Matrix3Xd free_motion(const Vector3d& I, const Vector3d& angles, const Vector3d& rates, double step, int count) {
  using Numbers = std::array<double, 6>;
  Numbers x;
  Vector3d::Map(x.data()) = angles;
  Vector3d::Map(x.data() + 3) = rates;
  const auto system = [&I](const Numbers& now, Numbers& rate, double) {
    const Vector3d q = Vector3d::Map(now.data()), v = Vector3d::Map(now.data() + 3);
    Vector3d::Map(rate.data()) = v;
    Vector3d::Map(rate.data() + 3) = euler_angle_accelerations(I, q, v);
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<Numbers> stepper;
  Matrix3Xd path(3, count + 1);
  for (int k = 0; k <= count; ++k) {
    path.col(k) = Vector3d::Map(x.data());
    stepper.do_step(system, x, 0.0, step);
  }
  return path;
}

/// Euler angles of a body with the given ω̃ when L points up, and their rates.
std::pair<Vector3d, Vector3d> with_vertical_momentum(const Vector3d& I, const Vector3d& omega) {
  const Vector3d L = I.cwiseProduct(omega);
  const double theta = std::acos(L[2] / L.norm()), psi = std::atan2(L[1], -L[0]);
  const double phi_rate = (-omega[0] * std::cos(psi) + omega[1] * std::sin(psi)) / std::sin(theta);
  return {Vector3d(0, theta, psi), Vector3d(phi_rate, omega[0] * std::sin(psi) + omega[1] * std::cos(psi),
                                            omega[2] - phi_rate * std::cos(theta))};
}

void draw_blindness(const std::filesystem::path& directory) {
  const Vector3d rates(1.5, 0.8, 0.4);
  workbook::draw_figure(directory, "blind_to_convention", {720, 470}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'ψ (degrees)'; set ylabel 'T (J)'; set xrange [0:360]; set xtics 90; set yrange [4.1:5.5]; "
               "unset key\n";
    PlaneCurve right, mistaken, symmetric, symmetric_mistaken;
    for (int degrees = 0; degrees <= 360; degrees += 5) {
      const Vector3d q(0.3, 0.7, degrees * pi / 180);
      right.emplace_back(degrees, kinetic_energy_euler(Vector3d(1, 2, 3), q, rates));
      mistaken.emplace_back(degrees, kinetic_energy_euler(Vector3d(2, 1, 3), q, rates));  // what z–x–z angles give
      symmetric.emplace_back(degrees, kinetic_energy_euler(Vector3d(1.5, 1.5, 3), q, rates));
      if (degrees % 30 == 0) symmetric_mistaken.push_back(symmetric.back());
    }
    const auto label = [&](const char* text, double x, double y, const char* color) {
      gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
    };
    label("I = (1, 2, 3), z–y–z", 62, 5.25, workbook::colors::blue);
    label("the same, read as z–x–z", 235, 4.28, workbook::colors::vermilion);
    label("flat: I = (1.5, 1.5, 3), either way", 232, 5.38, workbook::colors::black);
    gnuplot << fmt::format(
        "plot '-' w l lw 4 lc rgb '{}', '-' w l lw 3 dt 2 lc rgb '{}', '-' w l lw 3 lc rgb '{}', '-' w p pt 6 ps 1.4 "
        "lw 2 lc rgb '{}'\n",
        workbook::colors::blue, workbook::colors::vermilion, workbook::colors::black, workbook::colors::black);
    gnuplot.send1d(right);
    gnuplot.send1d(mistaken);
    gnuplot.send1d(symmetric);
    gnuplot.send1d(symmetric_mistaken);
  });
}

void draw_free_top(const std::filesystem::path& directory) {
  const auto track = [](const Vector3d& I, const Vector3d& omega, double duration) {
    const auto [angles, rates] = with_vertical_momentum(I, omega);
    const int count = 900;
    const Matrix3Xd path = free_motion(I, angles, rates, duration / count, count);
    SpaceCurve curve;
    for (const auto& q : path.colwise()) {
      curve.emplace_back(std::sin(q[1]) * std::cos(q[0]), std::sin(q[1]) * std::sin(q[0]), std::cos(q[1]));
    }
    return curve;
  };
  // Two bodies whose third axis starts at the same inclination.
  const SpaceCurve asymmetric = track(Vector3d(1, 1.8, 2.2), Vector3d(0.8, 0, 1.2), 11.5);
  const SpaceCurve symmetric = track(Vector3d(1.4, 1.4, 2.2), Vector3d(0.8 / 1.4, 0, 1.2), 4);

  workbook::draw_figure(directory, "free_top", {720, 520}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; unset border; unset tics; unset grid\n"
               "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
               "set view 48, 40, 2.15; set view equal xyz\n"
               "set xrange [-1.05:1.05]; set yrange [-1.05:1.05]; set zrange [0.15:1.5]\n"
               "set parametric; set isosamples 13,25; set urange [0:2*pi]; set vrange [0:1.2]; unset hidden3d\n";
    gnuplot << fmt::format("set arrow from 0,0,1 to 0,0,1.42 front lw 4 lc rgb '{}'\n", workbook::colors::purple)
            << fmt::format("set label '{{/:Bold L}}' at 0.08,0,1.42 front tc rgb '{}'\n", workbook::colors::purple)
            << fmt::format("set label 'I = (1, 1.8, 2.2): precesses and nods' at screen 0.04,0.95 front tc rgb '{}'\n",
                           workbook::colors::blue)
            << fmt::format("set label 'I = (1.4, 1.4, 2.2): only precesses' at screen 0.04,0.88 front tc rgb '{}'\n",
                           workbook::colors::vermilion);
    gnuplot << fmt::format(
        "splot cos(u)*sin(v),sin(u)*sin(v),cos(v) w l lw 0.7 lc rgb '#D0D0D0', '-' w l lw 2.5 lc rgb '{}', '-' w l lw "
        "4 dt 2 lc rgb '{}'\n",
        workbook::colors::blue, workbook::colors::vermilion);
    gnuplot.send1d(asymmetric);
    gnuplot.send1d(symmetric);
  });
}

void draw_effective_potential(const std::filesystem::path& directory) {
  // The heavy top of the worked examples, held at 30° with 200 rad/s of spin and let go; and the same with less spin.
  const double I1 = 3.28e-4, I3 = 6.6e-5, weight = 0.0456, start = pi / 6;

  workbook::draw_figure(directory, "effective_potential", {720, 470}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'θ (degrees)'; set ylabel 'V_{eff} − V_{eff}(30°)  (mJ)'\n"
               "set xrange [20:70]; set yrange [-5:7]; unset key\n";
    const std::array<double, 3> spins = {200, 150, 110};
    const std::array<const char*, 3> colors = {workbook::colors::blue, workbook::colors::green,
                                               workbook::colors::vermilion};
    const std::array<std::pair<double, double>, 3> places = {{{38.5, 5.8}, {48.8, 4.1}, {55.5, -1.8}}};
    std::vector<PlaneCurve> curves, allowed;
    std::string plot = fmt::format("plot 0 lc rgb '{}' lw 1.5", workbook::colors::grey);
    for (std::size_t k = 0; k < spins.size(); ++k) {
      const Vector3d I(I1, I1, I3);
      const Vector3d p = canonical_momenta(I, Vector3d(0, start, 0), Vector3d(0, 0, spins[k]));
      const auto potential = [&](double theta) {
        const double across = (p[0] - p[2] * std::cos(theta)) / std::sin(theta);
        return 1e3 * (across * across / (2 * I1) + weight * (std::cos(theta) - std::cos(start)));
      };
      PlaneCurve curve, between;
      for (int tenths = 200; tenths <= 700; ++tenths) {
        const double degrees = tenths / 10.0;
        curve.emplace_back(degrees, potential(degrees * pi / 180));
        if (curve.back().second <= 0 && degrees >= 30) between.emplace_back(degrees, 0);
      }
      curves.push_back(curve);
      allowed.push_back({between.front(), between.back()});
      gnuplot << fmt::format("set label '{} rad/s' at {},{} center front tc rgb '{}'\n", spins[k], places[k].first,
                             places[k].second, colors[k]);
      plot += fmt::format(", '-' w l lw 3.5 dt {} lc rgb '{}', '-' w p pt 7 ps 1.4 lc rgb '{}'", k + 1, colors[k],
                          colors[k]);
    }
    gnuplot << fmt::format("set label 'energy' at 23.5,-0.55 center tc rgb '{}'\n", workbook::colors::grey);
    gnuplot << plot << "\n";
    for (std::size_t k = 0; k < spins.size(); ++k) {
      gnuplot.send1d(curves[k]);
      gnuplot.send1d(allowed[k]);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"blind_to_convention", draw_blindness},
                                 {"free_top", draw_free_top},
                                 {"effective_potential", draw_effective_potential}});
}
