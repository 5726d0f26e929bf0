// Figures of lecture 09.
#include "lectures/support/motion.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/euler_angles.hpp>
#include <rigid/heavy_top.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;
using gnuplotio::Gnuplot;

namespace {

constexpr double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J: the top of the worked examples

/// The direction of the body's third axis.
Vector3d axis_at(const Vector3d& angles) { return inertial_components(z_axis, angles); }

/// Motion from a moment at which the axis has the given rate of precession and no other.
std::vector<AngleMotion> moved(double theta, double precession, double omega3, double duration, int count) {
  return history({Vector3d(0, theta, 0), Vector3d(precession, 0, omega3 - precession * std::cos(theta))}, duration,
                 count, [](const Vector3d& q, const Vector3d& v) {
                   return heavy_top_accelerations({I1, I1, I3}, Mgl, q, v);
                 });
}

/// A toy top, as in the live figure: a foot, a disc and a stem.
void add_top(Sketch& sketch, const Vector3d& tip, const Vector3d& axis) {
  sketch.turned_body(tip, tip + 0.5 * axis, {{0, 0}, {1, 0.14}}, colors::orange);
  sketch.turned_body(tip + 0.5 * axis, tip + 0.64 * axis, {{0, 0}, {0, 0.42}, {1, 0.42}, {1, 0}}, colors::sky);
  sketch.turned_body(tip + 0.64 * axis, tip + 0.9 * axis, {{0, 0.04}, {1, 0.04}, {1, 0}}, colors::orange);
}

void draw_heavy_top(const std::filesystem::path& directory) {
  Sketch sketch({0.25, -1.0, 0.35});
  const double theta = 35 * degree, azimuth = 0.25;
  const Vector3d axis = axis_at({azimuth, theta, 0});
  const Vector3d center = 0.6 * axis;
  sketch.line(arc({0, 0, 1.15 * std::cos(theta)}, 1.15 * std::sin(theta), x_axis, y_axis), colors::grey, 1.2,
              "dt (5,4)");
  const Vector3d across = axis.unitOrthogonal();
  SpaceCurve shadow = arc(center, 0.42, across, axis.cross(across));
  for (Vector3d& point : shadow) point.z() = 0;
  sketch.face(shadow, colors::grey, 0.25);
  add_top(sketch, origin, axis);
  sketch.arrow(origin, 1.45 * z_axis, colors::black, vertical_name, Side::left, 1.8);
  sketch.arrow(0.9 * axis, 1.45 * axis, colors::purple, "{/:Bold e}_3", Side::right, 2.5);
  sketch.in_front(true);
  sketch.line({origin, center}, colors::black, 1.2, "dt (5,4)");
  sketch.arrow(center, center - 0.55 * z_axis, colors::black, "M{/:Bold g}", Side::right, 3);
  sketch.dot(center, colors::black, 0.9);
  sketch.in_front(false);
  sketch.text(0.33 * axis - Vector3d(0.06, 0, 0), "ℓ", colors::black, Side::left);
  sketch.line(arc(origin, 0.95, z_axis, (axis - axis.z() * z_axis).normalized(), 0, theta), colors::black, 1.5);
  sketch.text(1.06 * (z_axis + axis).normalized(), "θ");
  const double height = 1.15 * std::cos(theta), radius = 1.15 * std::sin(theta);
  const SpaceCurve turn = arc({0, 0, height}, radius, x_axis, y_axis, azimuth, azimuth + 0.8);
  sketch.line(turn, colors::blue, 3);
  sketch.arrow(turn[turn.size() - 8], turn.back(), colors::blue, "φ", Side::above, 3);
  sketch.dot(origin, colors::black, 0.6);
  sketch.text(origin, "tip", colors::black, Side::below);
  sketch.draw(directory, "heavy_top", 400);
}

void draw_effective_potential(const std::filesystem::path& directory) {
  const double start = 30 * degree;
  draw_figure(directory, "effective_potential", {590, 380}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'θ (degrees)'; set ylabel 'U_{eff} − energy (mJ)'\n"
               "set xrange [20:70]; set yrange [-5:7]; unset key\n";
    const std::array<double, 3> spins{200, 150, 110};
    const std::array<const char*, 3> color{colors::blue, colors::green, colors::vermilion};
    const std::array<std::pair<double, double>, 3> places{{{37.5, 5.8}, {47.3, 4.1}, {54, -2.1}}};
    std::vector<PlaneCurve> curves, turning;
    std::string plot = fmt::format("plot 0 lc rgb '{}' lw 1.5", colors::grey);
    for (std::size_t k = 0; k < spins.size(); ++k) {
      const double p_psi = I3 * spins[k], p_phi = p_psi * std::cos(start);
      const auto potential = [&](double theta) { return effective_potential(I1, I3, Mgl, p_phi, p_psi, theta); };
      PlaneCurve curve;
      for (int tenths = 200; tenths <= 700; ++tenths)
        curve.emplace_back(tenths / 10.0, 1e3 * (potential(tenths / 10.0 * degree) - potential(start)));
      curves.push_back(curve);
      turning.push_back({{nutation_limits(I1, I3, Mgl, start, {0, 0, spins[k]})[1] / degree, 0}});
      gnuplot << fmt::format("set label '{} rad/s' at {},{} center front tc rgb '{}'\n", spins[k], places[k].first,
                             places[k].second, color[k]);
      plot += fmt::format(", '-' w l lw 3 lc rgb '{}', '-' w p pt 7 ps 1.3 lc rgb '{}'", color[k], color[k]);
    }
    gnuplot << plot << fmt::format(", '-' w p pt 7 ps 1.3 lc rgb '{}'\n", colors::black);
    for (std::size_t k = 0; k < spins.size(); ++k) {
      gnuplot.send1d(curves[k]);
      gnuplot.send1d(turning[k]);
    }
    gnuplot.send1d(PlaneCurve{{start / degree, 0}});
  });
}

/// Slow and fast precession over the spin, of a top that stands and of one that hangs.
void draw_steady(const std::filesystem::path& directory) {
  draw_figure(directory, "steady", {590, 400}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'spin (rad/s)'; set ylabel 'rate of precession (rad/s)'\n"
               "set xrange [0:250]; set yrange [-60:60]; unset key\n";
    const double theta = 30 * degree, least = 1.00101 * 2 * std::sqrt(I1 * Mgl * std::cos(theta)) / I3;
    const auto curve = [](double inclination, double from, int which) {
      PlaneCurve points;
      for (int k = 0; k <= 400; ++k) {
        const double share = k / 400.0, spin = from + (250 - from) * share * share;  // dense where the curve is steep
        points.emplace_back(spin, steady_precession(I1, I3, Mgl, spin, inclination)[which]);
      }
      return points;
    };
    PlaneCurve gyroscope;
    for (int spin = 12; spin <= 250; ++spin) gyroscope.emplace_back(spin, Mgl / (I3 * spin));
    const auto label = [&](const char* text, double x, double y, const char* color) {
      gnuplot << fmt::format("set label '{}' at {},{} center front tc rgb '{}'\n", text, x, y, color);
    };
    label("standing at 30°: fast", 150, 46, colors::blue);
    label("slow", 140, 12, colors::blue);
    label("gyroscope formula", 66, 33, colors::grey);
    label("hanging at 150°: slow", 185, -5, colors::vermilion);
    label("fast", 140, -29, colors::vermilion);
    gnuplot << fmt::format(
        "plot 0 lc rgb '{0}' lw 1, '-' w l lw 2 dt (6,5) lc rgb '{1}', '-' w l lw 3 lc rgb '{2}', '-' w l lw 3 lc rgb "
        "'{2}', '-' w l lw 3 lc rgb '{3}', '-' w l lw 3 lc rgb '{3}'\n",
        colors::pale, colors::grey, colors::blue, colors::vermilion);
    gnuplot.send1d(gyroscope);
    for (const int which : {0, 1}) gnuplot.send1d(curve(theta, least, which));
    for (const int which : {0, 1}) gnuplot.send1d(curve(pi - theta, 1, which));
  });
}

/// The effective potential of an upright top for four spins.
void draw_upright(const std::filesystem::path& directory) {
  draw_figure(directory, "upright", {590, 380}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'θ (degrees)'; set ylabel 'U_{eff} − U_{eff}(0) (mJ)'\n"
               "set xrange [-70:70]; set xtics 30; set yrange [-3:3]; unset key\n";
    const std::array<double, 4> shares{1.1, 1.0, 0.9, 0.8};
    const std::array<const char*, 4> color{colors::blue, colors::black, colors::green, colors::vermilion};
    const std::array<std::pair<double, double>, 4> places{{{-24, 2.4}, {48, 1.2}, {45, -1.2}, {-28, -2.65}}};
    std::string plot = fmt::format("plot 0 lc rgb '{}' lw 1", colors::pale);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      gnuplot << fmt::format("set label '{:.0f} %' at {},{} center front tc rgb '{}'\n", 100 * shares[k],
                             places[k].first, places[k].second, color[k]);
      plot += fmt::format(", '-' w l lw 3 lc rgb '{}'", color[k]);
    }
    gnuplot << plot << "\n";
    for (const double share : shares) {
      const double p = I3 * share * sleeping_spin(I1, I3, Mgl);
      PlaneCurve curve;
      for (int half = -141; half <= 141; half += 2) {  // not at 0, which is its limit
        const double theta = half / 2.0 * degree;
        const double U = effective_potential(I1, I3, Mgl, p, p, std::abs(theta));
        curve.emplace_back(theta / degree, 1e3 * (U - p * p / (2 * I3) - Mgl));
      }
      gnuplot.send1d(curve);
    }
  });
}

/// The top while it nods four times in one turn of precession: the spin is chosen so that the film closes.
void draw_nutation(const std::filesystem::path& directory) {
  const double theta0 = 40 * degree;
  const int nods = 4, points = 400;
  double slow = 110, fast = 250;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (slow + fast);
    (nods * precession_per_nutation(I1, I3, Mgl, theta0, {0, 0, middle}) > 2 * pi ? slow : fast) = middle;
  }
  const double duration = nods * nutation_period(I1, I3, Mgl, theta0, {0, 0, slow});
  SpaceCurve path;
  for (const AngleMotion& state : moved(theta0, 0, slow, duration, points + 1)) path.push_back(axis_at(state.angles));
  const double low = std::cos(nutation_limits(I1, I3, Mgl, theta0, {0, 0, slow})[1]);
  const FigureSize size{440, 400};
  draw_figure(directory, "nutation", size, [&](Gnuplot& gnuplot) {
    Sketch sketch({0.2, 1.0, 0.6});
    const Vector3d tip = -0.15 * z_axis;  // the picture is centred on the origin
    const auto moved = [&](SpaceCurve curve) {
      for (Vector3d& point : curve) point += tip;
      return curve;
    };
    // On the sphere about the tip.
    sketch.ellipsoid(Matrix3d::Identity(), colors::sky, tip, 0.3);
    for (const double z : {std::cos(theta0), low})
      sketch.line(moved(arc(z * z_axis, std::sqrt(1 - z * z), x_axis, y_axis)), colors::grey, 1);
    sketch.line(moved(path), colors::purple, 1);
    constexpr std::ptrdiff_t now = 150;
    sketch.line(moved({path.begin(), path.begin() + now + 1}), colors::purple, 3.5);
    const Vector3d& axis = path[static_cast<std::size_t>(now)];
    add_top(sketch, tip, axis);
    sketch.arrow(tip, tip + 1.3 * z_axis, colors::black, vertical_name, Side::left, 1.5);
    sketch.arrow(tip + 0.9 * axis, tip + 1.25 * axis, colors::purple, "{/:Bold e}_3", Side::right, 2.5);
    sketch.send(gnuplot, size, 1.25);
  });
}

/// The path of the axis of a heavy top, seen from above, for four ways of releasing it.
void draw_paths(const std::filesystem::path& directory) {
  const double theta0 = 40 * degree, omega3 = 200;
  struct Release {
    double precession;
    const char* name;
    std::size_t arrow;  // where on the outer side of the track
  };
  Sketch sketch;
  int panel = 0;
  for (const Release& release : {Release{0, "at rest", 36}, Release{2.6, "+2.6 rad/s", 36}, Release{-5, "−5 rad/s", 36},
                                 Release{10, "+10 rad/s", 74}}) {
    const int row = panel / 2;
    const Vector3d at = 1.75 * (panel % 2) * x_axis - 1.9 * row * y_axis;
    ++panel;
    SpaceCurve path;
    double inner = 1, outer = 0;
    for (const AngleMotion& state : moved(theta0, release.precession, omega3, 2.5, 1201)) {
      if (state.angles[0] > 2 * pi) break;
      const Vector3d tip = axis_at(state.angles);
      path.emplace_back(at + Vector3d(tip.x(), tip.y(), 0));
      inner = std::min(inner, std::hypot(tip.x(), tip.y()));
      outer = std::max(outer, std::hypot(tip.x(), tip.y()));
    }
    for (const double radius : {inner, outer})
      sketch.line(arc(at, radius, x_axis, y_axis), colors::grey, 1, "dt (4,4)");
    sketch.line(path, colors::purple, 2.2);
    sketch.dot(path.front(), colors::black, 0.8);
    sketch.arrow(path[release.arrow], path[release.arrow + 12], colors::purple, "", Side::right, 2.2);
    sketch.dot(at, colors::grey, 0.6);
    sketch.text(at - 0.95 * y_axis, release.name);
  }
  sketch.draw(directory, "paths", 460);
}

/// A flattened planet, the pull of the sun at its bulge, and where its axis goes.
void draw_planet(const std::filesystem::path& directory) {
  Sketch sketch({0.45, -1.0, 0.4});
  const double tilt = 28 * degree;
  const Vector3d axis(std::sin(tilt), 0, std::cos(tilt)), near(std::cos(tilt), 0, -std::sin(tilt));
  sketch.ellipsoid(Matrix3d::Identity() - 0.25 * axis * axis.transpose(), colors::sky);
  sketch.line(arc(origin, 1, near, axis.cross(near)), colors::grey, 2.5);
  sketch.line(arc(origin, 1.75, x_axis, y_axis), colors::grey, 1, "dt (4,4)");
  sketch.arrow(1.75 * x_axis, 2.4 * x_axis, colors::orange, "sun", Side::right, 2.5);
  for (const double side : {1.0, -1.0}) {
    sketch.arrow(side * near, side * (near + 0.6 * x_axis), colors::vermilion, "F",
                 side > 0 ? Side::below : Side::above, 3.5);
    sketch.dot(side * near, colors::vermilion, 0.9);
  }
  // The axis, the normal of the orbit, and the circle between them.
  const double length = 1.9, height = length * std::cos(tilt), radius = length * std::sin(tilt);
  sketch.arrow(origin, 2.15 * z_axis, colors::black, "{/:Bold N}", Side::left, 1.5);
  sketch.arrow(origin, length * axis, colors::blue, "{/:Bold L}", Side::right, 3);
  sketch.line(arc({0, 0, height}, radius, x_axis, y_axis), colors::grey, 1.2, "dt (5,4)");
  const SpaceCurve turn = arc({0, 0, height}, radius, x_axis, Vector3d(-y_axis), 0, 0.9);
  sketch.line(turn, colors::green, 3);
  sketch.arrow(turn[turn.size() - 8], turn.back(), colors::green, "", Side::left, 3);
  sketch.text(turn[turn.size() / 2] + Vector3d(0, 0, 0.13), "d{/:Bold L}", colors::green);
  sketch.line(arc(origin, 1.2, z_axis, x_axis, 0, tilt), colors::black, 1.3);
  sketch.text(1.32 * (z_axis + axis).normalized(), "ε");
  sketch.draw(directory, "planet", 480);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"heavy_top", draw_heavy_top},
                       {"effective_potential", draw_effective_potential},
                       {"steady", draw_steady},
                       {"upright", draw_upright},
                       {"nutation", draw_nutation},
                       {"paths", draw_paths},
                       {"planet", draw_planet}});
}
