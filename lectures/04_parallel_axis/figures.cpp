// Figures of lecture 04.
#include "lectures/support/sketch.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/parallel_axis.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;
using gnuplotio::Gnuplot;

namespace {

void label(Gnuplot& gnuplot, const std::string& text, double x, double y, const char* color) {
  gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
}

/// Two origins, the centre of mass and one point of the body.
void draw_origins(const std::filesystem::path& directory) {
  Sketch sketch;
  const Vector3d O(0.75, -0.1, 0), O_new(-1.6, -0.5, 0), center(2.05, 0.4, 0), p(1.6, 1.4, 0);
  std::vector<Vector3d> body;
  for (int i = 0; i <= 90; ++i) {
    const double angle = 2 * pi * i / 90, radius = 1 + 0.12 * std::cos(2 * angle - 1) + 0.09 * std::cos(3 * angle);
    body.push_back(center + radius * Vector3d(1.75 * std::cos(angle), 1.35 * std::sin(angle), 0));
  }
  sketch.face(body, colors::grey, 0.15);
  sketch.line(body, colors::grey, 1.5);
  const auto vector = [&](const Vector3d& from, const Vector3d& to, const char* color, const char* name, Side side) {
    sketch.arrow(from, to, color);
    sketch.text(0.5 * (from + to), name, color, side);
  };
  vector(O_new, O, colors::vermilion, "{/:Bold R}", Side::below);
  vector(O, p, colors::blue, "{/:Bold r}", Side::right);
  vector(O_new, p, colors::green, "{/:Bold r}′ = {/:Bold r} + {/:Bold R}", Side::left);
  vector(O, center, colors::grey, "{/:Bold r}_{CM}", Side::below);
  sketch.dot(O, colors::black);
  sketch.text(O, "O", colors::black, Side::below);
  sketch.dot(O_new, colors::black);
  sketch.text(O_new, "O′", colors::black, Side::left);
  sketch.dot(center, colors::grey);
  sketch.text(center, "CM", colors::grey, Side::right);
  sketch.dot(p, colors::black);
  sketch.text(p, "p", colors::black, Side::right);
  sketch.draw(directory, "origins", 560);
}

/// A ruler on a nail, and its period for every place of the nail.
void draw_pendulum(const std::filesystem::path& directory) {
  const double g = 9.81, d0 = 1 / std::sqrt(12.0);
  const auto period = [&](double d) { return 2 * pi * std::sqrt((d0 * d0 + d * d) / (g * d)); };
  const double d = 0.42;
  Sketch ruler;
  const Vector3d along(std::sin(0.2), -std::cos(0.2), 0), across(along.y(), -along.x(), 0);
  const auto at = [&](double from_center, double aside) -> Vector3d {
    return from_center * along + 0.045 * aside * across;
  };
  const std::vector<Vector3d> outline{at(-0.5, 1), at(0.5, 1), at(0.5, -1), at(-0.5, -1), at(-0.5, 1)};
  ruler.face(outline, colors::grey, 0.2);
  ruler.line(outline, colors::black);
  ruler.line({at(-d, 0), Vector3d(at(-d, 0) - 0.75 * y_axis)}, colors::grey, 1, "dt (4,4)");
  ruler.dot(at(-d, 0), colors::black, 1);
  ruler.text(at(-d, 1.6), "nail", colors::black, Side::left);
  ruler.dot(at(0, 0), colors::grey, 1);
  ruler.text(at(0, 1), "CM", colors::grey, Side::left);
  ruler.text(at(-d / 2, -1), "d", colors::blue, Side::right);
  ruler.dot(at(d0 * d0 / d, 0), colors::vermilion, 1);
  ruler.text(at(d0 * d0 / d, -1), "d_0^2/d", colors::vermilion, Side::right);

  draw_figure(directory, "pendulum", {590, 340}, [&](Gnuplot& gnuplot) {
    gnuplot << "set multiplot\nset origin 0,0; set size 0.3,1\n";
    ruler.send(gnuplot, {180, 340}, 0.34);
    gnuplot << "unset label; unset arrow\nset origin 0.3,0; set size 0.7,1\n"
               "set border; set tics; set grid\nset lmargin 8; set rmargin 2; set tmargin 1; set bmargin 3.5\n"
               "set xlabel 'd, from the nail to the centre of mass (m)'; set ylabel 'period (s)'\n"
               "set xrange [0:0.52]; set yrange [1.4:2.6]; set xtics 0.1; set ytics 0.2\n"
            << fmt::format("set arrow from {0},{2} to {1},{2} nohead lw 1.5 dt (5,4) lc rgb '{3}'\n", d0 * d0 / 0.5,
                           0.5, period(0.5), colors::vermilion)
            << fmt::format("set arrow from {0},1.4 to {0},{1} nohead lw 1.5 dt (5,4) lc rgb '{2}'\n", d0, period(d0),
                           colors::grey);
    label(gnuplot, "the same period", 1 / 3.0, period(0.5) + 0.07, colors::vermilion);
    label(gnuplot, "d_0", d0 + 0.02, 1.45, colors::grey);
    PlaneCurve curve;
    for (int k = 12; k <= 200; ++k) curve.emplace_back(k / 400.0, period(k / 400.0));
    send_block(gnuplot, "$periods", curve);
    send_block(gnuplot, "$same", PlaneCurve{{d0 * d0 / 0.5, period(0.5)}, {0.5, period(0.5)}});
    gnuplot << fmt::format("plot $periods w l lw 3 lc rgb '{}', $same w p pt 7 ps 1.2 lc rgb '{}'\n", colors::blue,
                           colors::vermilion)
            << "unset multiplot\n";
  });
}

/// The block of the next two figures: 6 kg, edges in metres.
struct Block {
  double M = 6;
  Vector3d edges{1, 2, 3};

  Matrix3d at_center() const { return cuboid_about_center(M, edges.x(), edges.y(), edges.z()); }
  Matrix3d at_corner() const { return cuboid_about_corner(M, edges.x(), edges.y(), edges.z()); }
};

void draw_along_the_diagonal(const std::filesystem::path& directory) {
  const Block block;
  const Matrix3d corner = block.at_corner();
  draw_figure(directory, "origin_on_the_diagonal", {590, 400}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'new origin on the diagonal (0: corner, ½: centre)'\n"
               "set ylabel 'entry of I (kg m²)'\n"
               "set xrange [-0.25:1.25]; set yrange [-25:65]; unset key; set xtics 0.25\n";
    PlaneCurve xx, yz, mistaken, reversed;
    for (int k = 0; k <= 150; ++k) {
      const double s = -0.25 + 0.01 * k;
      const Vector3d R = -s * block.edges;
      const Matrix3d I = inertia_about_shifted_origin(corner, block.M, block.edges / 2, R);
      xx.emplace_back(s, I(0, 0));
      yz.emplace_back(s, I(1, 2));
      mistaken.emplace_back(s, inertia_from_center_of_mass(corner, block.M, R)(0, 0));
      reversed.emplace_back(s, inertia_about_shifted_origin(corner, block.M, block.edges / 2, -R)(0, 0));
    }
    label(gnuplot, "I_{xx}", 1.1, 25, colors::blue);
    label(gnuplot, "I_{yz}", 1.1, -8, colors::green);
    label(gnuplot, "I_{xx}, {/:Bold R} reversed", 0.1, 57, colors::vermilion);
    label(gnuplot, "I_{xx} without {/:Bold r}_{CM}", 0.95, 57, colors::purple);
    gnuplot << fmt::format(
        "plot 0 lc rgb '{}' lw 1, '-' w l lw 3.5 lc rgb '{}', '-' w l lw 3.5 lc rgb '{}', '-' w l lw 2.5 dt (10,5) lc "
        "rgb '{}', '-' w l lw 2.5 dt (3,4) lc rgb '{}', '-' w p pt 7 ps 1.2 lc rgb '{}'\n",
        colors::grey, colors::blue, colors::green, colors::vermilion, colors::purple, colors::black);
    gnuplot.send1d(xx);
    gnuplot.send1d(yz);
    gnuplot.send1d(reversed);
    gnuplot.send1d(mistaken);
    gnuplot.send1d(PlaneCurve{{0, corner(0, 0)}, {0.5, block.at_center()(0, 0)}});
  });
}

/// The inertia ellipsoid about a point, with its axes and moments.
void draw_ellipsoid(Sketch& sketch, const Matrix3d& I, const Vector3d& center, const char* color,
                    const std::array<Side, 3>& sides, const Vector3d& signs,
                    const Eigen::Matrix<double, 2, 3>& away = Eigen::Matrix<double, 2, 3>::Zero()) {
  const double size = 2.6;
  const Vector3d moments = principal_moments(I), half_axes = size * moments.cwiseSqrt().cwiseInverse();
  Matrix3d axes = principal_axes(I);
  // An axis has no sign of its own: here the largest component has the one that is asked for.
  for (int i = 0; i < 3; ++i) {
    Eigen::Index largest = 0;
    axes.col(i).cwiseAbs().maxCoeff(&largest);
    axes.col(i) *= signs[i] * (axes(largest, i) > 0 ? 1 : -1);
  }
  sketch.ellipsoid(axes * half_axes.asDiagonal(), color, center);
  for (int i = 0; i < 3; ++i) {
    const Vector3d tip = (half_axes[i] + 0.9) * axes.col(i);
    sketch.line({center - tip, center + tip}, color, 2.5);
    sketch.text(center + tip, fmt::format("I_{} = {:.3g}", i + 1, moments[i]), color,
                sides[static_cast<std::size_t>(i)], away.col(i));
  }
  sketch.dot(center, color, 0.9);
}

void draw_corner_and_center(const std::filesystem::path& directory) {
  const Block block;
  Sketch sketch({1.0, 0.62, 0.5});
  // Side by side.
  const Vector3d aside = 4.4 * sketch.right();
  for (const Vector3d& corner : {origin, aside}) {
    sketch.box(corner, block.edges.asDiagonal());
    sketch.text(corner + Vector3d(0.5, 2, 0), "a", colors::black, Side::right);
    sketch.text(corner + Vector3d(1, 1, 0), "b", colors::black, Side::below);
    sketch.text(corner + Vector3d(1, 0, 1.5), "c", colors::black, Side::left);
  }
  Eigen::Matrix<double, 2, 3> of_center, of_corner;  // to where the labels stand outside of the block
  of_center << 0, 0, -0.3, 0, 0, -0.6;
  of_corner << -1.5, 0, 0, 0.5, 0, 0;
  draw_ellipsoid(sketch, block.at_center(), block.edges / 2, colors::blue, {Side::above, Side::right, Side::left},
                 {1, 1, 1}, of_center);
  draw_ellipsoid(sketch, block.at_corner(), aside, colors::vermilion, {Side::left, Side::right, Side::left}, {1, 1, 1},
                 of_corner);
  sketch.draw(directory, "corner_and_center", 590, false);
}

/// The door wedge of the worked example, with its principal axes; lengths in centimetres.
void draw_wedge(const std::filesystem::path& directory) {
  const double a = 12, b = 4, c = 3;
  const double Ixx = b * b / 18 + c * c / 12, Iyy = a * a / 18 + c * c / 12, Ixy = a * b / 36;
  const double tilt = 0.5 * std::atan(2 * Ixy / (Ixx - Iyy));
  Sketch sketch;
  const std::vector<Vector3d> corners{{0, 0, 0}, {a, 0, 0}, {0, b, 0}, {0, 0, 0}};
  sketch.face(corners, colors::grey, 0.2);
  sketch.line(corners, colors::black);
  const Vector3d center(a / 3, b / 3, 0), first(std::cos(tilt), std::sin(tilt), 0), second(-first.y(), first.x(), 0);
  sketch.line({center - 4.6 * x_axis, center + 8.6 * x_axis}, colors::grey, 1, "dt (4,4)");
  sketch.arrow(center - 2.9 * first, center + 8.6 * first, colors::orange, "{/:Bold e}_1", Side::right);
  sketch.arrow(center - 2.2 * second, center + 3.4 * second, colors::green, "{/:Bold e}_2", Side::right);
  sketch.line(arc(center, 6, x_axis, y_axis, tilt, 0), colors::black, 1.5);
  sketch.text(center + 6.45 * Vector3d(std::cos(tilt / 2), std::sin(tilt / 2), 0), "α");
  sketch.dot(center, colors::black);
  sketch.text({a / 2, 0, 0}, "a", colors::black, Side::below);
  sketch.text({0, b / 2, 0}, "b", colors::black, Side::left);
  sketch.draw(directory, "wedge", 560);
}

/// The T-handle of the worked example; lengths in centimetres.
void draw_handle(const std::filesystem::path& directory) {
  Sketch sketch({0.45, -0.3, 1.0}, y_axis);
  const auto part = [&](const Vector3d& center, const Vector3d& edges) {
    sketch.solid_box(center, (edges / 2).asDiagonal(), {colors::grey, colors::grey, colors::grey});
  };
  part({0, -3.1, 0}, {1.2, 5, 1.2});
  part({0, 0, 0}, {10, 1.2, 1.2});
  const Vector3d center(0, -1.04, 0);
  sketch.arrow(center, center + 6.6 * x_axis, colors::orange, "I_1", Side::right);
  sketch.arrow(center, center + 3.6 * y_axis, colors::green, "I_2", Side::right);
  sketch.arrow(center, center + 8.5 * z_axis, colors::purple, "I_3", Side::left);
  sketch.dot(center, colors::black);
  sketch.draw(directory, "handle", 480);
}

/// A disc with a bead on its rim rolls to +x; z points up. The origin is the middle of the disc, which moves evenly.
void draw_moving_origin(const std::filesystem::path& directory) {
  const double disc = 1, bead = 1, radius = 1, speed = 1, M = disc + bead;
  const Vector3d v_origin(speed, 0, 0), omega(0, speed / radius, 0);
  const auto bead_at = [&](double angle) -> Vector3d {
    return radius * Vector3d(-std::sin(angle), 0, -std::cos(angle));
  };
  const FigureSize size{590, 430};
  draw_figure(directory, "moving_origin", size, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'angle of the wheel (degrees)'; set ylabel 'energy (J)'\n"
               "set xrange [0:360]; set yrange [-1.4:3.3]; set xtics 90; set ytics 1; unset key\n"
               "set lmargin at screen 0.1; set rmargin at screen 0.93\n"
               "set bmargin at screen 0.17; set tmargin at screen 0.8\n";
    // The wheel above its angles.
    for (int degrees = 0; degrees <= 360; degrees += 90) {
      const double wheel = 0.04, x = 0.1 + 0.83 * degrees / 360, y = 0.9;
      const Vector3d place = bead_at(degrees * pi / 180);
      gnuplot << fmt::format(
                     "set object circle at screen {:.4f},{:.4f} size screen {} fs empty border lc rgb '{}' lw 2\n", x,
                     y, wheel, colors::grey)
              << fmt::format("set label '' at screen {:.4f},{:.4f} point pt 7 ps 1.3 lc rgb '{}'\n",
                             x + wheel * place.x(), y + wheel * place.z() * size.width / size.height,
                             colors::vermilion);
    }
    PlaneCurve rotation, mixed, translation, total, by_points;
    for (int k = 0; k <= 72; ++k) {
      const double degrees = 5.0 * k;
      const Vector3d place = bead_at(degrees * pi / 180), r_cm = bead / M * place;
      const Matrix3d I = disc * radius * radius / 4 * Matrix3d(Vector3d(1, 2, 1).asDiagonal()) +
                         inertia_of_points(VectorXd{{bead}}, place);
      rotation.emplace_back(degrees, kinetic_energy(I, omega));
      mixed.emplace_back(degrees, M * v_origin.dot(omega.cross(r_cm)));
      translation.emplace_back(degrees, 0.5 * M * v_origin.squaredNorm());
      total.emplace_back(degrees, rotation.back().second + mixed.back().second + translation.back().second);
      if (k % 6 != 0) continue;
      // Each point on its own: the bead, and the disc as two rings of equal mass.
      double energy = 0.5 * bead * (v_origin + omega.cross(place)).squaredNorm();
      for (int i = 0; i < 24; ++i) {
        const double around = 2 * pi * i / 12, distance = radius * std::sqrt(i < 12 ? 0.25 : 0.75);
        const Vector3d point(distance * std::sin(around), 0, distance * std::cos(around));
        energy += 0.5 * disc / 24 * (v_origin + omega.cross(point)).squaredNorm();
      }
      by_points.emplace_back(degrees, energy);
    }
    label(gnuplot, "whole energy", 180, 2.98, colors::black);
    label(gnuplot, "½ M v_O^2", 180, 1.19, colors::green);
    label(gnuplot, "½ {/:Bold ω}·I·{/:Bold ω}", 54, 0.53, colors::blue);
    label(gnuplot, "mixed term", 180, 0.35, colors::vermilion);
    gnuplot << fmt::format(
        "plot 0 lc rgb '{}' lw 1, '-' w l lw 2.5 lc rgb '{}', '-' w l lw 2.5 lc rgb '{}', '-' w l lw 2.5 lc "
        "rgb '{}', '-' w l lw 3.5 lc rgb '{}', '-' w p pt 6 ps 1.4 lw 2 lc rgb '{}'\n",
        colors::grey, colors::blue, colors::green, colors::vermilion, colors::black, colors::orange);
    for (const PlaneCurve& curve : {rotation, translation, mixed, total, by_points}) gnuplot.send1d(curve);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"origins", draw_origins},
                       {"pendulum", draw_pendulum},
                       {"origin_on_the_diagonal", draw_along_the_diagonal},
                       {"corner_and_center", draw_corner_and_center},
                       {"wedge", draw_wedge},
                       {"handle", draw_handle},
                       {"moving_origin", draw_moving_origin}});
}
