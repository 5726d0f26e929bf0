// Figures of lecture 05.
#include "lectures/support/figure.hpp"

#include <rigid/euler_equations.hpp>

#include <fmt/format.h>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;

namespace {

namespace colors = workbook::colors;

using Curve = std::vector<std::pair<double, double>>;
using Step = std::function<Vector3d(const Vector3d&, double)>;

constexpr double degree = std::numbers::pi / 180;

/// The lecture's free top. Its L² exceeds 2T I₂, so L circles axis 3.
struct FreeTop {
  Vector3d I{1, 2, 3};
  Vector3d omega0{0.1, 1, 0.1};

  Vector3d rate(const Vector3d& omega) const { return euler_equations(I, omega, Vector3d::Zero()); }

  /// The exact solution by Jacobi's functions, with the modulus as Boost wants it.
  Vector3d exact(double t) const {
    const Vector2d invariants = rotation_invariants(I, omega0);
    const double below = invariants[1] - 2 * invariants[0] * I[0], above = 2 * invariants[0] * I[2] - invariants[1];
    const Vector3d amplitudes =
        Vector3d(above / (I[0] * (I[2] - I[0])), above / (I[1] * (I[2] - I[1])), below / (I[2] * (I[2] - I[0])))
            .cwiseSqrt();
    const double k = std::sqrt(above * (I[1] - I[0]) / (below * (I[2] - I[1])));
    const double start = boost::math::ellint_1(k, std::atan2(omega0[1] / amplitudes[1], omega0[0] / amplitudes[0]));
    double cn = 0, dn = 0;
    const double sn =
        boost::math::jacobi_elliptic(k, std::sqrt(below * (I[2] - I[1]) / I.prod()) * t + start, &cn, &dn);
    return amplitudes.cwiseProduct(Vector3d(cn, sn, dn));
  }
};

Step explicit_euler(const FreeTop& top) {
  return [top](const Vector3d& omega, double h) -> Vector3d { return omega + h * top.rate(omega); };
}

Step midpoint(const FreeTop& top) {
  return [top](const Vector3d& omega, double h) -> Vector3d {
    return omega + h * top.rate(omega + h / 2 * top.rate(omega));
  };
}

Step runge_kutta(const FreeTop& top) {
  return [top](const Vector3d& omega, double h) -> Vector3d {
    const Vector3d k1 = top.rate(omega), k2 = top.rate(omega + h / 2 * k1);
    const Vector3d k3 = top.rate(omega + h / 2 * k2), k4 = top.rate(omega + h * k3);
    return omega + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  };
}

/// ω at every step.
std::vector<Vector3d> followed(const FreeTop& top, const Step& step, double h, int steps) {
  std::vector<Vector3d> omega{top.omega0};
  for (int i = 0; i < steps; ++i) omega.push_back(step(omega.back(), h));
  return omega;
}

/// Relative change of an invariant (0: T, 1: L²) since the start; what is below the last digit is drawn there.
Curve drift_of(const FreeTop& top, const std::vector<Vector3d>& omega, double h, int invariant) {
  const double start = rotation_invariants(top.I, top.omega0)[invariant];
  Curve curve;
  for (std::size_t i = 4; i < omega.size(); i += 4) {
    const double now = rotation_invariants(top.I, omega[i])[invariant];
    curve.emplace_back(static_cast<double>(i) * h, std::max(std::abs(now / start - 1), 1.1e-16));
  }
  return curve;
}

void draw_integrators(const std::filesystem::path& directory) {
  const FreeTop top;
  const double h = 0.1, duration = 60;
  const int steps = static_cast<int>(duration / h);

  struct Rule {
    const char* name;
    const char* style;
    double label_at;  // height of the label in the lower panels
    std::vector<Vector3d> omega;
  };
  std::vector<Vector3d> exact;
  for (int i = 0; i <= steps; ++i) exact.push_back(top.exact(i * h));
  const std::array<Rule, 4> rules = {
      {{"explicit Euler", "dt 2 lw 2.5 lc rgb '#D55E00'", 1e2, followed(top, explicit_euler(top), h, steps)},
       {"midpoint", "dt 4 lw 2.5 lc rgb '#E69F00'", 1e-5, followed(top, midpoint(top), h, steps)},
       {"Runge-Kutta", "dt 1 lw 2.5 lc rgb '#0072B2'", 1e-9, followed(top, runge_kutta(top), h, steps)},
       {"exact", "dt 3 lw 2 lc rgb '#000000'", 4e-14, exact}}};

  workbook::draw_figure(directory, "integrators", {560, 900}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set multiplot layout 3,1\n"
               "unset key; set lmargin 11; set rmargin 3; set xrange [0:60]; set xtics 10\n"
               "set title 'ω in the body: exact (lines), explicit Euler (dots)' offset 0,-0.5\n"
               "set ylabel 'ω (rad/s)'; set yrange [-1.9:1.9]; set ytics 1; set xlabel 'time (s)'\n"
               "set label 1 '{/:Italic ω}_1' at 1.2,-0.95 tc rgb '#0072B2'; set label 2 '{/:Italic ω}_2' at 13.4,-1.35 "
               "tc rgb '#009E73'\n"
               "set label 3 '{/:Italic ω}_3' at 6.6,0.95 tc rgb '#CC79A7'\n";
    const std::array<const char*, 3> component_colors = {colors::blue, colors::green, colors::purple};
    gnuplot << "plot ";
    for (const char* color : component_colors) gnuplot << fmt::format("'-' w l lw 2.5 lc rgb '{}', ", color);
    for (int i = 0; i < 3; ++i) {
      gnuplot << fmt::format("'-' w p pt {} ps 0.5 lc rgb '{}'{}", std::array{7, 6, 5}[i], component_colors[i],
                             i < 2 ? ", " : "\n");
    }
    for (const auto& [omega, stride] : {std::pair{rules[3].omega, 1}, std::pair{rules[0].omega, 5}}) {
      for (int i = 0; i < 3; ++i) {
        Curve curve;
        for (std::size_t k = 0; k < omega.size(); k += stride)
          curve.emplace_back(static_cast<double>(k) * h, omega[k][i]);
        gnuplot.send1d(curve);
      }
    }

    gnuplot << "unset label\nset logscale y; set format y '10^{%T}'; set yrange [3e-17:1e5]; set ytics 1e-16,1e4; set "
               "mytics 1\n";
    for (int invariant = 0; invariant < 2; ++invariant) {
      const char* symbol = invariant == 0 ? "T" : "L²";
      gnuplot << fmt::format("set title 'how far {0} has drifted'; set ylabel '|Δ{0}| / {0}'\n", symbol);
      for (std::size_t r = 0; r < rules.size(); ++r) {
        gnuplot << fmt::format("set label {} '{}' at 59,{} right\n", r + 1, rules[r].name, rules[r].label_at);
      }
      gnuplot << "plot ";
      for (std::size_t r = 0; r < rules.size(); ++r)
        gnuplot << fmt::format("'-' w l {}{}", rules[r].style, r + 1 < rules.size() ? ", " : "\n");
      for (const Rule& rule : rules) gnuplot.send1d(drift_of(top, rule.omega, h, invariant));
    }
    gnuplot << "unset multiplot\n";
  });
}

/// One body on its axle, seen along the torque: the axle upright, the body's own axis tilted by `tilt` to the right.
struct SkewedBody {
  std::string title;
  Vector3d moments;
  std::vector<Curve> outline;  // in the body: across and along its own axis
};

void draw_skewed_bodies(const std::filesystem::path& directory) {
  const double tilt = 25 * degree;
  const std::array<SkewedBody, 2> bodies = {
      {{"thin wheel, I_3 = 2 I_1",
        Vector3d(1, 1, 2),
        {{{-1.0, -0.04}, {1.0, -0.04}, {1.0, 0.04}, {-1.0, 0.04}, {-1.0, -0.04}}}},
       {"dumbbell, I_3 = 0", Vector3d(1, 1, 0), {{{0, -1}, {0, 1}}}}}};

  workbook::draw_figure(directory, "skewed_bodies", {560, 360}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set multiplot layout 1,2\nunset key; unset border; unset tics; unset grid; unset xlabel; unset ylabel\n"
               "set size ratio -1; set xrange [-1.35:1.35]; set yrange [-1.45:1.75]\n"
               "set lmargin 0.5; set rmargin 0.5; set bmargin 0.5\n";
    for (const SkewedBody& body : bodies) {
      // The body's axis points up to the right; on the page x is across the axle and y along it.
      const auto on_page = [&](double across, double along) {
        return std::pair{across * std::cos(tilt) + along * std::sin(tilt),
                         -across * std::sin(tilt) + along * std::cos(tilt)};
      };
      const Vector3d omega_body(-std::sin(tilt), 0, std::cos(tilt));  // upright on the page, |ω| = 1
      const Vector3d L_body = body.moments.cwiseProduct(omega_body);
      const Vector3d torque = torque_to_hold_rotation(body.moments.asDiagonal(), omega_body);
      const auto [L_x, L_y] = on_page(L_body.x(), L_body.z());
      const double drawn = 1.15 / L_body.norm();
      // Across and along the body's axis are its axes 1 and 3, so its axis 2 points into the page.
      const bool into_page = torque.y() > 0;

      gnuplot << "unset label; unset arrow\nset title '" << body.title << "'\n"
              << "set arrow from 0,-1.05 to 0,1.35 nohead dt 3 lw 1.5 lc rgb '#7F7F7F'\n"
              << "set arrow from 0,0 to 0,1.35 front filled lw 3 lc rgb '" << colors::blue << "'\n"
              << "set label '{/:Italic ω}' at -0.08,1.55 right tc rgb '" << colors::blue << "'\n"
              << fmt::format("set arrow from 0,0 to {:.4f},{:.4f} nohead dt 2 lw 1.5 lc rgb '#7F7F7F'\n",
                             1.3 * std::sin(tilt), 1.3 * std::cos(tilt))
              << fmt::format("set label 'axis 3' at {:.4f},{:.4f} left tc rgb '#444444'\n", 1.36 * std::sin(tilt),
                             1.36 * std::cos(tilt))
              << fmt::format("set arrow from 0,0 to {:.4f},{:.4f} front filled lw 3 lc rgb '{}'\n", L_x * drawn,
                             L_y * drawn, colors::vermilion)
              << fmt::format("set label '{{/:Italic L}}' at {:.4f},{:.4f} center tc rgb '{}'\n",
                             L_x * drawn - (L_x > 0 ? 0.12 : 0.1), L_y * drawn + 0.1, colors::vermilion)
              << fmt::format("set label '{{/:Italic τ}} {}' at 0,-1.3 center tc rgb '{}'\n",
                             into_page ? "⊗ into the page" : "⊙ out of the page", colors::green);
      gnuplot << "plot ";
      for (std::size_t i = 0; i < body.outline.size(); ++i) gnuplot << "'-' w l lw 4 lc rgb '#444444', ";
      gnuplot << "'-' w p pt 7 ps 2.6 lc rgb '#444444'\n";
      for (const Curve& outline : body.outline) {
        Curve curve;
        for (const auto& [across, along] : outline) curve.push_back(on_page(across, along));
        gnuplot.send1d(curve);
      }
      const bool is_dumbbell = body.moments[2] == 0;
      gnuplot.send1d(is_dumbbell ? Curve{on_page(0, -1), on_page(0, 1)} : Curve{on_page(0, 0)});
    }
    gnuplot << "unset multiplot\n";
  });
}

void draw_holding_torque(const std::filesystem::path& directory) {
  struct Shape {
    const char* name;
    double ratio;  // I₃/I₁
    const char* style;
    double label_x, label_y;
  };
  const std::array<Shape, 4> shapes = {{{"thin wheel, I_3 = 2 I_1", 2.0, "dt 1 lc rgb '#D55E00'", 45, 0.55},
                                        {"thick disc, I_3 = 1.3 I_1", 1.3, "dt 2 lc rgb '#E69F00'", 45, 0.2},
                                        {"sphere, cube: none", 1.0, "dt 3 lc rgb '#000000'", 45, -0.05},
                                        {"rod, dumbbell, I_3 = 0", 0.0, "dt 4 lc rgb '#0072B2'", 45, -0.55}}};

  workbook::draw_figure(directory, "holding_torque", {560, 400}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot
        << "unset key; set xlabel 'angle between ω and the body''s axis 3 (degrees)'; set ylabel 'torque / (I_1 ω^2)'\n"
           "set xrange [0:90]; set xtics 15; set yrange [-0.65:0.65]; set ytics 0.25\n";
    for (const Shape& shape : shapes) {
      gnuplot << fmt::format("set label '{}' at {},{} center\n", shape.name, shape.label_x, shape.label_y);
    }
    gnuplot << "plot ";
    for (std::size_t i = 0; i < shapes.size(); ++i)
      gnuplot << "'-' w l lw 3 " << shapes[i].style << (i + 1 < shapes.size() ? ", " : "\n");
    for (const Shape& shape : shapes) {
      Curve curve;
      for (int angle = 0; angle <= 90; ++angle) {
        const Vector3d omega(-std::sin(angle * degree), 0, std::cos(angle * degree));
        const Matrix3d I = Vector3d(1, 1, shape.ratio).asDiagonal();
        curve.emplace_back(angle, torque_to_hold_rotation(I, omega).y());
      }
      gnuplot.send1d(curve);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"skewed_bodies", draw_skewed_bodies},
                                 {"holding_torque", draw_holding_torque},
                                 {"integrators", draw_integrators}});
}
