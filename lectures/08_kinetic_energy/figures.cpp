// Figures of lecture 08.
#include "lectures/support/motion.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/euler_angles.hpp>
#include <rigid/kinetic_energy.hpp>

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;
using gnuplotio::Gnuplot;

namespace {

/// The direction of the body's third axis.
Vector3d axis_at(const Vector3d& angles) { return inertial_components(z_axis, angles); }

SpaceCurve path_of_axis(const std::vector<AngleMotion>& states) {
  SpaceCurve path;
  for (const AngleMotion& state : states) path.push_back(axis_at(state.angles));
  return path;
}

// ---- energy and momenta ----

void draw_convention(const std::filesystem::path& directory) {
  const Vector3d rates(5, -2, 9);
  const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3), exchanged(racket[1], racket[0], racket[2]);
  const Vector3d symmetric(8.795e-3, 8.795e-3, 17.48e-3);
  draw_figure(directory, "convention", {590, 380}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'ψ (degrees)'; set ylabel 'T (J)'; set xrange [0:360]; set xtics 90; set yrange [1.42:1.6]\n"
               "unset key\n";
    PlaneCurve right, mistaken, flat;
    for (int degrees = 0; degrees <= 360; degrees += 3) {
      const Vector3d q(0.3, 0.7, degrees * degree);
      right.emplace_back(degrees, kinetic_energy_euler(racket, q, rates));
      mistaken.emplace_back(degrees, kinetic_energy_euler(exchanged, q, rates));
      flat.emplace_back(degrees, kinetic_energy_euler(symmetric, q, rates));
    }
    const auto label = [&](const char* text, double x, double y, const char* color) {
      gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
    };
    // Each beside its curve.
    label("racket, z–y–z", 121, 1.568, colors::blue);
    label("racket, z–x–z", 212, 1.568, colors::vermilion);
    label("symmetric top, either", 290, 1.432, colors::black);
    gnuplot << fmt::format("set arrow from 275,1.438 to 266,1.4985 head filled front lc rgb '{}'\n", colors::black);
    gnuplot << fmt::format(
        "plot '-' w l lw 3.5 lc rgb '{}', '-' w l lw 3 dt (10,5) lc rgb '{}', '-' w l lw 3 lc rgb '{}'\n", colors::blue,
        colors::vermilion, colors::black);
    gnuplot.send1d(right);
    gnuplot.send1d(mistaken);
    gnuplot.send1d(flat);
  });
}

/// L and its projections on the three axes of the rates.
void draw_projections(const std::filesystem::path& directory) {
  Sketch sketch({-0.1, 1.0, 0.45});
  const double phi = 40 * degree, theta = 50 * degree;
  const Vector3d angles(phi, theta, 0);
  const Vector3d nodes(-std::sin(phi), std::cos(phi), 0), spin = axis_at(angles);
  const Vector3d L = 1.15 * z_axis + 0.25 * spin + 1.0 * nodes - 0.25 * nodes.cross(z_axis);
  struct Axis {
    Vector3d direction;
    const char *color, *name, *momentum;
    Side name_side, side;
  };
  for (const Axis& axis : {Axis{z_axis, colors::black, vertical_name, "p_φ", Side::left, Side::right},
                           Axis{nodes, colors::green, "{/:Bold e}_2′", "p_θ", Side::below, Side::below},
                           Axis{spin, colors::purple, "{/:Bold e}_3", "p_ψ", Side::left, Side::below}}) {
    const Vector3d foot = L.dot(axis.direction) * axis.direction;
    sketch.line({L, foot}, colors::grey, 1.2, "dt (4,4)");
    sketch.arrow(origin, 1.75 * axis.direction, axis.color, axis.name, axis.name_side, 1.5);
    sketch.line({origin, foot}, axis.color, 5);
    sketch.dot(foot, axis.color, 0.8);
    sketch.text(0.4 * foot, axis.momentum, axis.color, axis.side);
  }
  sketch.arrow(origin, L, colors::blue, "{/:Bold L}", Side::above, 4);
  sketch.line(arc(origin, 0.35, z_axis, (spin - spin.z() * z_axis).normalized(), 0, theta), colors::black, 1.5);
  sketch.text(0.47 * (z_axis + spin).normalized(), "θ");
  sketch.draw(directory, "projections", 460);
}

// ---- free bodies ----

void draw_free_top(const std::filesystem::path& directory) {
  const auto track = [](const Vector3d& I, const Vector3d& omega, double duration) {
    const Vector3d L = I.cwiseProduct(omega);
    const Vector3d angles(0, std::acos(L[2] / L.norm()), std::atan2(L[1], -L[0]));
    return path_of_axis(
        history({angles, euler_angle_rates(angles, omega)}, duration, 601,
                [&](const Vector3d& q, const Vector3d& v) { return euler_angle_accelerations(I, q, v); }));
  };
  Sketch sketch({0.3, -1.0, 1.15});
  sketch.ellipsoid(Matrix3d::Identity(), colors::sky);
  for (int polar = 15; polar <= 60; polar += 15) {
    const double z = std::cos(polar * degree), radius = std::sin(polar * degree);
    sketch.line(arc(z * z_axis, radius, x_axis, y_axis), colors::grey, 1);
    const Vector3d at = z * z_axis + radius * Vector3d(0.9, -0.43, 0);
    sketch.text(at, fmt::format("{}°", polar), colors::grey, Side::right, {1.02 - at.dot(sketch.right()), 0.12});
  }
  // Two bodies whose third axis starts at the same inclination.
  const SpaceCurve asymmetric = track(Vector3d(1, 1.8, 2.2), Vector3d(0.8, 0, 1.2), 11.5);
  const SpaceCurve symmetric = track(Vector3d(1.4, 1.4, 2.2), Vector3d(0.8 / 1.4, 0, 1.2), 3.2);
  sketch.line(asymmetric, colors::purple, 2.5);
  sketch.line(symmetric, colors::green, 3.5);
  sketch.dot(asymmetric.front(), colors::black, 0.9);
  sketch.arrow(origin, 1.75 * z_axis, colors::blue, "{/:Bold L}", Side::right);
  sketch.draw(directory, "free_top", 480, false);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(
      argc, argv, {{"convention", draw_convention}, {"projections", draw_projections}, {"free_top", draw_free_top}});
}
