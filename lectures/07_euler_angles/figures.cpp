// Figures of lecture 07.
#include "lectures/support/sketch.hpp"

#include <rigid/euler_angles.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using namespace workbook;
using gnuplotio::Gnuplot;

namespace {

/// The body axes as columns, on the inertial axes.
Matrix3d triad(const Vector3d& angles) { return rotation_matrix(angles).transpose(); }

// ---- the three rotations ----

/// Sketches side by side in one: a panel is an offset in the plane of the picture.
class Panels {
 public:
  /// What follows is drawn in the panel with its origin here.
  void move_to(double right, double up) { offset_ = right * sketch_.right() + up * sketch_.up(); }
  void title(const std::string& text, double up) { sketch_.text(offset_ + up * sketch_.up(), text); }
  void disc(const Vector3d& first, const Vector3d& second, const char* color) {
    sketch_.face(arc(offset_, 1, first, second), color, 0.15);
    sketch_.line(arc(offset_, 1, first, second), color, 1.2);
  }
  void axis(const Vector3d& along, const char* color, const std::string& name, Side side, double width = 2.5) {
    sketch_.arrow(offset_, offset_ + 1.2 * along, color, name, side, width);
  }
  void old_axis(const Vector3d& along, const std::string& name, Side side) {
    sketch_.line({offset_, offset_ + 1.2 * along}, colors::grey, 1.5, "dt (5,4)");
    if (!name.empty()) sketch_.text(offset_ + 1.2 * along, name, colors::grey, side);
  }
  void angle(const Vector3d& from, const Vector3d& to, const std::string& name, double radius = 0.75) {
    const Vector3d across = (to - to.dot(from) * from).normalized();
    const double size = std::acos(to.dot(from));
    sketch_.line(arc(offset_, radius, from, across, 0, size), colors::black, 2);
    if (!name.empty()) sketch_.text(offset_ + (radius + 0.14) * (from + to).normalized(), name);
  }
  void line(const Vector3d& from, const Vector3d& to, const char* color) {
    sketch_.line({offset_ + from, offset_ + to}, color, 2, "dt (8,5)");
  }
  void draw(const std::filesystem::path& directory, const std::string& name, int width) const {
    sketch_.draw(directory, name, width, false);
  }

 private:
  Sketch sketch_{{-0.1, 1.0, 0.5}};
  Vector3d offset_ = origin;
};

void draw_three_turns(const std::filesystem::path& directory) {
  const double phi = 35 * degree, theta = 50 * degree, psi = 45 * degree;
  const Matrix3d first = triad({phi, 0, 0}), second = triad({phi, theta, 0}), third = triad({phi, theta, psi});
  const Vector3d nodes = first.col(1);
  Panels panels;
  const auto place = [&](int column, int row, const char* title) {
    panels.move_to(3.1 * column, -2.65 * row);
    panels.title(title, 1.4);
  };

  place(0, 0, "1: φ about the vertical");
  panels.disc(x_axis, y_axis, colors::grey);
  panels.old_axis(x_axis, "{/:Bold e}@^0_1", Side::left);
  panels.old_axis(y_axis, "{/:Bold e}@^0_2", Side::below);
  panels.axis(first.col(0), colors::orange, "", Side::below);
  panels.axis(nodes, colors::green, "{/:Bold e}_2′", Side::right);
  panels.axis(z_axis, colors::blue, vertical_name, Side::right, 5);
  panels.angle(x_axis, first.col(0), "φ");
  panels.angle(y_axis, nodes, "φ");

  place(1, 0, "2: θ about the line of nodes");
  panels.disc(z_axis, first.col(0), colors::green);
  panels.old_axis(first.col(0), "", Side::left);
  panels.old_axis(z_axis, vertical_name, Side::right);
  panels.axis(second.col(0), colors::orange, "{/:Bold e}_1′", Side::below);
  panels.axis(second.col(2), colors::purple, "{/:Bold e}_3", Side::left);
  panels.axis(nodes, colors::green, "{/:Bold e}_2′", Side::right, 5);
  panels.angle(first.col(0), second.col(0), "θ");
  panels.angle(z_axis, second.col(2), "θ");

  place(0, 1, "3: ψ about the body's axis");
  panels.disc(second.col(0), nodes, colors::purple);
  panels.old_axis(second.col(0), "{/:Bold e}_1′", Side::below);
  panels.old_axis(nodes, "{/:Bold e}_2′", Side::right);
  panels.axis(third.col(0), colors::orange, "{/:Bold e}_1", Side::below);
  panels.axis(third.col(1), colors::green, "{/:Bold e}_2", Side::right);
  panels.axis(third.col(2), colors::purple, "{/:Bold e}_3", Side::left, 5);
  panels.angle(second.col(0), third.col(0), "ψ");
  panels.angle(nodes, third.col(1), "ψ");

  place(1, 1, "all three");
  panels.disc(x_axis, y_axis, colors::grey);
  panels.disc(second.col(0), nodes, colors::purple);
  panels.line(-1.2 * nodes, 1.2 * nodes, colors::green);
  panels.old_axis(y_axis, "{/:Bold e}@^0_2", Side::below);
  panels.axis(z_axis, colors::blue, vertical_name, Side::right);
  panels.axis(third.col(2), colors::purple, "{/:Bold e}_3", Side::left);
  panels.axis(nodes, colors::green, "{/:Bold e}_2′", Side::right);
  panels.axis(third.col(1), colors::black, "{/:Bold e}_2", Side::right);
  panels.angle(y_axis, nodes, "φ");
  panels.angle(z_axis, third.col(2), "θ");
  panels.angle(nodes, third.col(1), "ψ", 0.6);
  panels.draw(directory, "three_turns", 540);
}

/// The vertical in the plane of the second rotation, and the line of nodes in the plane of the third.
void draw_two_planes(const std::filesystem::path& directory) {
  const double theta = 35 * degree, psi = 30 * degree;
  Sketch sketch;
  const auto ray = [](double angle) { return Vector3d(std::cos(angle), std::sin(angle), 0); };
  const auto projection = [&](const Vector3d& from, const Vector3d& foot) {
    sketch.line({from, foot}, colors::grey, 1.2, "dt (4,4)");
  };
  // Left: seen along the line of nodes, which points away from the reader.
  const Vector3d e3 = ray(pi / 2 - theta), e1 = ray(-theta);
  sketch.line({-0.75 * e1, origin}, colors::orange, 1, "dt (5,4)");
  sketch.arrow(origin, 1.25 * e1, colors::orange, "{/:Bold e}_1′", Side::right);
  sketch.arrow(origin, 1.25 * e3, colors::purple, "{/:Bold e}_3", Side::right);
  sketch.arrow(origin, y_axis, colors::blue, vertical_name, Side::above);
  sketch.line(arc(origin, 0.5, x_axis, y_axis, pi / 2 - theta, pi / 2), colors::black, 1.5);
  sketch.text(0.62 * ray(pi / 2 - theta / 2), "θ");
  projection(y_axis, std::cos(theta) * e3);
  projection(y_axis, -std::sin(theta) * e1);
  sketch.text(0.62 * std::cos(theta) * e3, "cos θ", colors::purple, Side::right);
  sketch.text(-0.5 * std::sin(theta) * e1, "−sin θ", colors::orange, Side::left);
  sketch.dot(origin, colors::green, 0.9);
  sketch.text({-0.1, -0.2, 0}, "{/:Bold e}_2′, into the page", colors::green, Side::left);
  // Right: seen from the tip of the body's third axis.
  const Vector3d at(3.2, 0, 0), first = ray(psi), second = ray(psi + pi / 2);
  sketch.arrow(at, at + 1.25 * first, colors::orange, "{/:Bold e}_1", Side::right);
  sketch.arrow(at, at + 1.25 * second, colors::black, "{/:Bold e}_2", Side::left);
  sketch.arrow(at, at + 1.1 * x_axis, colors::grey, "{/:Bold e}_1′", Side::right, 1.5);
  sketch.arrow(at, at + y_axis, colors::green, "{/:Bold e}_2′", Side::above);
  sketch.line(arc(at, 0.5, x_axis, y_axis, pi / 2, pi / 2 + psi), colors::black, 1.5);
  sketch.text(at + 0.62 * ray(pi / 2 + psi / 2), "ψ");
  projection(at + y_axis, at + std::cos(psi) * second);
  projection(at + y_axis, at + std::sin(psi) * first);
  sketch.text(at + 0.55 * std::cos(psi) * second, "cos ψ", colors::black, Side::left);
  sketch.text(at + 0.62 * std::sin(psi) * first + Vector3d(0.12, -0.02, 0), "sin ψ", colors::orange, Side::right);
  sketch.dot(at, colors::purple, 0.9);
  sketch.text(at, "{/:Bold e}_3, out of the page", colors::purple, Side::below);
  sketch.draw(directory, "two_planes", 590);
}

// ---- gimbal lock ----

/// A rotor in two rings, and the axes of the three rates, for three inclinations.
void draw_gimbal_lock(const std::filesystem::path& directory) {
  Sketch sketch({1.0, 0.3, 0.3});
  int panel = 0;
  for (const double theta : {60.0, 8.0}) {
    const Vector3d at = 3.4 * panel++ * sketch.right();
    const Matrix3d axes = triad({-20 * degree, theta * degree, 0});
    const Vector3d &nodes = axes.col(1), &spin = axes.col(2);
    sketch.text(at - 1.45 * sketch.up(), fmt::format("θ = {}°", theta));
    sketch.ring(at, z_axis.cross(nodes), 1.1, 0.05, colors::blue);
    sketch.ring(at, spin.cross(nodes), 0.9, 0.05, colors::green);
    const auto rod = [&](const Vector3d& from, const Vector3d& to, double radius, const char* color) {
      sketch.turned_body(at + from, at + to, {{0, 0}, {0, radius}, {1, radius}, {1, 0}}, color);
    };
    rod(-0.06 * spin, 0.06 * spin, 0.55, colors::purple);
    rod(-0.9 * spin, 0.9 * spin, 0.03, colors::purple);
    for (const double side : {1.0, -1.0}) rod(0.9 * side * nodes, 1.1 * side * nodes, 0.03, colors::green);
    sketch.arrow(at + 1.1 * z_axis, at + 1.5 * z_axis, colors::blue, vertical_name,
                 theta > 10 ? Side::left : Side::right);
    sketch.arrow(at + 0.9 * spin, at + 1.7 * spin, colors::purple, "{/:Bold e}_3", Side::left);
    sketch.arrow(at + 1.1 * nodes, at + 1.5 * nodes, colors::green, "{/:Bold e}_2′", Side::right);
  }
  sketch.draw(directory, "gimbal_lock", 590, false);
}

/// A body that rotates steadily about an axis near the horizontal: its third axis passes close to the vertical.
void draw_passage(const std::filesystem::path& directory) {
  draw_figure(directory, "passage", {590, 410}, [](Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'angle of the steady rotation (degrees)'; set ylabel 'φ (degrees)'\n"
               "set xrange [-90:90]; set yrange [-110:110]; set xtics 30; set ytics 30; unset key\n";
    struct Pass {
      double closest;
      const char* color;
      double x, y;
    };
    const std::array<Pass, 3> passes{
        {{30, colors::green, 54, 56}, {10, colors::blue, 42, 69}, {2, colors::vermilion, 24, 96}}};
    std::string plot;
    std::vector<PlaneCurve> curves;
    for (const Pass& pass : passes) {
      const double closest = pass.closest * degree;
      const Vector3d axis(-std::cos(closest), 0, std::sin(closest));
      PlaneCurve phi, sum;
      for (int i = -360; i <= 360; ++i) {
        const Matrix3d A = Eigen::AngleAxisd(0.25 * i * degree, axis) * triad({0, closest, 0});
        const Vector3d angles = euler_angles(A.transpose());
        phi.emplace_back(0.25 * i, angles[0] / degree);
        sum.emplace_back(0.25 * i, std::remainder(angles[0] + angles[2], 2 * pi) / degree);
      }
      plot += fmt::format("{} '-' w l lw 3 lc rgb '{}'", plot.empty() ? "plot" : ",", pass.color);
      curves.push_back(phi);
      gnuplot << fmt::format("set label '{}°' at {},{} center front tc rgb '{}'\n", pass.closest, pass.x, pass.y,
                             pass.color);
      if (&pass == &passes.back()) {
        plot += fmt::format(", '-' w l lw 2 dt (6,4) lc rgb '{}'", pass.color);
        curves.push_back(sum);
        gnuplot << fmt::format("set label 'φ + ψ, at 2°' at -55,9 center front tc rgb '{}'\n", pass.color);
      }
    }
    gnuplot << plot << "\n";
    for (const PlaneCurve& curve : curves) gnuplot.send1d(curve);
  });
}

// ---- one list of numbers, two motions ----

void draw_two_readings(const std::filesystem::path& directory) {
  // A nodding top: it goes round steadily and dips five times in two turns.
  const auto angles_at = [](double turns) {
    return Vector3d(2 * pi * turns, 0.7 + 0.25 * std::cos(2 * pi * 2.5 * turns), 0);
  };
  const auto tip_zyz = [&](double turns) -> Vector3d { return inertial_components(z_axis, angles_at(turns)); };
  // z–x–z: the same numbers, but the second rotation is about the x′ axis.
  const auto tip_zxz = [&](double turns) -> Vector3d {
    const Vector3d angles = angles_at(turns);
    return Eigen::AngleAxisd(angles[0], z_axis) * (Eigen::AngleAxisd(angles[1], x_axis) * z_axis);
  };
  Sketch sketch;
  sketch.line(arc(origin, 1, x_axis, y_axis), colors::grey, 1.5);
  sketch.text({0, 0.9, 0}, "θ = 90°", colors::grey);
  sketch.dot(origin, colors::grey, 0.5);
  sketch.text(origin, vertical_name, colors::grey, Side::left);
  const auto track = [&](const auto& tip, const char* color, const char* style, const char* name, Side side) {
    std::vector<Vector3d> curve;
    for (int i = 0; i <= 200; ++i) {
      const Vector3d p = tip(0.6 * i / 200);
      curve.emplace_back(p.x(), p.y(), 0);
    }
    sketch.line(curve, color, 3, style);
    sketch.dot(curve.front(), color, 1);
    sketch.text(curve.front(), name, color, side);
    sketch.arrow(curve[190], curve[200], color, "", side, 3);
  };
  track(tip_zyz, colors::blue, "", "z–y–z", Side::below);
  track(tip_zxz, colors::vermilion, "dt (10,5)", "z–x–z", Side::below);
  sketch.draw(directory, "two_readings", 360);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"three_turns", draw_three_turns},
                       {"two_planes", draw_two_planes},
                       {"two_readings", draw_two_readings},
                       {"passage", draw_passage},
                       {"gimbal_lock", draw_gimbal_lock}});
}
