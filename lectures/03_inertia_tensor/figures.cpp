// Figures of lecture 03.
#include "lectures/support/figure.hpp"

#include <rigid/inertia_tensor.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

using namespace rigid;

namespace {

using Curve = std::vector<std::tuple<double, double, double>>;

constexpr double pi = std::numbers::pi;

/// The body of both figures: a flat cuboid about its centre, turned so that no axis of it is a coordinate axis.
struct Body {
  Vector3d edges{3.0, 1.6, 0.6};
  Matrix3d axes =
      (Eigen::AngleAxisd(0.5, Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.35, Vector3d::UnitY())).toRotationMatrix();

  Matrix3d tensor() const {
    const Vector3d squares = edges.cwiseAbs2() / 12;
    return rotated_inertia((squares.sum() - squares.array()).matrix().asDiagonal(), axes);
  }
};

Curve line(const Vector3d& from, const Vector3d& to) {
  return {{from.x(), from.y(), from.z()}, {to.x(), to.y(), to.z()}};
}

/// The twelve edges of the cuboid.
std::vector<Curve> wire_frame(const Body& body) {
  std::vector<Curve> edges;
  for (int corner = 0; corner < 8; ++corner) {
    const auto position = [&](int bits) -> Vector3d {
      const Vector3d sign((bits & 1) ? 1 : -1, (bits & 2) ? 1 : -1, (bits & 4) ? 1 : -1);
      return body.axes * (0.5 * sign.cwiseProduct(body.edges));
    };
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) edges.push_back(line(position(corner), position(corner | 1 << axis)));
    }
  }
  return edges;
}

/// Circles of latitude and meridians of the surface n·I·n = 1 along which the figure draws the ellipsoid.
std::vector<Curve> ellipsoid_mesh(const Matrix3d& I, double size) {
  const Vector3d moments = principal_moments(I);
  const Matrix3d axes = principal_axes(I);
  const auto point = [&](double polar, double azimuth) -> Vector3d {
    const Vector3d n(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
    return size * (axes * n.cwiseQuotient(moments.cwiseSqrt()));
  };
  std::vector<Curve> mesh;
  for (int k = 1; k < 8; ++k) {
    Curve circle;
    for (int i = 0; i <= 72; ++i) {
      const Vector3d p = point(pi * k / 8, 2 * pi * i / 72);
      circle.emplace_back(p.x(), p.y(), p.z());
    }
    mesh.push_back(circle);
  }
  for (int k = 0; k < 12; ++k) {
    Curve meridian;
    for (int i = 0; i <= 36; ++i) {
      const Vector3d p = point(pi * i / 36, 2 * pi * k / 12);
      meridian.emplace_back(p.x(), p.y(), p.z());
    }
    mesh.push_back(meridian);
  }
  return mesh;
}

void draw_inertia_ellipsoid(const std::filesystem::path& directory) {
  const Body body;
  const Matrix3d I = body.tensor();
  const Vector3d moments = principal_moments(I);
  const Matrix3d axes = principal_axes(I);
  const double size = 1.0;

  workbook::draw_figure(directory, "inertia_ellipsoid", {720, 480}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; unset border; unset tics; unset grid\n"
               "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
               "set view 55, 62, 2.3; set view equal xyz\n"
               "set xrange [-2.4:2.4]; set yrange [-2.4:2.4]; set zrange [-1.7:1.7]\n";
    const std::array<const char*, 3> colors = {workbook::colors::vermilion, workbook::colors::green,
                                               workbook::colors::purple};
    for (int i = 0; i < 3; ++i) {
      const Vector3d tip = axes.col(i) * (size / std::sqrt(moments[i]) + 0.45);
      const Vector3d place = axes.col(i) * (size / std::sqrt(moments[i]) + 0.65);
      gnuplot << fmt::format("set arrow from 0,0,0 to {:.4f},{:.4f},{:.4f} front lw 3 lc rgb '{}'\n", tip.x(), tip.y(),
                             tip.z(), colors[i])
              << fmt::format(
                     "set label '{{/:Bold I_{}}} = {:.2f} kg m²' at {:.4f},{:.4f},{:.4f} front center offset 0,-1.3 tc "
                     "rgb '{}'\n",
                     i + 1, moments[i], place.x(), place.y(), place.z(), colors[i]);
    }
    const auto mesh = ellipsoid_mesh(I, size);
    const auto frame = wire_frame(body);
    gnuplot << "splot ";
    for (std::size_t i = 0; i < mesh.size(); ++i) gnuplot << "'-' w l lw 1 lc rgb '" << workbook::colors::sky << "', ";
    for (std::size_t i = 0; i < frame.size(); ++i)
      gnuplot << "'-' w l lw 2.5 lc rgb '#333333'" << (i + 1 < frame.size() ? ", " : "\n");
    for (const Curve& curve : mesh) gnuplot.send1d(curve);
    for (const Curve& curve : frame) gnuplot.send1d(curve);
  });
}

void draw_energy_over_direction(const std::filesystem::path& directory) {
  const Body body;
  const Matrix3d I = body.tensor();
  const Vector3d moments = principal_moments(I);
  const Matrix3d axes = principal_axes(I);

  workbook::draw_figure(directory, "energy_over_direction", {720, 470}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'azimuth of ω (degrees)'; set ylabel 'angle of ω from the z axis (degrees)'\n"
               "set xrange [-180:180]; set yrange [180:0]; set xtics 60; set ytics 30\n"
               "set cblabel 'T (J)'; unset key; unset grid\n"
               // Light to dark, so that the map also reads in grey print.
               "set palette defined (0 '#FFFFE0', 1 '#C7E9B4', 2 '#41B6C4', 3 '#225EA8', 4 '#081D58')\n";
    for (int i = 0; i < 3; ++i) {
      for (const double sign : {1.0, -1.0}) {
        const Vector3d n = sign * axes.col(i);
        const double azimuth = std::atan2(n.y(), n.x()) * 180 / pi;
        const double polar = std::acos(n.z()) * 180 / pi;
        const char* color = i == 2 ? "white" : "black";
        gnuplot << fmt::format("set label at {:.2f},{:.2f} point pt 7 ps 1.6 lc rgb '{}' front\n", azimuth, polar,
                               color)
                << fmt::format("set label '{}e_{}' at {:.2f},{:.2f} left front tc rgb '{}'\n", sign > 0 ? "" : "−",
                               i + 1, azimuth + 6, polar, color);
      }
    }
    std::vector<Curve> rows;
    for (int j = 0; j <= 60; ++j) {
      Curve row;
      for (int i = 0; i <= 120; ++i) {
        const double azimuth = -pi + 2 * pi * i / 120;
        const double polar = pi * j / 60;
        const Vector3d omega(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
        row.emplace_back(azimuth * 180 / pi, polar * 180 / pi, kinetic_energy(I, omega));
      }
      rows.push_back(row);
    }
    gnuplot << fmt::format("set title 'T at |ω| = 1 rad/s: {:.3f} J along e_1, {:.3f} J along e_3'\n", moments[0] / 2,
                           moments[2] / 2);
    gnuplot << "plot '-' with image\n";
    gnuplot.send2d(rows);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(
      argc, argv,
      {{"inertia_ellipsoid", draw_inertia_ellipsoid}, {"energy_over_direction", draw_energy_over_direction}});
}
