// Figures of lecture 08.
#include "lectures/support/sketch.hpp"

#include <rigid/euler_angles.hpp>
#include <rigid/kinetic_energy.hpp>

#include <fmt/format.h>
#include <boost/numeric/odeint.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using gnuplotio::Gnuplot;
using workbook::arc;
using workbook::Side;
using workbook::Sketch;
namespace colors = workbook::colors;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
const Vector3d origin = Vector3d::Zero();
constexpr const char* vertical_name = "{/:Bold e}@^0_3";
const Vector3d x_axis = Vector3d::UnitX(), y_axis = Vector3d::UnitY(), z_axis = Vector3d::UnitZ();

using PlaneCurve = std::vector<std::pair<double, double>>;
using SpaceCurve = std::vector<Vector3d>;

/// The direction of the body's third axis.
Vector3d axis_at(const Vector3d& angles) { return inertial_components(z_axis, angles); }

/// Angles and rates at equal steps of time under given accelerations.
struct State {
  Vector3d angles, rates;
};

using Accelerations = std::function<Vector3d(const Vector3d& angles, const Vector3d& rates)>;

std::vector<State> motion(const State& start, double duration, int count, const Accelerations& accelerations) {
  using Numbers = std::array<double, 6>;
  Numbers x;
  Vector3d::Map(x.data()) = start.angles;
  Vector3d::Map(x.data() + 3) = start.rates;
  const auto system = [&](const Numbers& now, Numbers& rate, double) {
    const Vector3d q = Vector3d::Map(now.data()), v = Vector3d::Map(now.data() + 3);
    Vector3d::Map(rate.data()) = v;
    Vector3d::Map(rate.data() + 3) = accelerations(q, v);
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<Numbers> stepper;
  std::vector<State> states{start};
  for (int k = 0; k < count; ++k) {
    stepper.do_step(system, x, 0.0, duration / count);
    states.push_back({Vector3d::Map(x.data()), Vector3d::Map(x.data() + 3)});
  }
  return states;
}

SpaceCurve path_of_axis(const std::vector<State>& states) {
  SpaceCurve path;
  for (const State& state : states) path.push_back(axis_at(state.angles));
  return path;
}

/// The parts of a curve on the unit sphere that face the reader.
void draw_front(Sketch& sketch, const SpaceCurve& curve, const char* color, double width) {
  SpaceCurve piece;
  for (const Vector3d& point : curve) {
    if (sketch.faces_reader(point)) {
      piece.push_back(point);
    } else {
      if (piece.size() > 1) sketch.line(piece, color, width);
      piece.clear();
    }
  }
  if (piece.size() > 1) sketch.line(piece, color, width);
}

// ---- energy and momenta ----

void draw_convention(const std::filesystem::path& directory) {
  const Vector3d rates(5, -2, 9);
  const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3), exchanged(racket[1], racket[0], racket[2]);
  const Vector3d symmetric(8.795e-3, 8.795e-3, 17.48e-3);
  workbook::draw_figure(directory, "convention", {590, 380}, [&](Gnuplot& gnuplot) {
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
    label("racket, z–y–z", 70, 1.585, colors::blue);
    label("racket, z–x–z", 160, 1.585, colors::vermilion);
    label("symmetric top, either", 275, 1.585, colors::black);
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
    Side side;
  };
  for (const Axis& axis : {Axis{z_axis, colors::black, vertical_name, "p_φ", Side::right},
                           Axis{nodes, colors::green, "{/:Bold e}_2′", "p_θ", Side::below},
                           Axis{spin, colors::purple, "{/:Bold e}_3", "p_ψ", Side::below}}) {
    const Vector3d foot = L.dot(axis.direction) * axis.direction;
    sketch.line({L, foot}, colors::grey, 1.2, "dt (4,4)");
    sketch.arrow(origin, 1.75 * axis.direction, axis.color, axis.name, Side::left, 1.5);
    sketch.line({origin, foot}, axis.color, 5);
    sketch.dot(foot, axis.color, 0.8);
    sketch.text(0.5 * foot, axis.momentum, axis.color, axis.side);
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
        motion({angles, euler_angle_rates(angles, omega)}, duration, 600,
               [&](const Vector3d& q, const Vector3d& v) { return euler_angle_accelerations(I, q, v); }));
  };
  Sketch sketch({0.3, -1.0, 1.15});
  for (int polar = 15; polar <= 60; polar += 15) {
    const double z = std::cos(polar * degree), radius = std::sin(polar * degree);
    draw_front(sketch, arc(z * z_axis, radius, x_axis, y_axis), colors::pale, 1.2);
    sketch.text(z * z_axis + radius * Vector3d(0.5, -0.866, 0), fmt::format("{}°", polar), colors::grey);
  }
  // Two bodies whose third axis starts at the same inclination.
  const SpaceCurve asymmetric = track(Vector3d(1, 1.8, 2.2), Vector3d(0.8, 0, 1.2), 11.5);
  const SpaceCurve symmetric = track(Vector3d(1.4, 1.4, 2.2), Vector3d(0.8 / 1.4, 0, 1.2), 3.2);
  draw_front(sketch, asymmetric, colors::blue, 2.5);
  draw_front(sketch, symmetric, colors::vermilion, 3.5);
  sketch.dot(asymmetric.front(), colors::black, 0.9);
  sketch.arrow(z_axis, 1.5 * z_axis, colors::black, "{/:Bold L}", Side::right);
  sketch.draw(directory, "free_top", 480);
}

// ---- the heavy top ----

/// The heavy top of the worked examples.
struct HeavyTop {
  double I1 = 3.28e-4, I3 = 6.6e-5, Mgl = 0.0456;  // kg m², kg m², J

  Vector3d accelerations(const Vector3d& q, const Vector3d& v) const {
    // On θ the weight acts with Mgl sin θ, across the line of nodes with nothing: only the second rate feels it.
    return euler_angle_accelerations(Vector3d(I1, I1, I3), q, v) + Vector3d(0, Mgl * std::sin(q[1]) / I1, 0);
  }
  /// Motion from a moment at which the axis has the given rate of precession and no other.
  std::vector<State> moved(double theta, double precession, double omega3, double duration, int count) const {
    return motion({Vector3d(0, theta, 0), Vector3d(precession, 0, omega3 - precession * std::cos(theta))}, duration,
                  count, [this](const Vector3d& q, const Vector3d& v) { return accelerations(q, v); });
  }
  /// Duration of one nutation of a top that is released with its axis at rest: u̇² = (2Mgl/I₁)(u₀−u)(u−u₁)(u₂−u).
  double period(double theta0, double omega3) const {
    const double beta = std::pow(I3 * omega3, 2) / (4 * I1 * Mgl), u0 = std::cos(theta0);
    const double root = std::sqrt(beta * beta - 2 * beta * u0 + 1), u1 = beta - root, u2 = beta + root;
    const int steps = 200;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
      const double u = (u0 + u1) / 2 + (u0 - u1) / 2 * std::cos(pi * (i + 0.5) / steps);
      sum += 1 / std::sqrt(u2 - u);
    }
    return 2 * pi / steps * sum / std::sqrt(2 * Mgl / I1);
  }
};

/// A toy top: a cone on its tip.
void add_top(Sketch& sketch, const Vector3d& tip, const Vector3d& axis) {
  const Vector3d across = axis.unitOrthogonal(), other = axis.cross(across);
  const Vector3d rim = tip + 0.6 * axis;
  const SpaceCurve circle = arc(rim, 0.36, across, other);
  // The cone from the rim to the tip: its outline touches the rim where the normal is at right angles to the sight.
  const double slope = std::atan2(0.36, 0.6);
  const auto normal = [&](double angle) -> Vector3d {
    return std::cos(slope) * (std::cos(angle) * across + std::sin(angle) * other) - std::sin(slope) * axis;
  };
  SpaceCurve front{tip};
  for (int i = 0; i <= 144; ++i) {
    const double angle = 2 * pi * i / 72;
    const bool faces = sketch.faces_reader(normal(angle)), before = sketch.faces_reader(normal(angle - 2 * pi / 72));
    if (faces && (front.size() > 1 || !before))
      front.push_back(rim + 0.36 * (std::cos(angle) * across + std::sin(angle) * other));
    if (!faces && front.size() > 1) break;
  }
  if (front.size() > 2) {
    front.push_back(tip);
    sketch.face(front, colors::purple, 0.3);
    sketch.line(front, colors::purple, 1.5);
  }
  sketch.face(circle, colors::purple, 0.3);
  sketch.line(circle, colors::purple, 1.5);
}

void draw_heavy_top(const std::filesystem::path& directory) {
  Sketch sketch({0.25, -1.0, 0.35});
  const double theta = 35 * degree, azimuth = 0.25;
  const Vector3d axis = axis_at({azimuth, theta, 0});
  const Vector3d center = 0.6 * axis;
  sketch.line(arc({0, 0, 1.15 * std::cos(theta)}, 1.15 * std::sin(theta), x_axis, y_axis), colors::grey, 1.2,
              "dt (5,4)");
  add_top(sketch, origin, axis);
  sketch.face(arc(origin, 0.3, x_axis, y_axis), colors::grey, 0.2);
  sketch.arrow(origin, 1.45 * z_axis, colors::black, vertical_name, Side::left, 1.8);
  sketch.arrow(origin, 1.45 * axis, colors::purple, "{/:Bold e}_3", Side::right, 2.5);
  sketch.arrow(center, center - 0.55 * z_axis, colors::vermilion, "Mg", Side::right, 3);
  sketch.dot(center, colors::black, 0.9);
  sketch.text(0.33 * axis - Vector3d(0.06, 0, 0), "ℓ", colors::black, Side::left);
  sketch.line(arc(origin, 0.95, z_axis, (axis - axis.z() * z_axis).normalized(), 0, theta), colors::black, 1.5);
  sketch.text(1.06 * (z_axis + axis).normalized(), "θ");
  const double height = 1.15 * std::cos(theta), radius = 1.15 * std::sin(theta);
  const SpaceCurve turn = arc({0, 0, height}, radius, x_axis, y_axis, azimuth, azimuth + 0.8);
  sketch.line(turn, colors::green, 3);
  sketch.arrow(turn[turn.size() - 8], turn.back(), colors::green, "φ", Side::above, 3);
  sketch.dot(origin, colors::black, 0.6);
  sketch.text(origin, "tip", colors::black, Side::below);
  sketch.draw(directory, "heavy_top", 400);
}

void draw_effective_potential(const std::filesystem::path& directory) {
  const HeavyTop top;
  const double start = 30 * degree;
  workbook::draw_figure(directory, "effective_potential", {590, 380}, [&](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'θ (degrees)'; set ylabel 'U_{eff} − energy (mJ)'\n"
               "set xrange [20:70]; set yrange [-5:7]; unset key\n";
    const std::array<double, 3> spins{200, 150, 110};
    const std::array<const char*, 3> color{colors::blue, colors::green, colors::vermilion};
    const std::array<std::pair<double, double>, 3> places{{{37.5, 5.8}, {48.5, 4.1}, {54, -2.1}}};
    std::vector<PlaneCurve> curves, turning;
    std::string plot = fmt::format("plot 0 lc rgb '{}' lw 1.5", colors::grey);
    for (std::size_t k = 0; k < spins.size(); ++k) {
      const Vector3d I(top.I1, top.I1, top.I3);
      const Vector3d p = canonical_momenta(I, Vector3d(0, start, 0), Vector3d(0, 0, spins[k]));
      const auto potential = [&](double theta) {
        const double across = (p[0] - p[2] * std::cos(theta)) / std::sin(theta);
        return 1e3 * (across * across / (2 * top.I1) + top.Mgl * (std::cos(theta) - std::cos(start)));
      };
      PlaneCurve curve;
      for (int tenths = 200; tenths <= 700; ++tenths)
        curve.emplace_back(tenths / 10.0, potential(tenths / 10.0 * degree));
      const double beta = p[2] * p[2] / (4 * top.I1 * top.Mgl);
      const double other = std::acos(beta - std::sqrt(beta * beta - 2 * beta * std::cos(start) + 1));
      curves.push_back(curve);
      turning.push_back({{other / degree, 0}});
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

/// The path of the axis of a heavy top, seen from above, for three ways of releasing it.
void draw_paths(const std::filesystem::path& directory) {
  const HeavyTop top;
  const double theta0 = 40 * degree, omega3 = 200;
  struct Release {
    double precession;
    const char* name;
  };
  Sketch sketch;
  int panel = 0;
  for (const Release& release :
       {Release{0, "at rest"}, Release{2.6, "pushed forwards"}, Release{-5, "pushed backwards"}}) {
    const Vector3d at = 2.0 * panel++ * x_axis;
    SpaceCurve path;
    double inner = 1, outer = 0;
    for (const State& state : top.moved(theta0, release.precession, omega3, 2.5, 1200)) {
      if (state.angles[0] > 2 * pi) break;
      const Vector3d n = axis_at(state.angles);
      path.emplace_back(at + Vector3d(n.x(), n.y(), 0));
      inner = std::min(inner, std::hypot(n.x(), n.y()));
      outer = std::max(outer, std::hypot(n.x(), n.y()));
    }
    for (const double radius : {inner, outer})
      sketch.line(arc(at, radius, x_axis, y_axis), colors::grey, 1, "dt (4,4)");
    sketch.line(path, colors::blue, 2.2);
    sketch.dot(path.front(), colors::black, 0.8);
    sketch.arrow(path[24], path[30], colors::blue, "", Side::right, 2.2);
    sketch.dot(at, colors::grey, 0.6);
    sketch.text(at - 1.1 * y_axis, release.name);
  }
  sketch.draw(directory, "paths", 590);
}

/// The top while it nods four times in one turn of precession: the spin is chosen so that the film closes.
void draw_nutation(const std::filesystem::path& directory) {
  const HeavyTop top;
  const double theta0 = 40 * degree;
  const int nods = 4, frames = 32, steps = 5;
  const auto advance = [&](double omega3) {
    return top.moved(theta0, 0, omega3, nods * top.period(theta0, omega3), 600).back().angles[0] - 2 * pi;
  };
  double slow = 110, fast = 250;
  for (int halving = 0; halving < 40; ++halving) {
    const double middle = 0.5 * (slow + fast);
    (advance(middle) > 0 ? slow : fast) = middle;
  }
  const SpaceCurve path = path_of_axis(top.moved(theta0, 0, slow, nods * top.period(theta0, slow), frames * steps));
  const double low = path[static_cast<std::size_t>(frames * steps / nods / 2)].z();
  const workbook::FigureSize size{440, 340};
  workbook::draw_animation(directory, "nutation", size, frames, 5, [&](Gnuplot& gnuplot, int frame) {
    Sketch sketch({0.2, -1.0, 0.6});
    const Vector3d tip = -0.45 * z_axis;  // the picture is centred on the origin
    const auto moved = [&](SpaceCurve curve) {
      for (Vector3d& point : curve) point += tip;
      return curve;
    };
    for (const double z : {std::cos(theta0), low})
      sketch.line(moved(arc(z * z_axis, std::sqrt(1 - z * z), x_axis, y_axis)), colors::grey, 1, "dt (4,4)");
    sketch.line(moved(path), colors::sky, 1.5);
    const auto now = static_cast<std::ptrdiff_t>(frame) * steps;
    if (now > 0) sketch.line(moved({path.begin(), path.begin() + now + 1}), colors::blue, 3);
    const Vector3d& axis = path[static_cast<std::size_t>(now)];
    add_top(sketch, tip, axis);
    sketch.arrow(tip, tip + 1.15 * z_axis, colors::black, vertical_name, Side::left, 1.5);
    sketch.arrow(tip, tip + axis, colors::purple, "{/:Bold e}_3", Side::above, 2.5);
    sketch.send(gnuplot, size, 1.0);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"convention", draw_convention},
                                 {"projections", draw_projections},
                                 {"free_top", draw_free_top},
                                 {"heavy_top", draw_heavy_top},
                                 {"effective_potential", draw_effective_potential},
                                 {"paths", draw_paths},
                                 {"nutation", draw_nutation}});
}
