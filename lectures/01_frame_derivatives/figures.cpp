// Figures of lecture 01.
#include "lectures/support/figure.hpp"

#include <rigid/frame_derivatives.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
namespace colors = workbook::colors;

namespace {

using Curve = std::vector<std::pair<double, double>>;

constexpr double pi = std::numbers::pi;

/// Position in the y–z plane, seen from the tip of the x axis.
std::pair<double, double> in_plane(const Vector3d& vector) { return {vector.y(), vector.z()}; }

Vector3d turned(const Vector3d& vector, const Vector3d& rotation_vector) {
  return rotated_basis(Matrix3d::Identity(), rotation_vector, 1.0) * vector;
}

std::string arrow(const Vector3d& from, const Vector3d& to, const char* color, const std::string& style) {
  return fmt::format("set arrow from {:.5f},{:.5f} to {:.5f},{:.5f} {} lc rgb '{}' front\n", from.y(), from.z(), to.y(),
                     to.z(), style, color);
}

/// A dashed arrow whose head is whole.
std::string dashed_arrow(const Vector3d& from, const Vector3d& to, const char* color) {
  const Vector3d neck = from + 0.9 * (to - from);
  return arrow(from, neck, color, "nohead lw 3 dt (4,2)") + arrow(neck, to, color, "lw 3");
}

std::string label(const std::string& text, double x, double y, const char* color, const std::string& style = "center") {
  return fmt::format("set label \"{}\" at {:.4f},{:.4f} {} front tc rgb '{}'\n", text, x, y, style, color);
}

Curve circle() {
  Curve points;
  for (int k = 0; k <= 180; ++k)
    points.push_back(in_plane(turned(Vector3d::UnitY(), 2 * pi * k / 180 * Vector3d::UnitX())));
  return points;
}

/// e_y and e_z, where they turn to, and the first-order step between.
void draw_turning_basis(const std::filesystem::path& directory) {
  const double angle = 0.45;
  const Vector3d dTheta(angle, 0, 0);
  workbook::draw_figure(directory, "turning_basis", {720, 560}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; set size ratio -1; set xrange [-0.75:1.65]; set yrange [-0.2:1.4]\n"
               "set xlabel 'component along y'; set ylabel 'component along z'; set xtics 0.5; set ytics 0.5\n";
    struct Entry {
      Vector3d e;
      const char* color;
    };
    const Entry entries[] = {{Vector3d::UnitY(), colors::blue}, {Vector3d::UnitZ(), colors::vermilion}};
    for (const auto& [e, color] : entries) {
      const Vector3d after = turned(e, dTheta);
      gnuplot << arrow(Vector3d::Zero(), e, color, "lw 3") << dashed_arrow(Vector3d::Zero(), after, color)
              << arrow(e, e + dTheta.cross(e), colors::black, "lw 3");
    }
    gnuplot << label("{/:Bold e_y}", 0.62, -0.08, colors::blue)
            << label("{/:Bold e_y} turned", 0.49, 0.40, colors::blue)
            << label("{/:Bold e_z}", 0.09, 0.62, colors::vermilion)
            << label("{/:Bold e_z} turned", -0.46, 0.52, colors::vermilion)
            << label("d{/:Bold e}_y = d{/:Bold Θ} × {/:Bold e}_y", 1.03, 0.30, colors::black, "left")
            << label("d{/:Bold e}_z = d{/:Bold Θ} × {/:Bold e}_z", -0.22, 1.10, colors::black)
            << label("dΘ", 0.40, 0.09, colors::grey)
            << label("x axis and d{/:Bold Θ}: towards you", 0.55, 1.28, colors::grey);
    Curve arc;
    for (int k = 0; k <= 20; ++k) {
      const auto [y, z] = in_plane(0.32 * turned(Vector3d::UnitY(), angle * k / 20 * Vector3d::UnitX()));
      arc.emplace_back(y, z);
    }
    gnuplot << "plot '-' w l lw 2 lc rgb '" << colors::grey << "', '-' w l lw 2 lc rgb '" << colors::grey
            << "', '-' w p pt 7 ps 1.3 lc rgb '" << colors::grey << "'\n";
    gnuplot.send1d(circle());
    gnuplot.send1d(arc);
    gnuplot.send1d(Curve{{0, 0}});
  });
}

/// One turn in twelve steps, by the first order and exactly.
void draw_leaving_the_circle(const std::filesystem::path& directory) {
  const int steps = 12;
  const Vector3d dTheta = 2 * pi / steps * Vector3d::UnitX();
  Vector3d first_order = Vector3d::UnitY();
  Matrix3d exact = Matrix3d::Identity();
  Curve spiral{in_plane(first_order)}, points{in_plane(exact.col(1))};
  for (int k = 0; k < steps; ++k) {
    first_order += dTheta.cross(first_order);
    exact = rotated_basis(exact, dTheta, 1.0);
    spiral.push_back(in_plane(first_order));
    points.push_back(in_plane(exact.col(1)));
  }
  workbook::draw_figure(directory, "leaving_the_circle", {720, 600}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; set size ratio -1; set xrange [-3.2:4.8]; set yrange [-4:2.2]\n"
               "set xlabel 'component along y'; set ylabel 'component along z'\n"
            << label("start", 1.25, -0.35, colors::black, "left")
            << label(fmt::format("first order, 12 steps: length {:.3f}", first_order.norm()), 0.8, -3.65,
                     colors::vermilion)
            << label("exact: back at the start", 0, -1.4, colors::blue)
            << arrow(Vector3d::Zero(), Vector3d::UnitY(), colors::black, "lw 3");
    gnuplot << "plot '-' w l lw 2 lc rgb '" << colors::grey << "', '-' w lp lw 3 dt (4,2) pt 9 ps 1.3 lc rgb '"
            << colors::vermilion << "', '-' w p pt 7 ps 1.4 lc rgb '" << colors::blue << "'\n";
    gnuplot.send1d(circle());
    gnuplot.send1d(spiral);
    gnuplot.send1d(points);
  });
}

/// The tip of a vector that grows on a turning basis, and the two parts of its velocity.
void draw_two_sources(const std::filesystem::path& directory) {
  const Vector3d omega(0.9, 0, 0);
  const Vector3d along(0, 1, 0);  // on the basis, V points along e_y and grows
  const double growth = 0.55;
  const auto length = [&](double t) { return 0.6 + growth * t; };
  const auto vector = [&](double t) -> Vector3d { return turned(length(t) * along, t * omega); };
  const double now = 1.1;

  const Vector3d V = vector(now);
  const Vector3d rate_body = turned(growth * along, now * omega);
  const Vector3d rate = inertial_rate(rate_body, omega, V);
  Curve trail;
  for (int k = 0; k <= 120; ++k) trail.push_back(in_plane(vector(2.2 * k / 120)));

  workbook::draw_figure(directory, "two_sources_of_change", {720, 560}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "unset key; set size ratio -1; set xrange [-1.3:1.6]; set yrange [-0.25:2.25]\n"
               "set xlabel 'component along y (m)'; set ylabel 'component along z (m)'; set xtics 0.5; set ytics 0.5\n"
            << arrow(Vector3d::Zero(), V, colors::black, "lw 3") << arrow(V, V + rate_body, colors::blue, "lw 3")
            << dashed_arrow(V, V + rate - rate_body, colors::vermilion) << arrow(V, V + rate, colors::green, "lw 4")
            << label("{/:Bold V}", 0.38, 0.38, colors::black)
            << label("(d{/:Bold V}/dt)_{body}", 1.0, 1.42, colors::blue, "left")
            << label("{/:Bold ω} × {/:Bold V}", 0.02, 1.18, colors::vermilion, "center")
            << label("(d{/:Bold V}/dt)_{inertial}", 0.16, 2.12, colors::green, "left")
            << label("path of the tip", 0.86, 0.35, colors::grey, "left");
    const auto ghost = [](const Vector3d& a, const Vector3d& b) { return Curve{in_plane(a), in_plane(b)}; };
    gnuplot << "plot '-' w l lw 2.5 lc rgb '" << colors::grey << "', '-' w l lw 1 dt 3 lc rgb '" << colors::grey
            << "', '-' w l lw 1 dt 3 lc rgb '" << colors::grey << "'\n";
    gnuplot.send1d(trail);
    gnuplot.send1d(ghost(V + rate_body, V + rate));
    gnuplot.send1d(ghost(V + rate - rate_body, V + rate));
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"two_sources_of_change", draw_two_sources},
                                 {"turning_basis", draw_turning_basis},
                                 {"leaving_the_circle", draw_leaving_the_circle}});
}
