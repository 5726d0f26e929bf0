// Figures of lecture 10.
#include "lectures/support/motion.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/attitude_of_a_free_body.hpp>
#include <rigid/free_tops.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

using namespace rigid;
using namespace workbook;
using gnuplotio::Gnuplot;

namespace {

/// The crate of the lecture, kg m², and two motions, rad/s.
const Vector3d crate(1.2, 2, 2.7), about_3(0.4, -0.9, 0.6), about_1(0.9, -0.5, 0.2);

/// `count` moments of a motion in a frame in which L points along `up`.
std::vector<Motion> with_L_along(const Vector3d& up, const Vector3d& I, const Vector3d& omega0, double duration,
                                 int count) {
  const Matrix3d A = shortest_turn(I.cwiseProduct(omega0), up);
  std::vector<Motion> motion;
  for (int i = 0; i < count; ++i) {
    const double t = duration * i / (count - 1);
    motion.push_back({exact_rotation(I, omega0, t), A * exact_attitude(I, omega0, t)});
  }
  return motion;
}

/// The ellipsoid of energy lies on the plane on which it rolls; L points down.
void draw_poinsot(const std::filesystem::path& directory) {
  Sketch sketch({0.75, -1.0, 0.42});
  const Vector3d I = crate, omega0 = about_3;
  const double P = tumbling_period(I, omega0), height = poinsot(I, omega0)[0];
  const Vector2d radii = herpolhode_radii(I, omega0);
  const Vector3d foot = -height * z_axis;
  const auto motion = with_L_along(-z_axis, I, omega0, 3 * P, 721);
  const Motion& now = motion[40];
  const Vector3d half_axes = (I.dot(omega0.cwiseAbs2()) * I.cwiseInverse()).cwiseSqrt();

  sketch.face(arc(foot, 1.55, x_axis, y_axis), colors::pale, 0.5);
  for (const double radius : {radii[0], radii[1]})
    sketch.line(arc(foot, radius, x_axis, y_axis), colors::grey, 1.5, "dt (5,4)");
  SpaceCurve herpolhode;
  for (const Motion& each : motion) herpolhode.emplace_back(each.A * each.omega);
  sketch.line(herpolhode, colors::vermilion, 1.5);

  const Matrix3d shape = now.A * half_axes.asDiagonal();
  sketch.ellipsoid(shape, colors::sky);
  for (int axis = 0; axis < 3; ++axis) {
    SpaceCurve circle = arc(origin, 1, Vector3d::Unit((axis + 1) % 3), Vector3d::Unit((axis + 2) % 3));
    for (Vector3d& point : circle) point = shape * point;
    sketch.line(circle, colors::grey, 1);
  }
  SpaceCurve polhode;
  for (int i = 0; i <= 240; ++i) polhode.emplace_back(now.A * motion[static_cast<std::size_t>(i)].omega);
  sketch.line(polhode, colors::blue, 3.5);

  const Vector3d contact = now.A * now.omega;
  sketch.line({foot, contact}, colors::black, 2);
  sketch.arrow(origin, 1.45 * foot, colors::blue, "{/:Bold L}", Side::right);
  sketch.arrow(origin, contact, colors::vermilion, "", Side::left);
  sketch.text(0.62 * contact - 0.1 * x_axis, "{/:Bold ω}", colors::vermilion, Side::left);
  sketch.text(0.55 * foot + 0.04 * x_axis, "h", colors::black, Side::right);
  sketch.text(foot + Vector3d(1.1, 0.55, 0), "plane at rest", colors::black, Side::centre);
  sketch.dot(foot, colors::black, 0.6);
  sketch.dot(contact, colors::black, 0.8);
  sketch.draw(directory, "poinsot", 560);
}

/// The herpolhode, seen along L, for both kinds of motion.
void draw_herpolhode(const std::filesystem::path& directory) {
  Sketch sketch;
  struct Panel {
    Vector3d omega0;
    const char* name;
    double place, scale;
  };
  for (const Panel& panel : {Panel{about_3, "round axis 3", -1.2, 2.2}, Panel{about_1, "round axis 1", 1.2, 2.2}}) {
    const double P = tumbling_period(crate, panel.omega0);
    const Vector3d center = panel.place * x_axis;
    const Vector2d radii = panel.scale * herpolhode_radii(crate, panel.omega0);
    const auto motion = with_L_along(z_axis, crate, panel.omega0, 6 * P, 1801);
    SpaceCurve curve;
    for (const Motion& each : motion) {
      Vector3d tip = panel.scale * (each.A * each.omega);
      tip[2] = 0;
      curve.emplace_back(center + tip);
    }
    for (const double radius : {radii[0], radii[1]})
      sketch.line(arc(center, radius, x_axis, y_axis), colors::grey, 1.5, "dt (5,4)");
    sketch.line({curve.begin() + 300, curve.end()}, colors::sky, 1);
    sketch.line({curve.begin(), curve.begin() + 301}, colors::blue, 3.5);
    sketch.line({curve[300], center, curve[0]}, colors::black, 1);
    sketch.dot(center, colors::black, 0.5);
    sketch.dot(curve[0], colors::black, 0.9);
    sketch.dot(curve[300], colors::black, 0.9);
    sketch.text(center + 0.55 * (curve[0] - center), "0", colors::black, Side::below);
    sketch.text(center + 0.55 * (curve[300] - center), "P", colors::black, Side::left);
    const double turn = std::fmod(turn_per_period(crate, panel.omega0), 2 * pi);
    sketch.text(center - 1.13 * y_axis, panel.name);
    sketch.text(center - 1.3 * y_axis, fmt::format("one period turns it by {:.1f}°", turn / degree));
  }
  sketch.draw(directory, "herpolhode", 590);
}

/// The path of the tip of axis 3 on a sphere about L.
void draw_track(const std::filesystem::path& directory) {
  Sketch sketch({0.3, -1.0, 0.9});
  const double P = tumbling_period(crate, about_3);
  const auto motion = with_L_along(z_axis, crate, about_3, 4 * P, 1601);
  const Vector3d start = motion[0].A.col(2);
  const Eigen::AngleAxisd to_the_left(-2.6 - std::atan2(start[1], start[0]), z_axis);
  SpaceCurve track;
  for (const Motion& each : motion) track.emplace_back(to_the_left * each.A.col(2));
  sketch.ellipsoid(Matrix3d::Identity(), colors::sky);
  const auto is_lower = [](const Vector3d& one, const Vector3d& other) { return one[2] < other[2]; };
  const auto [lowest, highest] = std::minmax_element(track.begin(), track.end(), is_lower);
  for (const double height : {(*lowest)[2], (*highest)[2]}) {
    const SpaceCurve circle = arc(height * z_axis, std::sqrt(1 - height * height), x_axis, y_axis);
    sketch.line(circle, colors::grey, 1.5);
  }
  const SpaceCurve later(track.begin() + 400, track.end()), first(track.begin(), track.begin() + 401);
  sketch.line(later, colors::purple, 1);
  sketch.line(first, colors::purple, 3.5);
  sketch.arrow(origin, 1.6 * z_axis, colors::blue, "{/:Bold L}", Side::right);
  sketch.arrow(origin, 1.2 * track[0], colors::purple, "{/:Bold e}_3", Side::left, 2.5);
  sketch.dot(track[0], colors::black, 0.9);
  sketch.dot(track[400], colors::black, 0.9);
  sketch.text(track[0], "0", colors::black, Side::below);
  sketch.text(track[400], "P", colors::black, Side::right);
  sketch.draw(directory, "track", 480);
}

/// The closed path of the direction of L on the axes of the body.
SpaceCurve path_of_L(const Vector3d& I, const Vector3d& omega0) {
  SpaceCurve path;
  const double P = tumbling_period(I, omega0);
  for (int i = 0; i <= 240; ++i) path.emplace_back(I.cwiseProduct(exact_rotation(I, omega0, P * i / 240)).normalized());
  return path;
}

/// Two solid angles on the sphere of the directions of L in the body.
void draw_solid_angle(const std::filesystem::path& directory) {
  Sketch sketch({1.0, 0.9, 0.85});
  sketch.ellipsoid(Matrix3d::Identity(), colors::sky);
  const auto draw_path = [&](const Vector3d& omega0, const char* color) {
    const SpaceCurve path = path_of_L(crate, omega0);
    // The part of the sphere within, in rings.
    const Vector3d middle = std::accumulate(path.begin(), path.end(), origin).normalized();
    const auto inside = [&](std::size_t i, int ring) -> Vector3d {
      return 1.01 * (ring * path[i] + (4 - ring) * middle).normalized();
    };
    for (int ring = 0; ring < 4; ++ring)
      for (std::size_t i = 0; i < 240; i += 8)
        sketch.face({inside(i, ring), inside(i, ring + 1), inside(i + 8, ring + 1), inside(i + 8, ring)}, color, 0.35);
    sketch.line(path, color, 3.5);
    for (const std::size_t at : {30U, 150U}) sketch.arrow(path[at - 3], path[at + 3], color, "", Side::right, 2.5);
  };
  draw_path({0.45, 0.2, 0.9}, colors::purple);
  draw_path({0.9, 0.2, 0.2}, colors::vermilion);
  sketch.text(Vector3d(0.06, 0.2, 0.97), "S", colors::black);
  sketch.text(Vector3d(0.97, 0.2, 0.12), "S", colors::black);
  const std::array<const char*, 3> names{"{/:Bold e}_1", "{/:Bold e}_2", "{/:Bold e}_3"};
  for (int i = 0; i < 3; ++i)
    sketch.arrow(Vector3d::Unit(i), 1.6 * Vector3d::Unit(i), axis_colors[static_cast<std::size_t>(i)],
                 names[static_cast<std::size_t>(i)], i == 0 ? Side::left : Side::right, 2.5);
  sketch.draw(directory, "solid_angle", 480);
}

/// How far a racket twists in one round, in degrees; thrown with ω so many degrees off axis 2, towards the handle and
/// the normal.
double twist(const Vector2d& off) {
  const Vector3d racket(1.21e-3, 16.38e-3, 17.48e-3);  // kg m²
  return std::abs(racket_twist(racket, {std::tan(off.x() * degree), 1, std::tan(off.y() * degree)})) / degree;
}

/// The first place on the way from a place on the map at which the twist leaves a range, or the map ends.
Vector2d edge(const Vector2d& from, const Vector2d& way, double least, double most) {
  const auto is_inside = [&](double length) {
    const Vector2d place = from + length * way;
    return place.cwiseAbs().maxCoeff() < 20 && twist(place) > least && twist(place) < most;
  };
  double inside = 0, outside = 0.5;
  for (; is_inside(outside); outside += 0.5) inside = outside;
  for (int halving = 0; halving < 12; ++halving) {
    const double middle = (inside + outside) / 2;
    (is_inside(middle) ? inside : outside) = middle;
  }
  return from + outside * way;
}

/// The regions of the map by their edges: each is seen whole from a place within, or lies along the rising diagonal.
void draw_twist_map(const std::filesystem::path& directory) {
  PlaneCurve half_turn, same_face;
  const Vector2d within(-14, 4), corner(-20, 20), diagonal = Vector2d(1, -1).normalized();
  const double first = std::atan2((corner - within).y(), (corner - within).x());
  for (int k = 0; k < 240; ++k) {
    const double angle = first + 2 * pi * k / 240;
    const Vector2d place = edge(within, {std::cos(angle), std::sin(angle)}, 150, 210);
    half_turn.emplace_back(place.x(), place.y());
  }
  for (const double side : {1.0, -1.0}) {
    for (int k = -50; k <= 50; ++k) {
      const Vector2d on_diagonal = Vector2d::Constant(19.999 * side * k / 50);
      const Vector2d place = edge(on_diagonal, side * diagonal, -1, 90);
      same_face.emplace_back(place.x(), place.y());
    }
  }
  PlaneCurve opposite;  // half a turn about axis 2 reverses both angles
  for (const auto& [x, y] : half_turn) opposite.emplace_back(-x, -y);
  draw_figure(directory, "twist_map", {540, 500}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set size ratio -1; set xrange [-20:20]; set yrange [-20:20]\n"
               "set xtics 10; set ytics 10; set tics out; unset grid; set style fill solid 1\n"
               "set xlabel 'ω off axis 2, towards the handle (°)'\n"
               "set ylabel 'ω off axis 2, towards the normal (°)'\n"
            << fmt::format(
                   "set object rectangle from -20,-20 to 20,20 behind fc rgb '{1}' fs noborder\n"
                   "set label 'half a turn, ±30°' at -6,8.5 center front tc rgb '{0}'\n"
                   "set label 'half a turn, ±30°' at 6,-8.5 center front tc rgb '{0}'\n"
                   "set label 'other face up' at -4,17.2 center front tc rgb '{0}'\n"
                   "set label 'other face up' at 4,-17.2 center front tc rgb '{0}'\n"
                   "set label 'same face up' at 8.4,1.2 left front tc rgb '{0}'\n"
                   "set arrow from 8,1.6 to 3.5,3.2 head filled size 1,18 front lc rgb '{0}'\n",
                   colors::black, colors::shade);
    std::string plot = "plot ";
    for (const char* color : {colors::sky, colors::sky, colors::orange})
      plot += fmt::format("'-' with filledcurves closed fc rgb '{}', ", color);
    gnuplot << plot.substr(0, plot.size() - 2) << "\n";
    for (const PlaneCurve& region : {half_turn, opposite, same_face}) gnuplot.send1d(region);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"poinsot", draw_poinsot},
                       {"herpolhode", draw_herpolhode},
                       {"track", draw_track},
                       {"solid_angle", draw_solid_angle},
                       {"twist_map", draw_twist_map}});
}
