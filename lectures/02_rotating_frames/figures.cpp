// Figures of lecture 02.
#include "lectures/support/sketch.hpp"

#include <rigid/frame_derivatives.hpp>
#include <rigid/rotating_frames.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;

namespace {

constexpr double Omega_earth = 7.292115e-5;  // rad/s

Vector3d rotated(const Vector3d& vector, const Vector3d& axis, double angle) {
  return rotated_basis(Matrix3d::Identity(), axis, angle) * vector;
}

SpaceCurve circle(const Vector3d& center, double radius) {
  SpaceCurve points;
  for (int k = 0; k <= 36; ++k) points.push_back(center + radius * rotated(x_axis, z_axis, k * pi / 18));
  return points;
}

/// The puck of the worked example, beside the turntable and riding on it.
void draw_puck(const std::filesystem::path& directory) {
  const Vector3d r0(-1, 0, 0), v0(0.5, 0.1, 0);
  const FigureSize size{600, 330};
  draw_figure(directory, "puck", size, [&](gnuplotio::Gnuplot& gnuplot) {
    Sketch sketch;
    const double now = 4;  // s
    for (const bool riding : {false, true}) {
      const Vector3d center(riding ? 1.3 : -1.3, -0.08, 0);
      const double table = riding ? 0 : now;  // angle of the table as it is drawn
      const auto place = [&](double t) -> Vector3d { return center + rotated(r0 + v0 * t, z_axis, riding ? -t : 0); };
      sketch.face(circle(center, 1.12), colors::shade, 1);
      // A cross painted on the table, so that its rotation is seen.
      const Vector3d one = rotated(1.12 * x_axis, z_axis, table), other = z_axis.cross(one);
      sketch.line({center + one, center, center + other, center - other}, colors::pale, 2);
      sketch.line({center, center - one}, colors::vermilion, 2);
      SpaceCurve path;
      for (int k = 0; k <= 40; ++k) path.push_back(place(0.1 * k));
      sketch.line(path, colors::blue, 3);
      for (int second = 0; second <= now + 1e-9; ++second) sketch.dot(place(second), colors::blue, 0.6);
      sketch.dot(place(now), colors::black, 1.3);
      sketch.text(center + 1.27 * y_axis, riding ? "riding on the turntable" : "beside the turntable");
    }
    sketch.send(gnuplot, size, 2.5);
  });
}

/// A radial walk: the carried velocity grows with the radius, and the walker's own velocity is carried round.
void draw_two_origins(const std::filesystem::path& directory) {
  Sketch sketch;
  const double turn = 0.5, near = 1.2, far = 1.9, v = far - near, omega = turn;  // dt = 1
  const Vector3d radial = rotated(x_axis, z_axis, turn);
  for (const double radius : {near, far})
    sketch.line(arc(origin, radius, x_axis, y_axis, -0.25, turn + 0.45), colors::pale, 1.5);
  sketch.line({origin, far * x_axis}, colors::grey, 1.2);
  sketch.line({origin, far * radial}, colors::grey, 1.2);
  sketch.line(arc(origin, 0.5, x_axis, y_axis, 0, turn), colors::grey, 1.2);
  sketch.text(rotated(0.5 * x_axis, z_axis, turn / 2), "ω dt", colors::grey, Side::right);
  sketch.dot(origin, colors::grey, 0.7);
  const Vector3d start = near * x_axis, end = far * radial;
  const Vector3d side = z_axis.cross(radial);
  sketch.arrow(start, start + v * x_axis, colors::blue, "{/:Bold v}", Side::right);
  sketch.arrow(start, start + omega * near * y_axis, colors::vermilion, "{/:Bold ω} × {/:Bold r}", Side::right);
  sketch.arrow(end, end + v * radial, colors::blue, "{/:Bold v}", Side::above);
  sketch.arrow(end, end + omega * far * side, colors::vermilion, "{/:Bold ω} × {/:Bold r}", Side::above);
  // What both have gained, both towards the side.
  sketch.line({end, end + v * x_axis}, colors::blue, 1.5, "dt (4,4)");
  sketch.arrow(end + v * x_axis, end + v * radial, colors::black);
  sketch.text(end + v * x_axis + 0.1 * y_axis, "{/:Bold ω} × {/:Bold v} dt", colors::black, Side::right);
  sketch.arrow(end + omega * near * side, end + omega * far * side, colors::black, "", Side::right, 4);
  sketch.text(end + omega * 0.5 * (near + far) * side - 0.06 * x_axis, "{/:Bold ω} × {/:Bold v} dt", colors::black,
              Side::left);
  sketch.dot(start, colors::black, 0.9);
  sketch.dot(end, colors::black, 0.9);
  sketch.draw(directory, "two_origins", 420);
}

/// The Earth with its axis, a latitude, and the local axes.
void draw_globe(const std::filesystem::path& directory) {
  Sketch sketch({1.0, -0.35, 0.42});
  const double latitude = 42 * degree, longitude = 0.5;
  const Vector3d meridian(std::cos(longitude), std::sin(longitude), 0);
  const Vector3d up = std::cos(latitude) * meridian + std::sin(latitude) * z_axis;
  const Vector3d east = z_axis.cross(meridian), north = up.cross(east);
  sketch.ellipsoid(Matrix3d::Identity(), colors::sky);
  for (int k = -2; k <= 2; ++k) {
    const double there = 30 * k * degree;
    sketch.line(arc(std::sin(there) * z_axis, std::cos(there), x_axis, y_axis), colors::grey, k == 0 ? 2 : 0.8);
  }
  for (int k = 0; k < 6; ++k)
    sketch.line(arc(origin, 1, z_axis, rotated(meridian, z_axis, pi / 6 * (k + 0.5))), colors::grey, 0.8);
  sketch.line(arc(origin, 1, meridian, z_axis, -pi / 2, pi / 2), colors::black, 1.5);
  sketch.line({-1.25 * z_axis, -1.0 * z_axis}, colors::vermilion, 2);
  sketch.line({origin, z_axis}, colors::vermilion, 2, "dt (4,4)");
  sketch.arrow(z_axis, 1.6 * z_axis, colors::vermilion, "{/:Bold Ω}", Side::right);
  sketch.in_front(true);
  sketch.line({meridian, origin, up}, colors::grey, 1.5, "dt (4,4)");
  sketch.line(arc(origin, 0.45, meridian, z_axis, 0, latitude), colors::black, 2);
  sketch.in_front(false);
  sketch.text(0.56 * (std::cos(latitude / 2) * meridian + std::sin(latitude / 2) * z_axis), "λ");
  sketch.arrow(up, up + 0.6 * east, colors::orange, "east", Side::right);
  sketch.arrow(up, up + 0.6 * north, colors::green, "north", Side::above);
  sketch.arrow(up, up + 0.6 * up, colors::purple, "up", Side::right);
  sketch.dot(up, colors::black, 0.9);
  sketch.draw(directory, "globe", 360);
}

/// Attraction, centrifugal force and plumb line; the centrifugal force is drawn some eighty times too large.
void draw_plumb_line(const std::filesystem::path& directory) {
  Sketch sketch;
  const double latitude = 45 * degree;
  const Vector3d place(std::cos(latitude), std::sin(latitude), 0);
  sketch.line(arc(origin, 1, x_axis, y_axis, -0.15, pi + 0.15), colors::grey, 1.5);
  sketch.line({-0.15 * y_axis, 1.0 * y_axis}, colors::vermilion, 1.5, "dt (4,4)");
  sketch.arrow(y_axis, 1.3 * y_axis, colors::vermilion, "{/:Bold Ω}", Side::left);
  sketch.line({place.y() * y_axis, place}, colors::pale, 1.5);
  sketch.line({origin, place}, colors::pale, 1.5);
  const Vector3d attraction = -0.62 * place, centrifugal = 0.2 * x_axis;
  sketch.arrow(place, place + attraction, colors::black);
  sketch.text(place + 0.6 * attraction, "{/:Bold g}", colors::black, Side::left);
  sketch.arrow(place, place + centrifugal, colors::orange, "−{/:Bold Ω} × ({/:Bold Ω} × {/:Bold r})", Side::right);
  sketch.line({place + attraction, place + attraction + centrifugal}, colors::orange, 1.5, "dt (4,4)");
  sketch.arrow(place, place + attraction + centrifugal, colors::green, "{/:Bold g}_{eff}", Side::right);
  sketch.dot(place, colors::black, 0.9);
  sketch.dot(origin, colors::grey, 0.7);
  sketch.draw(directory, "plumb_line", 440);
}

/// Stone and tower from outside, over the equator: a very high tower on an Earth that rotates very fast.
void draw_tower_from_outside(const std::filesystem::path& directory) {
  Sketch sketch;
  const double height = 0.4, rate = 0.42, top = 1 + height;  // GM = R = 1
  // The orbit, in small steps of Störmer and Verlet.
  SpaceCurve orbit{top * y_axis};
  Vector3d r = orbit.front(), v = -rate * top * x_axis;
  const double dt = 1e-3;
  double time = 0;
  while (r.norm() > 1) {
    v -= 0.5 * dt * r / std::pow(r.norm(), 3);
    r += dt * v;
    v -= 0.5 * dt * r / std::pow(r.norm(), 3);
    time += dt;
    if (std::lround(time / dt) % 25 == 0) orbit.push_back(r);
  }
  orbit.push_back(r);
  const Vector3d then = rotated(y_axis, z_axis, rate * time);
  sketch.line(arc(origin, 1, x_axis, y_axis, pi / 2 - 0.5, pi / 2 + 1.0), colors::grey, 2);
  sketch.line(arc(origin, top, x_axis, y_axis, pi / 2, pi / 2 + rate * time), colors::pale, 1.5);
  sketch.line({y_axis, top * y_axis}, colors::black, 4);
  sketch.line({then, top * then}, colors::black, 4);
  sketch.line(orbit, colors::blue, 3);
  // The attraction half-way, and what "down" was at the start.
  const Vector3d middle = orbit[orbit.size() * 2 / 3];
  sketch.arrow(middle, middle - 0.3 * middle.normalized(), colors::vermilion, "attraction", Side::right);
  sketch.line({middle, middle - 0.3 * y_axis}, colors::vermilion, 1.5, "dt (4,4)");
  sketch.arrow(top * y_axis, top * y_axis - 0.35 * rate * top * x_axis, colors::green, "Ω(R + h)", Side::above);
  sketch.dot(top * y_axis, colors::blue, 0.9);
  sketch.dot(r, colors::blue, 0.9);
  sketch.text(1.15 * y_axis, "tower at the start", colors::black, Side::right);
  sketch.text(1.2 * then, "tower at the end", colors::black, Side::left);
  sketch.text(r, "stone", colors::blue, Side::left);
  sketch.draw(directory, "tower_from_outside", 560);
}

/// Foucault's pendulum in a fast rotation, released at rest on the floor and released at rest in the frame in which
/// its plane stands still.
void draw_rosette(const std::filesystem::path& directory) {
  constexpr int points = 240;
  const double swing = 1, Omega_z = 0.1, omega = std::hypot(swing, Omega_z), duration = pi / Omega_z;
  const std::complex<double> i(0, 1);
  const auto place = [&](double t, bool at_rest_on_floor) -> Vector3d {
    const std::complex<double> zeta =
        std::exp(-i * Omega_z * t) *
        (std::cos(omega * t) + (at_rest_on_floor ? i * Omega_z / omega * std::sin(omega * t) : 0));
    return {zeta.real(), zeta.imag(), 0};
  };
  const FigureSize size{600, 350};
  draw_figure(directory, "rosette", size, [&](gnuplotio::Gnuplot& gnuplot) {
    Sketch sketch;
    for (const bool at_rest_on_floor : {true, false}) {
      const Vector3d center(at_rest_on_floor ? -1.3 : 1.3, -0.15, 0);
      sketch.line(circle(center, 1.05), colors::pale, 1.5);
      SpaceCurve path;
      for (int k = 0; k <= points; ++k) path.push_back(center + place(duration * k / points, at_rest_on_floor));
      sketch.line(path, colors::blue, 2);
      sketch.line({center, path.back()}, colors::grey, 1.5);
      sketch.dot(path.back(), colors::black, 1.3);
      sketch.text(center + 1.27 * y_axis,
                  at_rest_on_floor ? "released at rest on the floor" : "given the velocity −{/:Bold Ω}_z × {/:Bold r}");
    }
    sketch.send(gnuplot, size, 2.5);
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
        return (time - t) * coriolis_acceleration(velocity, latitude, Omega_earth).dot(right);
      },
      0.0, time);
}

/// Three effects of one rotation, from pole to pole.
void draw_over_latitude(const std::filesystem::path& directory) {
  using Points = std::vector<std::pair<double, double>>;
  Points fall, pendulum, northward, southward;
  for (int k = -90; k <= 90; k += 2) {
    const double latitude = k * degree;
    fall.emplace_back(k, 1e3 * eastward_deflection(110, latitude, 9.81, Omega_earth));
    // The contract speaks of the northern hemisphere; in the south the plane rotates the other way.
    const double hours = k == 0 ? INFINITY : foucault_period(std::abs(latitude), 2 * pi / Omega_earth) / 3600;
    pendulum.emplace_back(k, std::copysign(360 / hours, latitude));
    northward.emplace_back(k, 1e-3 * drift_to_the_right(latitude, 0, 120e3, 176));
    southward.emplace_back(k, 1e-3 * drift_to_the_right(latitude, pi, 120e3, 176));
  }
  draw_figure(directory, "over_latitude", {580, 640}, [&](gnuplotio::Gnuplot& gnuplot) {
    send_block(gnuplot, "$fall", fall);
    send_block(gnuplot, "$pendulum", pendulum);
    send_block(gnuplot, "$northward", northward);
    send_block(gnuplot, "$southward", southward);
    gnuplot << "set multiplot layout 3,1 margins 0.12,0.97,0.12,0.95 spacing 0.085\n"
               "unset key; set xrange [-90:90]; set xtics 30 format ''; set border 3; set tics nomirror\n"
            << "set xzeroaxis lw 1 lc rgb '" << colors::grey << "'\n"
            << "set title 'A stone from 110 m lands to the east (mm)' offset 0,-0.7\n"
               "set yrange [0:30]; set ytics 10\n"
            << "plot $fall w l lw 3.5 lc rgb '" << colors::blue << "'\n"
            << "set title 'Foucault’s pendulum rotates clockwise (degrees per hour)' offset 0,-0.7\n"
               "set yrange [-18:18]; set ytics 15\n"
            << "plot $pendulum w l lw 3.5 lc rgb '" << colors::green << "'\n"
            << "set title 'A shell, 120 km in 176 s, drifts to its right (km)' offset 0,-0.7\n"
               "set yrange [-2.2:2.2]; set ytics 1; set xtics 30 format '%g°'; set xlabel 'latitude, north positive'\n"
            << "set label 'fired south' at -8,1.1 right tc rgb '" << colors::vermilion << "'\n"
            << "set label 'fired north' at 10,-1.1 left tc rgb '" << colors::purple << "'\n"
            << "plot $northward w l lw 3.5 lc rgb '" << colors::purple << "', $southward w l lw 3.5 lc rgb '"
            << colors::vermilion << "'\nunset multiplot\n";
  });
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"puck", draw_puck},
                       {"two_origins", draw_two_origins},
                       {"globe", draw_globe},
                       {"plumb_line", draw_plumb_line},
                       {"tower_from_outside", draw_tower_from_outside},
                       {"rosette", draw_rosette},
                       {"over_latitude", draw_over_latitude}});
}
