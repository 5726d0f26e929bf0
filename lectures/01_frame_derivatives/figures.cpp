// Figures of lecture 01.
#include "lectures/support/sketch.hpp"

#include <rigid/frame_derivatives.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace rigid;
using namespace workbook;

namespace {

Vector3d rotated(const Vector3d& vector, const Vector3d& axis, double angle) {
  return rotated_basis(Matrix3d::Identity(), axis, angle) * vector;
}

/// A child walks outwards on a merry-go-round; seen from above.
void draw_two_sources(const std::filesystem::path& directory) {
  const double rate = 2 * pi / 12, now = 3, radius = 4.3;
  const Vector3d omega = rate * z_axis;
  const auto place = [&](double t) { return rotated((1 + 0.5 * t) * x_axis, z_axis, rate * t); };
  const Vector3d V = place(now);
  const Matrix3d basis = rotated_basis(Matrix3d::Identity(), omega, now);
  const Vector3d seen = 0.5 * basis.col(0), added = omega.cross(V), sum = inertial_rate(seen, omega, V);

  Sketch sketch;
  sketch.line(arc(origin, radius, x_axis, y_axis, -0.1, pi + 0.1), colors::grey, 1.5);
  sketch.line(arc(origin, 0.88 * radius, x_axis, y_axis, 0.1, 0.4), colors::grey, 2);
  sketch.arrow(rotated(0.88 * radius * x_axis, z_axis, 0.4), rotated(0.88 * radius * x_axis, z_axis, 0.44),
               colors::grey, "ω", Side::left, 2);
  SpaceCurve path;
  for (int k = 0; k <= 60; ++k) path.push_back(place(4.4 * k / 60));
  sketch.line(path, colors::grey, 2);
  sketch.text(place(0.9), "path", colors::grey, Side::right);
  sketch.arrow(origin, 0.8 * basis.col(0), colors::orange, "{/:Bold e}_1", Side::right);
  sketch.arrow(origin, 0.8 * basis.col(1), colors::green, "{/:Bold e}_2", Side::below);
  sketch.line({origin, V}, colors::black, 2);
  sketch.text(0.72 * V, "{/:Bold V}", colors::black, Side::right);
  sketch.line({V + seen, V + sum}, colors::pale, 1.5);
  sketch.line({V + added, V + sum}, colors::pale, 1.5);
  sketch.arrow(V, V + seen, colors::blue, "(d{/:Bold V}/dt)_{body}", Side::right);
  sketch.arrow(V, V + added, colors::vermilion, "{/:Bold ω} × {/:Bold V}", Side::below);
  sketch.arrow(V, V + sum, colors::purple, "(d{/:Bold V}/dt)_{inertial}", Side::above);
  sketch.dot(V, colors::black, 0.9);
  sketch.draw(directory, "two_sources_of_change", 440);
}

/// e_y and e_z, where they rotate to, and the first-order step between.
void draw_small_rotation(const std::filesystem::path& directory) {
  const double angle = 0.42;
  const Vector3d dTheta = angle * z_axis;  // the sketch lies in the plane of y (to the right) and z (up)
  Sketch sketch;
  sketch.line(arc(origin, 1, x_axis, y_axis, -0.12, pi / 2 + 0.65), colors::grey, 1.5);
  sketch.line(arc(origin, 0.3, x_axis, y_axis, 0, angle), colors::grey, 1.5);
  sketch.text(rotated(0.3 * x_axis, z_axis, angle / 2), "dΘ", colors::grey, Side::right);
  const std::array<const char*, 2> names{"y", "z"}, hues{colors::green, colors::purple};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector3d e = i == 0 ? x_axis : y_axis;
    const std::string name = std::string("{/:Bold e}_") + names[i];
    sketch.line({origin, 0.94 * rotated(e, z_axis, angle)}, hues[i], 2, "dt (5,4)");
    sketch.arrow(0.94 * rotated(e, z_axis, angle), rotated(e, z_axis, angle), hues[i]);
    sketch.arrow(origin, e, hues[i]);
    sketch.text(0.6 * e, name, hues[i], i == 0 ? Side::below : Side::right);
    sketch.arrow(e, e + dTheta.cross(e), colors::black, fmt::format("d{0} = d{{/:Bold Θ}} × {0}", name),
                 i == 0 ? Side::right : Side::above);
  }
  sketch.dot(origin, colors::vermilion, 1);
  sketch.text(origin, "d{/:Bold Θ}, towards you", colors::vermilion, Side::below);
  sketch.draw(directory, "small_rotation", 480);
}

/// A wind turbine: the rotor spins about the shaft, the shaft yaws about the tower.
void draw_turbine(const std::filesystem::path& directory) {
  Sketch sketch({1.0, -0.75, 0.35});
  const Vector3d hub = 0.35 * x_axis;
  sketch.turned_body(-1.4 * z_axis, origin, {{0, 0.06}, {1, 0.04}}, colors::grey);
  sketch.turned_body(-0.35 * x_axis, hub, {{0, 0}, {0, 0.06}, {0.9, 0.08}, {1, 0.05}, {1, 0}}, colors::grey);
  sketch.line(arc(hub, 1.25, y_axis, z_axis), colors::grey, 1.2, "dt (5,4)");
  for (int k = 0; k < 3; ++k) {
    const Vector3d along = rotated(z_axis, x_axis, 0.7 + 2 * pi * k / 3), across = x_axis.cross(along);
    sketch.face({hub - 0.04 * across, hub + 1.25 * along, hub + 0.3 * along + 0.12 * across, hub + 0.04 * across},
                colors::grey, 1);
  }
  const Vector3d spin = 1.35 * x_axis, yaw = 0.75 * z_axis;
  sketch.arrow(hub, hub + spin, colors::blue);
  sketch.text(hub + 0.62 * spin - 0.1 * z_axis, "{/:Bold ω}_2, spin", colors::blue, Side::below);
  sketch.arrow(hub, hub + yaw, colors::green, "{/:Bold ω}_1, yaw", Side::above);
  sketch.line({hub + spin, hub + spin + yaw}, colors::pale, 1.5);
  sketch.line({hub + yaw, hub + spin + yaw}, colors::pale, 1.5);
  sketch.arrow(hub, hub + spin + yaw, colors::vermilion, "{/:Bold ω}", Side::above);
  sketch.draw(directory, "turbine", 300);
}

/// Rodrigues: the part along the axis stays, the part across it goes round a circle.
void draw_rodrigues(const std::filesystem::path& directory) {
  Sketch sketch({1.0, -0.45, 0.7});
  const double theta = 1.05, height = 1.35, radius = 1;
  const Vector3d foot = height * z_axis, e = foot + radius * rotated(x_axis, z_axis, -1.0);
  const Vector3d across = e - foot, quarter = z_axis.cross(e), after = rotated(e, z_axis, theta);
  sketch.line(arc(foot, radius, x_axis, y_axis), colors::grey, 1.2, "dt (5,4)");
  sketch.arrow(origin, 1.75 * z_axis, colors::grey, "{/:Bold n}", Side::left, 2);
  sketch.arrow(origin, foot, colors::purple);
  sketch.text(0.4 * foot, "{/:Bold e}_∥", colors::purple, Side::right);
  sketch.arrow(foot, e, colors::blue);
  sketch.text(foot + 0.6 * across + 0.12 * z_axis, "{/:Bold e}_⊥", colors::blue, Side::left);
  sketch.arrow(foot, foot + quarter, colors::green, "{/:Bold n} × {/:Bold e}", Side::right);
  const Vector3d corner = foot + std::cos(theta) * across;
  sketch.line({corner, after}, colors::green, 2);
  sketch.line({foot, corner}, colors::blue, 5);
  sketch.line({foot, after}, colors::grey, 1.5);
  sketch.line(arc(foot, 0.36, across.normalized(), quarter.normalized(), 0, theta), colors::grey, 1.5);
  sketch.text(foot + 0.5 * rotated(across, z_axis, 0.8 * theta), "Θ", colors::grey);
  sketch.arrow(origin, e, colors::black);
  sketch.text(0.6 * e, "{/:Bold e}", colors::black, Side::left);
  sketch.arrow(origin, after, colors::vermilion, "{/:Bold e}(t)", Side::right);
  sketch.draw(directory, "rodrigues", 420);
}

/// One revolution in twelve steps, by the first order and exactly.
void draw_leaving_the_circle(const std::filesystem::path& directory) {
  const int steps = 12;
  const Vector3d dTheta = 2 * pi / steps * z_axis;
  Vector3d e = x_axis;
  SpaceCurve spiral{e};
  Sketch sketch;
  for (int k = 0; k < steps; ++k) {
    e += dTheta.cross(e);
    spiral.push_back(e);
    sketch.dot(rotated(x_axis, dTheta, k), colors::blue, 0.9);
  }
  sketch.line(arc(origin, 1, x_axis, y_axis), colors::blue, 2);
  sketch.line(spiral, colors::vermilion, 2.5);
  for (const Vector3d& tip : spiral) sketch.dot(tip, colors::vermilion, 0.7);
  for (int k = 0; k < 3; ++k) sketch.line({origin, spiral[static_cast<std::size_t>(k)]}, colors::grey, 1.2);
  sketch.text(spiral.back(), "after 12 steps", colors::vermilion, Side::above);
  sketch.text(-1.0 * y_axis, "exact steps", colors::blue, Side::below);
  sketch.text(spiral[7], "steps {/:Bold ω} × {/:Bold e} dt", colors::vermilion, Side::left);
  sketch.draw(directory, "leaving_the_circle", 480);
}

/// A box with a spine, and a title on its cover, so that its attitude can be told.
void draw_book(Sketch& sketch, const Vector3d& center, const Matrix3d& attitude) {
  const Vector3d half(0.38, 0.55, 0.11);
  const auto at = [&](double x, double y, double z) -> Vector3d {
    return center + attitude * Vector3d(x * half[0], y * half[1], z * half[2]);
  };
  sketch.solid_box(center, attitude * half.asDiagonal(), {colors::pale, colors::pale, colors::sky});
  const double above = 1.02;
  sketch.face({at(-above, 1, 1), at(-above, 1, -1), at(-above, -1, -1), at(-above, -1, 1)}, colors::blue, 1);
  sketch.face({at(-0.6, 0.3, above), at(0.6, 0.3, above), at(0.6, 0.65, above), at(-0.6, 0.65, above)}, colors::black,
              1);
  sketch.line({at(-0.6, -0.55, above), at(0.2, -0.55, above)}, colors::black, 2);
}

/// Two quarter rotations of a book, in both orders.
void draw_book_orders(const std::filesystem::path& directory) {
  Sketch sketch({0.75, -1.0, 0.75});
  const Vector3d right = sketch.right(), up = sketch.up();
  for (int row = 0; row < 2; ++row) {
    Matrix3d attitude = Matrix3d::Identity();
    for (int step = 0; step < 3; ++step) {
      const Vector3d center = 2.2 * step * right - 1.8 * row * up;
      draw_book(sketch, center, attitude);
      const Vector3d axis = (row + step) % 2 == 0 ? x_axis : z_axis;
      if (step == 2) continue;
      attitude = rotated_basis(attitude, axis, pi / 2);
      const Vector3d between = center + 1.1 * right;
      sketch.arrow(between - 0.17 * right, between + 0.17 * right, colors::grey);
      sketch.text(between, (row + step) % 2 == 0 ? "about x" : "about z", colors::vermilion, Side::above);
    }
  }
  const Vector3d corner = -0.95 * right - 1.0 * up;
  sketch.arrow(corner, corner + 0.5 * x_axis, colors::vermilion, "x", Side::right, 2);
  sketch.arrow(corner, corner + 0.5 * y_axis, colors::grey, "y", Side::right, 2);
  sketch.arrow(corner, corner + 0.5 * z_axis, colors::vermilion, "z", Side::left, 2);
  sketch.draw(directory, "book", 600, false);
}

/// A book from the table to its shelf, by one rotation about an axis and one shift along it.
void draw_screw(const std::filesystem::path& directory) {
  const double angle = pi / 2;
  const Vector3d d(1.6, 1.2, 1.3);
  const Matrix3Xd screw = screw_of_displacement(angle * z_axis, d);
  const Vector3d c = screw.col(0), shift = screw.col(1);
  const auto place = [&](const Vector3d& from, double part) -> Vector3d {
    return c + rotated(from - c, z_axis, part * angle) + part * shift;
  };
  Sketch sketch({1.0, -0.7, 0.5});
  draw_book(sketch, origin, Matrix3d::Identity());
  draw_book(sketch, place(origin, 1), rotated_basis(Matrix3d::Identity(), z_axis, angle));
  const Vector3d corner(0.38, -0.55, 0.11);
  SpaceCurve path;
  for (int k = 0; k <= 48; ++k) path.push_back(place(corner, k / 48.0));
  sketch.line(path, colors::purple, 2.5);
  sketch.arrow(path[46], path[48], colors::purple, "", Side::right, 2.5);
  sketch.line({c - 0.5 * z_axis, c + shift + 0.5 * z_axis}, colors::black, 1.5, "dt (6,5)");
  sketch.arrow(c, c + shift, colors::vermilion);
  sketch.text(c + 0.55 * shift, "({/:Bold n} ∙ {/:Bold d}) {/:Bold n}", colors::vermilion, Side::left);
  const Vector3d out = corner - c - corner.z() * z_axis, across = z_axis.cross(out);
  sketch.line(arc(c, 0.8, out.normalized(), across.normalized(), 0, angle), colors::blue, 2);
  sketch.text(c + 0.95 * (out.normalized() + across.normalized()).normalized(), "Θ", colors::blue);
  sketch.dot(c, colors::black, 0.9);
  sketch.text(c + 0.12 * z_axis, "{/:Bold c}", colors::black, Side::left);
  sketch.draw(directory, "screw", 480);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"two_sources_of_change", draw_two_sources},
                       {"small_rotation", draw_small_rotation},
                       {"turbine", draw_turbine},
                       {"rodrigues", draw_rodrigues},
                       {"leaving_the_circle", draw_leaving_the_circle},
                       {"book", draw_book_orders},
                       {"screw", draw_screw}});
}
