// Figures of lecture 04.
#include "lectures/support/figure.hpp"

#include <rigid/inertia_tensor.hpp>
#include <rigid/parallel_axis.hpp>

#include <fmt/format.h>

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

using SpaceCurve = std::vector<std::tuple<double, double, double>>;
using PlaneCurve = std::vector<std::pair<double, double>>;

/// The cuboid of the worked examples.
struct Box {
  double M = 6;
  Vector3d edges{1, 2, 3};

  Matrix3d at_center() const { return cuboid_about_center(M, edges.x(), edges.y(), edges.z()); }
  Matrix3d at_corner() const { return cuboid_about_corner(M, edges.x(), edges.y(), edges.z()); }
};

SpaceCurve line(const Vector3d& from, const Vector3d& to) {
  return {{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}};
}

std::vector<SpaceCurve> wire_frame(const Vector3d& edges) {
  std::vector<SpaceCurve> lines;
  for (int corner = 0; corner < 8; ++corner) {
    const auto position = [&](int bits) -> Vector3d {
      return edges.cwiseProduct(Vector3d((bits & 1) ? 1 : 0, (bits & 2) ? 1 : 0, (bits & 4) ? 1 : 0));
    };
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) lines.push_back(line(position(corner), position(corner | 1 << axis)));
    }
  }
  return lines;
}

/// The surface around `center` that n/√(n·I·n) traces for all directions n, drawn as its cuts with the principal
/// planes.
std::vector<SpaceCurve> ellipsoid(const Matrix3d& I, const Vector3d& center, double size) {
  const Vector3d moments = principal_moments(I);
  const Matrix3d axes = principal_axes(I);
  std::vector<SpaceCurve> circles;
  for (int skip = 0; skip < 3; ++skip) {
    const int i = (skip + 1) % 3, j = (skip + 2) % 3;
    SpaceCurve circle;
    for (int k = 0; k <= 72; ++k) {
      const double angle = 2 * pi * k / 72;
      const Vector3d p = center + size * (std::cos(angle) / std::sqrt(moments[i]) * axes.col(i) +
                                          std::sin(angle) / std::sqrt(moments[j]) * axes.col(j));
      circle.emplace_back(p.x(), p.y(), p.z());
    }
    circles.push_back(circle);
  }
  return circles;
}

void draw_corner_and_center(const std::filesystem::path& directory) {
  const Box box;
  const double size = 2.6;
  workbook::draw_figure(directory, "corner_and_center", {720, 560}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; unset border; unset tics; unset grid\n"
               "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
               "set view 70, 118, 1.85; set view equal xyz\n"
               "set xrange [-1.8:2.2]; set yrange [-1.8:2.6]; set zrange [-1.5:3.3]\n";
    struct Place {
      Matrix3d I;
      Vector3d origin;
      const char* color;
      const char* name;
    };
    const std::array<Place, 2> places = {
        Place{box.at_corner(), Vector3d::Zero(), workbook::colors::vermilion, "corner"},
        Place{box.at_center(), box.edges / 2, workbook::colors::blue, "centre"}};
    std::vector<std::pair<std::vector<SpaceCurve>, std::string>> groups;
    groups.emplace_back(wire_frame(box.edges), "lw 2.5 lc rgb '#333333'");
    for (const Place& place : places) {
      const Vector3d moments = principal_moments(place.I);
      const Matrix3d axes = principal_axes(place.I);
      groups.emplace_back(ellipsoid(place.I, place.origin, size), fmt::format("lw 1.5 lc rgb '{}'", place.color));
      for (int i = 0; i < 3; ++i) {
        const Vector3d half = size / std::sqrt(moments[i]) * axes.col(i);
        const Vector3d from = place.origin - half, to = place.origin + half;
        gnuplot << fmt::format(
            "set arrow from {:.4f},{:.4f},{:.4f} to {:.4f},{:.4f},{:.4f} nohead front lw 3 dt {} lc rgb '{}'\n",
            from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), &place == &places[0] ? 1 : 2, place.color);
      }
      gnuplot << fmt::format("set label at {:.4f},{:.4f},{:.4f} point pt 7 ps 1.8 lc rgb '{}' front\n",
                             place.origin.x(), place.origin.y(), place.origin.z(), place.color);
    }
    for (int i = 0; i < 2; ++i) {
      const Place& place = places[static_cast<std::size_t>(i)];
      const Vector3d moments = principal_moments(place.I);
      gnuplot << fmt::format(
          "set label '{{/:Bold {}}}: {:.2f}, {:.2f}, {:.2f} kg m²' at screen 0.55,{} front tc rgb '{}'\n", place.name,
          moments[0], moments[1], moments[2], i == 0 ? 0.06 : 0.13, place.color);
    }
    std::string separator = "splot ";
    for (const auto& [curves, style] : groups) {
      for (std::size_t k = 0; k < curves.size(); ++k) {
        gnuplot << separator << "'-' w l " << style;
        separator = ", ";
      }
    }
    gnuplot << "\n";
    for (const auto& [curves, style] : groups) {
      for (const SpaceCurve& curve : curves) gnuplot.send1d(curve);
    }
  });
}

void draw_along_the_diagonal(const std::filesystem::path& directory) {
  const Box box;
  const Matrix3d corner = box.at_corner();
  const Vector3d center = box.edges / 2;

  workbook::draw_figure(directory, "origin_on_the_diagonal", {720, 470}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'place s of the new origin on the diagonal (0: corner, ½: centre)'; set ylabel 'entry of I "
               "(kg m²)'\n"
               "set xrange [-0.25:1.25]; set yrange [-35:65]; unset key; set xtics 0.25\n"
            << fmt::format("set arrow from 0.5,-35 to 0.5,65 nohead dt 3 lc rgb '{}'\n", workbook::colors::grey);
    PlaneCurve xx, xy, mistaken, reversed;
    for (int k = 0; k <= 150; ++k) {
      const double s = -0.25 + 0.01 * k;
      const Vector3d R = -s * box.edges;  // the new origin lies at s × (1, 2, 3) m
      const Matrix3d I = inertia_about_shifted_origin(corner, box.M, center, R);
      xx.emplace_back(s, I(0, 0));
      xy.emplace_back(s, I(1, 2));
      mistaken.emplace_back(s, inertia_from_center_of_mass(corner, box.M, R)(0, 0));
      reversed.emplace_back(s, inertia_about_shifted_origin(corner, box.M, center, -R)(0, 0));
    }
    const auto label = [&](const char* text, double x, double y, const char* color) {
      gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
    };
    label("I_{xx}", 1.0, 20, workbook::colors::blue);
    label("I_{yz}", 1.0, -15, workbook::colors::green);
    label("R reversed", 0.12, 58, workbook::colors::vermilion);
    label("no r_{CM} terms", 0.92, 58, workbook::colors::purple);
    gnuplot << fmt::format("set label at 0,{} point pt 7 ps 1.6 lc rgb '{}' front\n", corner(0, 0),
                           workbook::colors::black)
            << fmt::format("set label at 0.5,{} point pt 7 ps 1.6 lc rgb '{}' front\n", box.at_center()(0, 0),
                           workbook::colors::black)
            << fmt::format(
                   "plot 0 lc rgb '{}' lw 1, '-' w l lw 4 lc rgb '{}', '-' w l lw 4 dt 2 lc rgb '{}', '-' w l lw 2.5 "
                   "dt 4 lc rgb '{}', "
                   "'-' w l lw 2.5 dt 3 lc rgb '{}'\n",
                   workbook::colors::grey, workbook::colors::blue, workbook::colors::green, workbook::colors::vermilion,
                   workbook::colors::purple);
    gnuplot.send1d(xx);
    gnuplot.send1d(xy);
    gnuplot.send1d(reversed);
    gnuplot.send1d(mistaken);
  });
}

void draw_moving_origin(const std::filesystem::path& directory) {
  // A disc with a heavy bead on its rim rolls to +x; z points up. The origin is the disc's middle, which moves on
  // evenly.
  const double disc = 1, bead = 1, radius = 1, speed = 1;
  const double M = disc + bead;
  const Vector3d v_origin(speed, 0, 0), omega(0, speed / radius, 0);

  workbook::draw_figure(directory, "moving_origin", {720, 470}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'turn of the wheel (degrees; bead at the bottom at 0)'; set ylabel 'energy (J)'\n"
               "set xrange [0:360]; set yrange [-1.4:3.3]; set xtics 90; unset key\n";
    PlaneCurve rotation, mixed, translation, total, by_points;
    for (int k = 0; k <= 72; ++k) {
      const double angle = 2 * pi * k / 72, degrees = 5.0 * k;
      const Vector3d bead_place(-radius * std::sin(angle), 0, -radius * std::cos(angle));
      const Vector3d r_cm = bead / M * bead_place;
      const Matrix3d I = disc * radius * radius / 4 * Matrix3d(Vector3d(1, 2, 1).asDiagonal()) +
                         inertia_of_points(VectorXd{{bead}}, bead_place);
      rotation.emplace_back(degrees, kinetic_energy(I, omega));
      mixed.emplace_back(degrees, M * v_origin.dot(omega.cross(r_cm)));
      translation.emplace_back(degrees, 0.5 * M * v_origin.squaredNorm());
      total.emplace_back(degrees, rotation.back().second + mixed.back().second + translation.back().second);
      if (k % 6 != 0) continue;
      // Each point on its own: the bead, and the disc as two rings of equal mass.
      double energy = 0.5 * bead * (v_origin + omega.cross(bead_place)).squaredNorm();
      for (int i = 0; i < 24; ++i) {
        const double around = 2 * pi * i / 12, distance = radius * std::sqrt(i < 12 ? 0.25 : 0.75);
        const Vector3d place(distance * std::sin(around), 0, distance * std::cos(around));
        energy += 0.5 * disc / 24 * (v_origin + omega.cross(place)).squaredNorm();
      }
      by_points.emplace_back(degrees, energy);
    }
    const auto label = [&](const char* text, double x, double y, const char* color) {
      gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
    };
    label("whole energy", 180, 2.98, workbook::colors::black);
    label("½ M v²", 180, 1.19, workbook::colors::green);
    label("½ ω·I·ω", 54, 0.53, workbook::colors::blue);
    label("M v·(ω × r_{CM})", 180, -0.3, workbook::colors::vermilion);
    gnuplot << fmt::format(
        "plot 0 lc rgb '{}' lw 1, '-' w l lw 3 dt 2 lc rgb '{}', '-' w l lw 3 dt 3 lc rgb '{}', '-' w l lw 3 dt 4 lc "
        "rgb '{}', "
        "'-' w l lw 4 lc rgb '{}', '-' w p pt 6 ps 1.6 lw 2 lc rgb '{}'\n",
        workbook::colors::grey, workbook::colors::blue, workbook::colors::green, workbook::colors::vermilion,
        workbook::colors::black, workbook::colors::orange);
    gnuplot.send1d(rotation);
    gnuplot.send1d(translation);
    gnuplot.send1d(mixed);
    gnuplot.send1d(total);
    gnuplot.send1d(by_points);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"corner_and_center", draw_corner_and_center},
                                 {"origin_on_the_diagonal", draw_along_the_diagonal},
                                 {"moving_origin", draw_moving_origin}});
}
