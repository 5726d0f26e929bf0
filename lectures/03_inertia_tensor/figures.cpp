// Figures of lecture 03.
#include "lectures/support/sketch.hpp"

#include <rigid/inertia_tensor.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

using namespace rigid;
using namespace workbook;

namespace {

/// A mass on its circle about the axis.
void draw_circle_of_a_point(const std::filesystem::path& directory) {
  Sketch sketch({0.5, -1.0, 0.42});
  const double distance = 1.25, height = 1.0, azimuth = -0.5;
  const Vector3d center(0, 0, height);
  const Vector3d outward(std::cos(azimuth), std::sin(azimuth), 0);
  const Vector3d r = center + distance * outward;
  sketch.line(arc(center, distance, x_axis, y_axis), colors::grey, 1.5, "dt (5,4)");
  sketch.line({center, r}, colors::grey, 2);
  sketch.text(center + 0.5 * distance * outward, "d", colors::grey, Side::above);
  sketch.arrow(origin, {0, 0, 1.75}, colors::vermilion, "{/:Bold ω}", Side::left);
  sketch.arrow(origin, r, colors::black);
  sketch.text(0.55 * r, "{/:Bold r}", colors::black, Side::below);
  sketch.arrow(r, r + 0.8 * z_axis.cross(outward), colors::blue, "{/:Bold v} = {/:Bold ω} × {/:Bold r}", Side::right);
  sketch.dot(r, colors::black, 1.2);
  sketch.text(r + Vector3d(0.05, 0, -0.12), "m", colors::black, Side::right);
  sketch.dot(origin, colors::grey, 0.6);
  sketch.text(origin, "O", colors::grey, Side::left);
  sketch.draw(directory, "circle_of_a_point", 560);
}

/// Two equal masses on a rod that is not at right angles to the axis: L turns with the rod.
void draw_skew_dumbbell(const std::filesystem::path& directory) {
  Sketch sketch({0.35, -1.0, 0.32});
  const double inclination = pi / 6;
  const Vector3d r(1.5 * std::sin(inclination), 0, 1.5 * std::cos(inclination));
  const Vector3d L = 1.25 * Vector3d(-std::cos(inclination), 0, std::sin(inclination));
  sketch.line({-1.5 * z_axis, 1.2 * z_axis}, colors::grey, 1.5);
  sketch.line(arc({0, 0, L.z()}, L.x(), x_axis, y_axis), colors::blue, 1.2, "dt (5,4)");
  for (const double sign : {1.0, -1.0})
    sketch.line(arc({0, 0, sign * r.z()}, r.x(), x_axis, y_axis), colors::grey, 1.2, "dt (5,4)");
  sketch.line({-r, r}, colors::black, 4);
  sketch.arrow(origin, 1.75 * z_axis, colors::vermilion, "{/:Bold ω}", Side::left);
  sketch.arrow(origin, L, colors::blue, "{/:Bold L}", Side::left);
  for (const double sign : {1.0, -1.0}) {
    sketch.dot(sign * r, colors::black, 1.4);
    sketch.arrow(sign * r, sign * (r + 0.85 * y_axis), colors::green, "m{/:Bold v}",
                 sign > 0 ? Side::right : Side::left);
  }
  sketch.text(1.03 * r + Vector3d(0.1, 0, -0.1), "{/:Bold r}", colors::black, Side::right);
  sketch.text(-1.03 * r + Vector3d(-0.1, 0, 0.1), "−{/:Bold r}", colors::black, Side::left);
  sketch.draw(directory, "skew_dumbbell", 400);
}

/// The cube about its corner: one axis along the diagonal, every direction across it.
void draw_cube_axes(const std::filesystem::path& directory) {
  Sketch sketch({1.3, -0.9, 0.9});
  const Matrix3d V = principal_axes(cuboid_about_corner(1, 1, 1, 1));
  const Vector3d diagonal = (V.col(0).sum() > 0 ? 1 : -1) * V.col(0);
  const Vector3d across = (x_axis - y_axis).normalized(), other = diagonal.cross(across);
  sketch.face(arc(origin, 0.85, across, other), colors::blue, 0.18);
  sketch.box(origin, Matrix3d::Identity());
  for (int i = 0; i < 3; ++i) {
    const double angle = 0.35 + i * pi / 3;
    const Vector3d direction = std::cos(angle) * across + std::sin(angle) * other;
    sketch.line({-0.85 * direction, 0.85 * direction}, colors::blue, 2);
  }
  sketch.text(-0.9 * (std::cos(0.35 + pi / 3) * across + std::sin(0.35 + pi / 3) * other),
              "I_2 = I_3 = {/*0.85 11/12} Ma^2", colors::blue, Side::left);
  sketch.arrow(origin, 2.15 * diagonal, colors::orange, "I_1 = {/*0.85 1/6} Ma^2", Side::right);
  sketch.dot(origin, colors::black, 0.7);
  sketch.draw(directory, "cube_axes", 590);
}

/// A flat box about its centre, turned so that no axis of it is a coordinate axis. 1 kg, edges in metres.
struct Box {
  Vector3d edges{3.0, 1.6, 0.6};
  Matrix3d axes = (Eigen::AngleAxisd(-2.3, z_axis) * Eigen::AngleAxisd(-0.35, y_axis)).toRotationMatrix();
  Vector3d squares = edges.cwiseAbs2() / 12;
  Vector3d moments = Vector3d::Constant(squares.sum()) - squares;
};

void draw_inertia_ellipsoid(const std::filesystem::path& directory) {
  const Box box;
  Sketch sketch({0.75, -1.0, 0.75});
  sketch.solid_box(origin, box.axes * Matrix3d((0.5 * box.edges).asDiagonal()),
                   {colors::grey, colors::grey, colors::grey});
  // The ellipsoid in circles about its long axis and in meridians.
  const Vector3d half_axes = box.moments.cwiseSqrt().cwiseInverse();
  const auto point = [&](double polar, double azimuth) -> Vector3d {
    const Vector3d n(std::cos(polar), std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth));
    return box.axes * n.cwiseProduct(half_axes);
  };
  sketch.ellipsoid(box.axes * half_axes.asDiagonal(), colors::sky, origin, 0.3);
  const auto draw = [&](const auto& at) {
    SpaceCurve curve;
    for (int i = 0; i <= 72; ++i) curve.push_back(at(i / 72.0));
    sketch.line(curve, colors::blue, 0.8);
  };
  for (int k = 1; k < 8; ++k) draw([&](double s) { return point(pi * k / 8, 2 * pi * s + 1); });
  for (int k = 0; k < 12; ++k) draw([&](double s) { return point(pi * s, 2 * pi * k / 12); });
  for (int i = 0; i < 3; ++i) {
    sketch.arrow(origin, box.axes.col(i) * (half_axes[i] + (i == 0 ? 0.5 : 1.2)),
                 axis_colors[static_cast<std::size_t>(i)], fmt::format("I_{} = {:.2f} kg m²", i + 1, box.moments[i]),
                 i == 0   ? Side::left
                 : i == 1 ? Side::below
                          : Side::above);
  }
  sketch.draw(directory, "inertia_ellipsoid", 590, false);
}

/// One level line of the energy on the unit sphere of directions, round ±e₁ or ±e₃, on principal axes.
SpaceCurve level_line(const Vector3d& I, double level, double sign) {
  SpaceCurve curve;
  const bool low = level < I[1];
  const int pole = low ? 0 : 2, far = low ? 2 : 0;
  const double a = std::sqrt((level - I[pole]) / (I[1] - I[pole])),
               b = std::sqrt((level - I[pole]) / (I[far] - I[pole]));
  for (int i = 0; i <= 180; ++i) {
    Vector3d n;
    n[1] = a * std::cos(2 * pi * i / 180);
    n[far] = b * std::sin(2 * pi * i / 180);
    n[pole] = sign * std::sqrt(std::max(0.0, 1 - n[1] * n[1] - n[far] * n[far]));
    curve.push_back(n);
  }
  return curve;
}

/// Kinetic energy over the directions of ω, on the two hemispheres.
void draw_energy_on_sphere(const std::filesystem::path& directory) {
  const Vector3d I = Box().moments;
  Sketch sketch;
  for (const double side : {1.0, -1.0}) {
    const Vector3d towards = side * Vector3d(0.75, 1.0, 0.6).normalized();
    const Vector3d right = z_axis.cross(towards).normalized(), up = towards.cross(right);
    const Vector3d center(-1.2 * side, 0, 0);
    // Turned so that one looks along z.
    const auto place = [&](const Vector3d& n) -> Vector3d {
      return center + Vector3d(n.dot(right), n.dot(up), n.dot(towards));
    };
    const auto draw = [&](SpaceCurve curve, const char* color, double width) {
      for (Vector3d& n : curve) n = place(n);
      sketch.line(curve, color, width);
    };
    sketch.ellipsoid(Matrix3d::Identity(), colors::sky, center);
    for (const double sign : {1.0, -1.0}) {
      for (const double part : {0.1, 0.35, 0.65, 0.9}) {
        draw(level_line(I, I[0] + part * (I[1] - I[0]), sign), axis_colors[0], 1.8);
        draw(level_line(I, I[2] + part * (I[1] - I[2]), sign), axis_colors[2], 1.8);
      }
      // The level through ±e₂: two great circles.
      const Vector3d across = Vector3d(std::sqrt(I[2] - I[1]), 0, sign * std::sqrt(I[1] - I[0])).normalized();
      draw(arc(origin, 1, across, y_axis), colors::black, 2.4);
    }
    for (int i = 0; i < 3; ++i) {
      const Vector3d n = side * Vector3d::Unit(i);
      const char* color = axis_colors[static_cast<std::size_t>(i)];
      sketch.arrow(place(n), place(1.25 * n), color);
      sketch.text(place(1.25 * n), fmt::format("{}{{/:Bold e}}_{}", side > 0 ? "" : "−", i + 1), color,
                  i == 0 ? Side::left : Side::right, i == 1 ? Vector2d(0.32, -0.45 * side) : Vector2d(0, 0));
    }
  }
  sketch.draw(directory, "energy_on_sphere", 590);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"circle_of_a_point", draw_circle_of_a_point},
                       {"skew_dumbbell", draw_skew_dumbbell},
                       {"cube_axes", draw_cube_axes},
                       {"inertia_ellipsoid", draw_inertia_ellipsoid},
                       {"energy_on_sphere", draw_energy_on_sphere}});
}
