// Figures of lecture 06.
#include "lectures/support/motion.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/free_tops.hpp>

#include <fmt/format.h>

#include <algorithm>
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

using Point = std::pair<double, double>;
using Plot = std::vector<Point>;

const Vector3d flat_body(1, 2, 3);

/// dω/dt of a free body.
Vector3d rate_of(const Vector3d& I, const Vector3d& omega) {
  return I.cwiseProduct(omega).cross(omega).cwiseQuotient(I);
}

Plot component(const std::vector<Motion>& motion, double duration, int index, double factor = 1) {
  Plot curve;
  for (std::size_t i = 0; i < motion.size(); ++i)
    curve.emplace_back(duration * static_cast<double>(i) / static_cast<double>(motion.size() - 1),
                       factor * motion[i].omega[index]);
  return curve;
}

// ---- the symmetric top

/// A cone with its apex at `apex`, with lines that are fixed in it; one sees through it where its opacity is below 1.
void draw_cone(Sketch& sketch, const Vector3d& apex, const Vector3d& axis, const Vector3d& first, double half_angle,
               const char* color, double opacity, int lines) {
  const Vector3d second = axis.cross(first);
  const auto rim = [&](double angle) -> Vector3d {
    return apex + std::cos(half_angle) * axis +
           std::sin(half_angle) * (std::cos(angle) * first + std::sin(angle) * second);
  };
  const Vector3d center = apex + std::cos(half_angle) * axis;
  sketch.turned_body(apex, center, {{0, 0}, {1, std::sin(half_angle)}}, color, origin, opacity);
  sketch.line(arc(center, std::sin(half_angle), first, second), color, 2);
  for (int i = 0; i < lines; ++i) sketch.line({apex, rim(2 * pi * i / lines)}, color, 0.7);
}

/// The body cone rolls on the space cone: a long top and a flattened one.
void draw_cones(const std::filesystem::path& directory) {
  struct Top {
    const char* name;
    double ratio;  // I₃/I₁
    double tilt;   // of the axis from L, so that the motion repeats after one round
    int lines;
    double place;
  };
  const std::array<Top, 2> tops{{{"long, I_3 = I_1 / 2", 0.5, std::acos(0.75), 8, -1.15},
                                 {"flattened, I_3 = 1.8 I_1", 1.8, std::acos(0.9), 10, 1.2}}};
  const FigureSize size{600, 320};
  draw_figure(directory, "cones", size, [&](Gnuplot& gnuplot) {
    Sketch sketch({0, -1, 0.42});
    for (const Top& top : tops) {
      const Vector3d at(top.place, 0, -0.7);
      const double opening = std::atan(top.ratio * std::tan(top.tilt));  // of ω from the axis
      // At the rates of the lecture: dφ/dt = L/I₁ and dψ/dt = −Ω.
      const Vector3d omega(std::tan(opening), 0, 1);
      const double round = pi + 0.8;
      const double own = -round * body_precession_rate(1, top.ratio, 1) / space_precession_rate(1, top.ratio, omega);
      const Vector3d outward(std::cos(round), std::sin(round), 0);
      const auto leaning = [&](double angle) -> Vector3d {
        return std::sin(angle) * outward + std::cos(angle) * z_axis;
      };
      const Vector3d axis = leaning(top.tilt);
      const Vector3d first = Eigen::AngleAxisd(own, axis) * leaning(top.tilt - pi / 2);
      draw_cone(sketch, at, z_axis, x_axis, std::abs(top.tilt - opening), colors::orange, 1, 0);
      draw_cone(sketch, at, axis, first, opening, colors::blue, top.ratio < 1 ? 1 : 0.3, top.lines);
      const auto name = [&](const Vector3d& direction, double length, const char* color, const char* text) {
        sketch.arrow(at, at + length * direction, color);
        sketch.text(at + (length + 0.17) * direction, text, color);
      };
      name(axis, 1.35, colors::purple, "{/:Bold e}_3");
      name(z_axis, 1.4, colors::blue, "{/:Bold L}");
      name(leaning(top.tilt - opening), 1.2, colors::vermilion, "{/:Bold ω}");
      sketch.text(Vector3d(top.place, 0, -1.0), top.name);
    }
    sketch.send(gnuplot, size, 2.1);
  });
}

/// Ω/ω₃ of uniform cylinders, from the plate to the pencil.
void draw_cylinders(const std::filesystem::path& directory) {
  const auto rate = [](double x) { return body_precession_rate((3 + x * x) / 12, 0.5, 1); };  // x = h/r
  Plot curve;
  for (int i = 0; i <= 160; ++i) curve.emplace_back(0.04 * i, rate(0.04 * i));
  struct Body {
    const char* name;
    double x, dx, dy;
  };
  const std::array<Body, 4> bodies{{{"plate, coin", 0.02, 0.3, 0.06},
                                    {"ice-hockey puck", 2 / 3.0, 0.15, 0.05},
                                    {"behaves like a sphere: h = √3 r", std::sqrt(3.0), 0.15, 0.1},
                                    {"tin of food", 2.97, 0.15, 0.09}}};
  draw_figure(directory, "cylinders", {560, 340}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set xlabel 'height / radius of the cylinder'; set ylabel 'Ω / ω̃_3'\n"
               "set xrange [0:6.4]; set yrange [-1.1:1.3]; set ytics 0.5\n"
            << fmt::format("set label 'pencil →' at 6.2,-0.68 right front tc rgb '{}'\n", colors::black)
            << fmt::format("set xzeroaxis lt 1 lw 1 lc rgb '{}'\n", colors::grey);
    Plot dots;
    for (const Body& body : bodies) {
      dots.emplace_back(body.x, rate(body.x));
      gnuplot << fmt::format("set label '{}' at {},{} left front tc rgb '{}'\n", body.name, body.x + body.dx,
                             rate(body.x) + body.dy, colors::black);
    }
    gnuplot << fmt::format(
        "plot -1 with lines lw 1.5 dt (5,4) lc rgb '{}', '-' with lines lw 3 lc rgb '{}', '-' with "
        "points pt 7 ps 0.7 lc rgb '{}'\n",
        colors::grey, colors::blue, colors::black);
    gnuplot.send1d(curve);
    gnuplot.send1d(dots);
  });
}

/// A plate in flight, at eight moments of one turn of its emblem.
void draw_plate(const std::filesystem::path& directory) {
  const double tilt = 20 * degree, radius = 0.95;
  Sketch sketch({0, -1, 0.55});
  const Vector3d right = sketch.right(), up = sketch.up();
  const std::array<const char*, 8> parts{"", "1/8", "1/4", "3/8", "1/2", "5/8", "3/4", "7/8"};
  for (int i = 0; i < 8; ++i) {
    // The emblem goes round by φ + ψ, and the tilt by φ, with dψ/dt = −½ cos θ dφ/dt.
    const double emblem = 2 * pi * i / 8, phi = emblem / (1 - std::cos(tilt) / 2), psi = emblem - phi;
    const Matrix3d A =
        (Eigen::AngleAxisd(phi, z_axis) * Eigen::AngleAxisd(tilt, y_axis) * Eigen::AngleAxisd(psi, z_axis))
            .toRotationMatrix();
    const int column = i % 4, row = i / 4;
    const Vector3d center = 2.35 * column * right - 2.75 * row * up;
    const Vector3d e1 = A.col(0), e2 = A.col(1), e3 = A.col(2);
    // L, as long as the axis, and on the ground the shadow.
    const Vector3d ground = center - 0.95 * z_axis;
    SpaceCurve shadow = arc(ground, radius, e1, e2);
    for (Vector3d& point : shadow) point.z() = ground.z();
    sketch.face(shadow, colors::grey, 0.25);
    const double thick = 0.06;
    sketch.turned_body(center - thick * e3, center + thick * e3, {{0, 0}, {0, 0.8 * radius}, {1, radius}, {1, 0}},
                       colors::sky);
    const Vector3d rim = center + 1.2 * thick * e3, emblem_at = rim - 0.8 * radius * e2;
    sketch.line(arc(rim, 0.6 * radius, e1, e2), colors::blue, 1);
    sketch.face(arc(emblem_at, 0.13, e1, e2), colors::vermilion, 1);
    sketch.arrow(rim, rim + 0.75 * z_axis, colors::blue, i == 0 ? "{/:Bold L}" : "", Side::left, 2);
    sketch.arrow(rim, rim + 0.75 * e3, colors::purple, i == 0 ? "{/:Bold e}_3" : "", Side::right, 2.5);
    sketch.text(center - 1.38 * up, i == 0 ? "start" : fmt::format("{} turn", parts[static_cast<std::size_t>(i)]));
  }
  sketch.draw(directory, "plate", 600, false);
}

// ---- near an axis

void draw_slip(const std::filesystem::path& directory) {
  const Vector3d I(2, 3, 1);
  const double omega3 = 5, amplitude = 1e-5, duration = 3;
  const Vector2d rates = linearized_rates(I, omega3);
  const Plot exact = component(history(I, {{amplitude, 0, omega3}}, duration, 151), duration, 1, 1e5);
  Plot slides, corrected;
  for (int i = 0; i <= 150; ++i) {
    const double t = duration * i / 150;
    slides.emplace_back(t, std::sqrt(rates[1] / rates[0]) * std::sin(std::sqrt(rates.prod()) * t));
    if (i % 6 == 3) corrected.emplace_back(t, 1e5 * linearized_top(I, omega3, amplitude, 0, t)[1]);
  }
  draw_figure(directory, "slip", {560, 360}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set xlabel 'time (s)'; set ylabel 'ω̃_2 (10^{-5} rad/s)'\n"
               "set xrange [0:3]; set yrange [-0.95:0.95]; set ytics 0.5\n"
            << fmt::format("set xzeroaxis lt 1 lw 1 lc rgb '{}'\n", colors::grey)
            << fmt::format("set label 'as printed on the slides' at 0.3,0.74 left front tc rgb '{}'\n",
                           colors::vermilion)
            << fmt::format("set label 'Euler''s equations' at 0.3,-0.72 left front tc rgb '{}'\n", colors::blue)
            << fmt::format("set label '○ formula with sgn(Ω_1)' at 1.55,-0.72 left front tc rgb '{}'\n", colors::black)
            << fmt::format(
                   "plot '-' with lines lw 2.5 dt (9,5) lc rgb '{}', '-' with lines lw 3 lc rgb '{}', '-' with "
                   "points pt 6 ps 0.9 lw 1.5 lc rgb '{}'\n",
                   colors::vermilion, colors::blue, colors::black);
    gnuplot.send1d(slides);
    gnuplot.send1d(exact);
    gnuplot.send1d(corrected);
  });
}

/// How the two small components move near each axis.
void draw_portraits(const std::filesystem::path& directory) {
  const Vector3d I = flat_body;
  Sketch sketch;
  const std::array<const char*, 3> names{"smallest moment", "intermediate moment", "largest moment"};
  for (int axis = 0; axis < 3; ++axis) {
    const int one = (axis + 1) % 3, two = (axis + 2) % 3;
    const Vector3d center(2.5 * axis, 0, 0);
    // p ω_one² + q ω_two² is constant.
    const double p = I[one] * (I[one] - I[axis]), q = I[two] * (I[two] - I[axis]);
    const char* color = axis_colors[static_cast<std::size_t>(axis)];
    const auto mark = [&](double u, double v) {
      Vector3d omega = Vector3d::Unit(axis);
      omega[one] = 1e-3 * u;
      omega[two] = 1e-3 * v;
      const Vector3d rate = rate_of(I, omega);
      const Vector3d step = 0.12 * Vector3d(rate[one], rate[two], 0).normalized();
      sketch.arrow(center + Vector3d(u, v, 0) - step, center + Vector3d(u, v, 0) + step, color, "", Side::right, 2);
    };
    sketch.line({center - 1.1 * x_axis, center + 1.1 * x_axis}, colors::grey, 1);
    sketch.line({center - 1.1 * y_axis, center + 1.25 * y_axis}, colors::grey, 1);
    if (p * q > 0) {
      const double longest = std::max(1 / std::sqrt(std::abs(p)), 1 / std::sqrt(std::abs(q)));
      for (const double size : {0.35, 0.65, 0.95}) {
        const double a = size / std::sqrt(std::abs(p)) / longest, b = size / std::sqrt(std::abs(q)) / longest;
        sketch.line(arc(center, 1, a * x_axis, b * y_axis), color, 2);
        if (size > 0.9) mark(a, 0), mark(-a, 0);
      }
    } else {
      const double slope = std::sqrt(-p / q);
      const double reach = 1 / std::max(1.0, slope);
      for (const double sign : {1.0, -1.0}) {
        sketch.line({center - reach * Vector3d(1, sign * slope, 0), center + reach * Vector3d(1, sign * slope, 0)},
                    colors::black, 2.4);
        for (const double size : {0.3, 0.6}) {
          SpaceCurve left, upper;
          for (int i = -24; i <= 24; ++i) {
            const double s = std::sinh(i / 10.0), c = std::cosh(i / 10.0);
            const Vector3d through_x(sign * size * c, size * slope * s, 0);
            const Vector3d through_y(size * s / slope * 0.58, sign * size * c * 0.58, 0);
            if (through_x.cwiseAbs().maxCoeff() < 1.02) left.push_back(center + through_x);
            if (through_y.cwiseAbs().maxCoeff() < 1.02) upper.push_back(center + through_y);
          }
          sketch.line(left, color, 2);
          sketch.line(upper, color, 2);
        }
        mark(sign * 0.6, 0);
        for (const double end : {0.7, -0.7}) mark(end * reach, end * sign * slope * reach);
      }
    }
    sketch.text(center + Vector3d(1.16, -0.24, 0), fmt::format("ω̃_{}", one + 1));
    sketch.text(center + Vector3d(-0.24, 1.22, 0), fmt::format("ω̃_{}", two + 1));
    sketch.text(center - 1.3 * y_axis, fmt::format("near axis {}", axis + 1), color);
    sketch.text(center - 1.58 * y_axis, names[static_cast<std::size_t>(axis)]);
  }
  sketch.draw(directory, "portraits", 600);
}

void draw_growth_rates(const std::filesystem::path& directory) {
  const auto rate = [](double first, double middle) { return growth_rate({first, middle, 1}, 1); };
  Plot flat;
  for (int i = 0; i < 200; ++i) flat.emplace_back(0.5 + 0.0025 * i, rate(0.5 - 0.0025 * i, 0.5 + 0.0025 * i));
  flat.emplace_back(1, 1);  // the limit of a flat needle
  const std::array<double, 5> ratios{0.1, 0.2, 0.35, 0.5, 0.7};
  const std::array<const char*, 5> dashes{"solid", "(12,4)", "(6,4)", "(3,3)", "(12,4,3,4)"};
  const std::array<Point, 5> places{{{0.928, 0.62}, {0.83, 0.635}, {0.73, 0.49}, {0.745, 0.3}, {0.85, 0.13}}};
  draw_figure(directory, "growth_rates", {560, 400}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set xlabel 'I_2 / I_3'; set ylabel 'growth rate σ / |ω̃_2|'\n"
               "set xrange [0.5:1]; set yrange [0:1.05]\n"
            << fmt::format("set label \"no body here:\\nI_1 + I_2 < I_3\" at 0.53,0.88 left front tc rgb '{}'\n",
                           colors::grey)
            << fmt::format(
                   "set label 'flat bodies: I_1 + I_2 = I_3' at 0.685,0.69 left rotate by 23 front tc rgb '{}'\n",
                   colors::vermilion)
            << fmt::format("set label '(1, 2, 3)' at 0.655,0.62 right front tc rgb '{}'\n", colors::black)
            << fmt::format("set label '' at {:.6f},{:.6f} point pt 7 ps 0.7 lc rgb '{}' front\n", 2.0 / 3,
                           rate(1.0 / 3, 2.0 / 3), colors::black)
            << fmt::format("set label 'racket' at 0.937,0.835 left front tc rgb '{}'\n", colors::black)
            << fmt::format("set label '' at {:.6f},{:.6f} point pt 7 ps 0.7 lc rgb '{}' front\n", 16.38 / 17.48,
                           rate(1.21 / 17.48, 16.38 / 17.48), colors::black);
    std::string plot = fmt::format(
        "plot '-' with filledcurves y1=1.05 fs solid noborder lc rgb '{}', '-' with lines lw 3.5 lc rgb '{}'",
        colors::shade, colors::vermilion);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      plot += fmt::format(", '-' with lines lw 2.2 dt {} lc rgb '{}'", dashes[i], colors::blue);
      gnuplot << fmt::format("set label '{}{:g}' at {},{} center front tc rgb '{}'\n",
                             i < 2 ? "" : "I_1/I_3 = ", ratios[i], places[i].first, places[i].second, colors::blue);
    }
    gnuplot << plot << "\n";
    gnuplot.send1d(flat);
    gnuplot.send1d(flat);
    for (const double first : ratios) {
      const double from = std::max(first, 1 - first);
      Plot curve;
      for (int i = 0; i <= 100; ++i)
        curve.emplace_back(from + (1 - from) * i / 100, rate(first, from + (1 - from) * i / 100));
      gnuplot.send1d(curve);
    }
  });
}

// ---- any amplitude

/// The curve on the ellipsoid Σ e_i x_i² = 1 on which Σ e_i f_i x_i² = level, round ±axis (2 or 0), for ascending or
/// descending f.
SpaceCurve level_curve(const Vector3d& e, const Vector3d& f, double level, int axis, double side) {
  const int other = 2 - axis;
  const double excess = f[axis] - level;
  const double across = std::sqrt(excess / (e[other] * (f[axis] - f[other])));
  const double middle = std::sqrt(excess / (e[1] * (f[axis] - f[1])));
  SpaceCurve curve;
  for (int i = 0; i <= 240; ++i) {
    Vector3d x;
    x[other] = across * std::cos(2 * pi * i / 240);
    x[1] = middle * std::sin(2 * pi * i / 240);
    x[axis] = side * std::sqrt((1 - e[other] * x[other] * x[other] - e[1] * x[1] * x[1]) / e[axis]);
    curve.push_back(x);
  }
  return curve;
}

/// One of the two plane curves of that kind through the ends of the middle axis.
SpaceCurve separatrix_curve(const Vector3d& e, const Vector3d& f, double side) {
  const double slope = side * std::sqrt(e[0] * (f[1] - f[0]) / (e[2] * (f[2] - f[1])));
  const double first = 1 / std::sqrt(e[0] + e[2] * slope * slope);
  return arc(origin, 1, first * Vector3d(1, 0, slope), y_axis / std::sqrt(e[1]));
}

/// The surface Σ e_i x_i² = 1 with level curves of Σ e_i f_i x_i², and the sense in which a free body runs along them.
void draw_surface(Sketch& sketch, const Vector3d& e, const Vector3d& f,
                  const std::array<std::vector<double>, 2>& levels,
                  const std::function<Vector3d(const Vector3d&)>& rate) {
  const Vector3d root = e.cwiseSqrt();
  sketch.ellipsoid(root.cwiseInverse().asDiagonal(), colors::sky);
  const auto mark = [&](const SpaceCurve& curve, std::size_t index, const char* color) {
    const Vector3d& x = curve[index];
    const Vector3d step = 0.04 / root.minCoeff() * rate(x).normalized();
    if (e.cwiseProduct(x).dot(sketch.towards()) > 0) sketch.arrow(x - step, x + step, color, "", Side::right, 2);
  };
  for (int family = 0; family < 2; ++family) {
    const int axis = 2 * family;
    for (std::size_t i = 0; i < levels[static_cast<std::size_t>(family)].size(); ++i) {
      for (const double side : {1.0, -1.0}) {
        const SpaceCurve curve = level_curve(e, f, levels[static_cast<std::size_t>(family)][i], axis, side);
        sketch.line(curve, axis_colors[static_cast<std::size_t>(axis)], 2);
        if (side > 0 && i % 2 == 0) mark(curve, 45, axis_colors[static_cast<std::size_t>(axis)]);
      }
    }
  }
  for (const double side : {1.0, -1.0}) {
    const SpaceCurve curve = separatrix_curve(e, f, side);
    sketch.line(curve, colors::black, 3);
    for (const std::size_t index : {9U, 27U}) mark(curve, index, colors::black);
  }
}

void draw_polhodes(const std::filesystem::path& directory) {
  Sketch sketch({0.95, 1.15, 0.62});
  const Vector3d I = flat_body;
  draw_surface(sketch, I, I, {{{1.08, 1.35, 1.65, 1.9}, {2.92, 2.65, 2.35, 2.1}}},
               [&](const Vector3d& omega) { return rate_of(I, omega); });
  const std::array<const char*, 3> names{"axis 1\\n(smallest I)", "axis 2\\n(intermediate I)", "axis 3 (largest I)"};
  for (int i = 0; i < 3; ++i) {
    const Vector3d tip = Vector3d::Unit(i) / std::sqrt(I[i]);
    sketch.arrow(tip,
                 (i == 0   ? 1.25
                  : i == 1 ? 1.8
                           : 1.5) *
                     tip,
                 axis_colors[static_cast<std::size_t>(i)], names[static_cast<std::size_t>(i)],
                 i == 2 ? Side::right : Side::below, 2.5);
  }
  sketch.text({-0.55, 0.1, 0.55}, "separatrix", colors::black, Side::right);
  sketch.draw(directory, "polhodes", 600, false);
}

/// All motions with one L, and what friction does: on the sphere of L in the body, with level curves of the energy.
void draw_momentum_sphere(const std::filesystem::path& directory) {
  Sketch sketch({1.0, 0.62, 0.62});
  const Vector3d I = flat_body;
  const auto rate = [&](const Vector3d& L) -> Vector3d { return L.cross(L.cwiseQuotient(I)); };
  draw_surface(sketch, Vector3d::Ones(), I.cwiseInverse(), {{{0.95, 0.8, 0.65, 0.54}, {0.345, 0.38, 0.43, 0.48}}},
               rate);
  // The simplest friction that keeps |L|: dL/dt = L × ω + κ L × (L × ω).
  SpaceCurve path;
  Vector3d L = Vector3d(1, -0.104, 0.06).normalized();
  for (int i = 0; i < 40000; ++i) {
    if (i % 40 == 0) path.push_back(L);
    const auto slope = [&](const Vector3d& x) -> Vector3d { return rate(x) + 0.12 * x.cross(rate(x)); };
    const double h = 0.005;
    L = (L + h * slope(L + h / 2 * slope(L))).normalized();
  }
  sketch.line(path, colors::blue, 3.5);
  const std::array<const char*, 3> names{"{/:Bold e}_1, T highest", "{/:Bold e}_2", "{/:Bold e}_3, T lowest"};
  for (int i = 0; i < 3; ++i) {
    sketch.arrow(Vector3d::Unit(i), (i == 0 ? 1.5 : 1.3) * Vector3d::Unit(i), axis_colors[static_cast<std::size_t>(i)],
                 names[static_cast<std::size_t>(i)], i == 0 ? Side::left : Side::right, 2.5);
  }
  sketch.draw(directory, "momentum_sphere", 500, false);
}

void draw_flip(const std::filesystem::path& directory) {
  const Vector3d omega0(0, 1, 1e-3);
  const double duration = 90, interval = tumbling_period(flat_body, omega0) / 2, first = interval / 2;
  const auto motion = history(flat_body, {omega0}, duration, 601);
  draw_figure(directory, "flip", {560, 360}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set xlabel 'time (s)'; set ylabel 'component of ω in the body (rad/s)'\n"
               "set xrange [0:90]; set yrange [-1.35:1.55]; set ytics 0.5\n";
    for (int i = 0; i < 3; ++i) {
      gnuplot << fmt::format("set arrow from {0:.4f},-1.35 to {0:.4f},1.55 nohead dt (3,4) lc rgb '{1}'\n",
                             first + i * interval, colors::grey);
    }
    gnuplot << fmt::format("set arrow from {:.4f},1.22 to {:.4f},1.22 heads filled size 1.5,18 lc rgb '{}' front\n",
                           first, first + interval, colors::black)
            << fmt::format("set label '{:.2f} s' at {},1.38 center front tc rgb '{}'\n", interval, first + interval / 2,
                           colors::black);
    const std::array<Point, 3> places{{{first - 4, -0.72}, {5, 1.14}, {first + 4, 0.62}}};
    std::string plot = "plot ";
    for (std::size_t i = 0; i < 3; ++i) {
      gnuplot << fmt::format("set label 'ω̃_{}' at {},{} center front tc rgb '{}'\n", i + 1, places[i].first,
                             places[i].second, axis_colors[i]);
      plot += fmt::format("'-' with lines lw 3 lc rgb '{}'{}", axis_colors[i], i < 2 ? ", " : "\n");
    }
    gnuplot << plot;
    for (int i = 0; i < 3; ++i) gnuplot.send1d(component(motion, duration, i));
  });
}

void draw_flip_law(const std::filesystem::path& directory) {
  Plot exact, logarithm;
  const double sigma = growth_rate(flat_body, 1);
  for (int i = 0; i <= 120; ++i) {
    const double disturbance = std::pow(10.0, -6 + 6.0 * i / 120), squared = disturbance * disturbance;
    exact.emplace_back(disturbance, tumbling_period(flat_body, {0, 1, disturbance}) / 2);
    logarithm.emplace_back(disturbance, std::log(16 * (2 + 6 * squared) / (6 * squared)) / sigma);
  }
  draw_figure(directory, "flip_law", {560, 360}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key; set logscale x; set format x '10^{%T}'; set mxtics 1\n"
               "set xlabel 'ω̃_3 at the start (rad/s)'; set ylabel 'time between flips (s)'\n"
               "set xrange [1e-6:1]; set yrange [0:60]\n"
            << fmt::format("set label 'exact, 2K(k)/ν' at 3e-5,46 left front tc rgb '{}'\n", colors::blue)
            << fmt::format("set label '(1/σ) ln(16/(1−k²))' at 1.4e-6,25 left front tc rgb '{}'\n", colors::vermilion)
            << fmt::format("set arrow from 1.7e-4,25.4 to 5e-4,28.2 head filled size graph 0.02,18 lc rgb '{}' front\n",
                           colors::vermilion)
            << fmt::format("set label '2π/σ, a guess that is wrong in kind' at 1.4e-6,14 left front tc rgb '{}'\n",
                           colors::grey)
            << fmt::format(
                   "plot '-' with lines lw 5 lc rgb '{}', '-' with lines lw 2 dt (6,5) lc rgb '{}', {} with "
                   "lines lw 2 dt (3,4) lc rgb '{}'\n",
                   colors::sky, colors::vermilion, 2 * pi / sigma, colors::grey);
    gnuplot.send1d(exact);
    gnuplot.send1d(logarithm);
  });
}

// ---- the racket

/// A tennis racket in flight, thrown end over end, with L to the right.
struct Flight {
  Vector3d I{1.21e-3, 16.38e-3, 17.48e-3};  // kg m²; axis 1 along the handle, axis 3 out of the strings
  Vector3d omega0{0, 10, 0.5};              // rad/s
  Motion start{omega0, shortest_turn(I.cwiseProduct(omega0), Vector3d::UnitX())};
  double period = tumbling_period(I, omega0);
};

/// The racket at one attitude, 1.7 long, its two faces in different colours.
void draw_racket_at(Sketch& sketch, const Vector3d& center, const Matrix3d& A) {
  const Vector3d head = center + 0.45 * A.col(0), half = 0.05 * A.col(2);
  sketch.turned_body(head - half, head + half, {{0, 0.25}, {0, 0.3}, {1, 0.3}, {1, 0.25}, {0, 0.25}}, colors::grey,
                     1.4 * A.col(0));
  for (const double side : {1.0, -1.0})
    sketch.turned_body(head, head + 0.3 * side * half, {{1, 0}, {1, 0.25}}, side > 0 ? colors::sky : colors::orange,
                       1.4 * A.col(0));
  sketch.solid_box(center - 0.41 * A.col(0), A * Vector3d(0.44, 0.05, 0.04).asDiagonal(),
                   {colors::grey, colors::grey, colors::grey});
}

const Vector3d towards_racket(0.45, -1, 0.35);

void draw_racket(const std::filesystem::path& directory) {
  const Flight flight;
  constexpr int views = 6;
  const auto motion = history(flight.I, flight.start, flight.period / 2, views);
  Sketch sketch(towards_racket);
  const Vector3d right = sketch.right(), up = sketch.up();
  for (int i = 0; i < views; ++i) {
    const int column = i % 3, row = i / 3;
    const Vector3d center = 2.1 * column * right - 2.35 * row * up;
    const Matrix3d& A = motion[static_cast<std::size_t>(i)].A;
    draw_racket_at(sketch, center, A);
    sketch.arrow(center, center + 0.75 * A.col(1), colors::green);
    sketch.text(center - 1.08 * up, fmt::format("{:.2f} s", flight.period / 2 * i / (views - 1)));
  }
  sketch.arrow(1.2 * up + 0.2 * right, 1.2 * up + 0.2 * right + 0.8 * x_axis, colors::blue, "{/:Bold L}, always",
               Side::right);
  sketch.arrow(1.2 * up + 2.6 * right, 1.2 * up + 3.1 * right, colors::green, "{/:Bold e}_2 of the racket",
               Side::right);
  sketch.draw(directory, "racket", 600, false);
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"cones", draw_cones},
                       {"cylinders", draw_cylinders},
                       {"plate", draw_plate},
                       {"slip", draw_slip},
                       {"portraits", draw_portraits},
                       {"growth_rates", draw_growth_rates},
                       {"polhodes", draw_polhodes},
                       {"momentum_sphere", draw_momentum_sphere},
                       {"flip", draw_flip},
                       {"flip_law", draw_flip_law},
                       {"racket", draw_racket}});
}
