// Figures of lecture 06.
#include "lectures/support/figure.hpp"

#include <rigid/free_tops.hpp>

#include <fmt/format.h>
#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;
using gnuplotio::Gnuplot;

namespace {

namespace colors = workbook::colors;

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

using Point = std::pair<double, double>;
using Curve = std::vector<Point>;
/// Between two parts of a curve: gnuplot lifts the pen.
const Point pen_up(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN());

const Vector3d flat_body(1, 2, 3);

// ---- motion
// ------------------------------------------------------------------------------------------------------------

struct Motion {
  double t;
  Vector3d omega;  // body components
  Matrix3d A;      // V_inertial = A V_body
};

/// Euler's equations and dA/dt = A [ω]× integrated from A = 1, at `count` equally spaced times.
std::vector<Motion> integrated(const Vector3d& I, const Vector3d& omega0, double duration, int count) {
  using State = std::vector<double>;
  State state{omega0[0], omega0[1], omega0[2], 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto system = [&I](const State& now, State& rate, double) {
    const Vector3d omega(now[0], now[1], now[2]);
    const Vector3d omega_rate = Vector3d(I.cwiseProduct(omega)).cross(omega).cwiseQuotient(I);
    std::copy(omega_rate.begin(), omega_rate.end(), rate.begin());
    for (std::size_t i = 3; i < 12; i += 3) {
      const Vector3d turned = Vector3d(now[i], now[i + 1], now[i + 2]).cross(omega);
      std::copy(turned.begin(), turned.end(), &rate[i]);
    }
  };
  std::vector<Motion> motion;
  const auto observer = [&motion](const State& now, double t) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> A(&now[3]);
    motion.push_back({t, {now[0], now[1], now[2]}, A});
  };
  namespace odeint = boost::numeric::odeint;
  const auto stepper = odeint::make_controlled(1e-15, 1e-13, odeint::runge_kutta_fehlberg78<State>());
  odeint::integrate_n_steps(stepper, system, state, 0.0, duration / (count - 1), static_cast<std::size_t>(count - 1),
                            observer);
  return motion;
}

Curve component(const std::vector<Motion>& motion, int index, double factor = 1) {
  Curve curve;
  for (const Motion& now : motion) curve.emplace_back(now.t, factor * now.omega[index]);
  return curve;
}

// ---- drawing in space
// ----------------------------------------------------------------------------------------------------

/// A parallel view from the direction `towards`, in which `vertical` points up as far as it can.
class View {
 public:
  View(const Vector3d& towards, const Vector3d& vertical)
      : towards_(towards.normalized()), right_(vertical.cross(towards_).normalized()), up_(towards_.cross(right_)) {}

  Point operator()(const Vector3d& point) const { return {right_.dot(point), up_.dot(point)}; }
  const Vector3d& towards() const { return towards_; }

 private:
  Vector3d towards_, right_, up_;
};

/// Quiet paper for pictures that need no axes.
constexpr const char* no_axes =
    "unset key; unset border; unset tics; unset grid; unset xlabel; unset ylabel\n"
    "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0\n"
    "set size ratio -1\n";

void arrow(Gnuplot& gnuplot, Point from, Point to, const std::string& style) {
  gnuplot << fmt::format("set arrow from {:.7g},{:.7g} to {:.7g},{:.7g} {} front\n", from.first, from.second, to.first,
                         to.second, style);
}

void label(Gnuplot& gnuplot, const std::string& text, Point at, const std::string& style) {
  gnuplot << fmt::format("set label \"{}\" at {:.7g},{:.7g} {} front\n", text, at.first, at.second, style);
}

/// The outline of the shadow that points cast: their convex hull, closed (monotone chain).
Curve hull(Curve points) {
  std::sort(points.begin(), points.end());
  Curve chain;
  const auto turns_right = [](Point a, Point b, Point c) {
    return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first) <= 0;
  };
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = chain.size();
    for (const Point& point : points) {
      while (chain.size() >= begin + 2 && turns_right(chain[chain.size() - 2], chain.back(), point)) chain.pop_back();
      chain.push_back(point);
    }
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

// ---- polhodes
// ------------------------------------------------------------------------------------------------------------

/// The curve on the energy ellipsoid 2T = 1 on which L² = momentum_squared, round the extreme axis (2 or 0) on its
/// side.
std::vector<Vector3d> polhode(const Vector3d& I, double momentum_squared, int axis, double side) {
  const int other = 2 - axis;
  const double excess = I[axis] - momentum_squared;  // 2T·I − L² with 2T = 1
  const double across = std::sqrt(excess / (I[other] * (I[axis] - I[other])));
  const double middle = std::sqrt(excess / (I[1] * (I[axis] - I[1])));
  std::vector<Vector3d> curve;
  for (int i = 0; i <= 240; ++i) {
    Vector3d omega;
    omega[other] = across * std::cos(2 * pi * i / 240);
    omega[1] = middle * std::sin(2 * pi * i / 240);
    omega[axis] = side * std::sqrt((1 - I[other] * omega[other] * omega[other] - I[1] * omega[1] * omega[1]) / I[axis]);
    curve.push_back(omega);
  }
  return curve;
}

/// One of the two plane curves L² = 2T·I₂ through the ends of the intermediate axis.
std::vector<Vector3d> separatrix(const Vector3d& I, double side) {
  const double slope = side * std::sqrt(I[0] * (I[1] - I[0]) / (I[2] * (I[2] - I[1])));
  const double first = 1 / std::sqrt(I[0] + I[2] * slope * slope);
  std::vector<Vector3d> curve;
  for (int i = 0; i <= 240; ++i) {
    const double c = std::cos(2 * pi * i / 240), s = std::sin(2 * pi * i / 240);
    curve.emplace_back(first * c, s / std::sqrt(I[1]), slope * first * c);
  }
  return curve;
}

void draw_polhodes(const std::filesystem::path& directory) {
  const Vector3d I = flat_body;
  const View view({0.95, 1.15, 0.62}, Vector3d::UnitZ());
  const auto visible = [&](const Vector3d& omega) {
    return I.cwiseProduct(omega).dot(view.towards()) >= 0;
  };  // the normal is Iω

  // Every curve in two parts: in front, and behind the ellipsoid.
  const auto split = [&](const std::vector<std::vector<Vector3d>>& curves, bool in_front) {
    Curve part;
    for (const auto& curve : curves) {
      for (const Vector3d& omega : curve) part.push_back(visible(omega) == in_front ? view(omega) : pen_up);
      part.push_back(pen_up);
    }
    return part;
  };
  std::vector<std::vector<Vector3d>> round_third, round_first, boundary{separatrix(I, 1), separatrix(I, -1)};
  for (const double momentum_squared : {2.1, 2.35, 2.65, 2.92}) {
    for (const double side : {1.0, -1.0}) round_third.push_back(polhode(I, momentum_squared, 2, side));
  }
  for (const double momentum_squared : {1.08, 1.35, 1.65, 1.9}) {
    for (const double side : {1.0, -1.0}) round_first.push_back(polhode(I, momentum_squared, 0, side));
  }

  // The outline: where the surface turns away from the viewer.
  Curve outline;
  {
    const Vector3d root = I.cwiseSqrt();
    const Vector3d pole = root.cwiseProduct(view.towards()).normalized();
    const Vector3d p = pole.unitOrthogonal(), q = pole.cross(p);
    for (int i = 0; i <= 240; ++i) {
      const double angle = 2 * pi * i / 240;
      outline.push_back(view((std::cos(angle) * p + std::sin(angle) * q).cwiseQuotient(root)));
    }
  }

  workbook::draw_figure(directory, "polhodes", {540, 450}, [&](Gnuplot& gnuplot) {
    gnuplot << no_axes << "set xrange [-1.25:1.12]; set yrange [-0.84:0.98]\n";
    // The three axes stick out of the surface.
    const std::array<double, 3> reach = {1.32, 1.75, 1.6};
    const std::array<const char*, 3> names = {"axis 1\\n(smallest I)", "axis 2\\n(intermediate I)",
                                              "axis 3 (largest I)"};
    const std::array<Point, 3> shift = {Point(0.06, -0.07), Point(0.02, -0.04), Point(0.04, 0.02)};
    const std::array<const char*, 3> align = {"center", "center", "left"};
    for (int i = 0; i < 3; ++i) {
      const Vector3d tip = Vector3d::Unit(i) / std::sqrt(I[i]);
      const Point from = view(tip), to = view(reach[static_cast<std::size_t>(i)] * tip);
      arrow(gnuplot, from, to, "lw 2 lc rgb '#222222' size 0.04,20 filled");
      const auto k = static_cast<std::size_t>(i);
      label(gnuplot, names[k], {to.first + shift[k].first, to.second + shift[k].second}, align[k]);
    }
    label(gnuplot, "separatrix", {0.62, 0.62}, fmt::format("left tc rgb '{}'", colors::vermilion));
    // The sense in which ω runs along the curves, where they can be seen.
    const auto mark = [&](const std::vector<Vector3d>& curve, std::size_t index, const char* color) {
      const Vector3d& omega = curve[index];
      const Vector3d rate = Vector3d(I.cwiseProduct(omega)).cross(omega).cwiseQuotient(I);
      const Vector3d step = 0.03 * rate.normalized();
      arrow(gnuplot, view(omega - step), view(omega + step),
            fmt::format("lw 2.5 lc rgb '{}' size 0.045,22 filled", color));
    };
    mark(round_third[0], 40, colors::blue);
    mark(round_third[4], 45, colors::blue);
    mark(round_first[4], 45, colors::green);
    mark(round_first[0], 60, colors::green);
    for (const auto& curve : boundary) {
      mark(curve, 30, colors::vermilion);
      mark(curve, 90, colors::vermilion);
    }
    gnuplot << fmt::format(
        "plot '-' with filledcurves closed fs solid noborder lc rgb '#F4F4F4', "
        "'-' with lines lw 1 lc rgb '#C8C8C8', '-' with lines lw 1 lc rgb '#C8C8C8', '-' with lines lw 1 lc rgb "
        "'#C8C8C8', "
        "'-' with lines lw 1.5 lc rgb '#888888', '-' with lines lw 2 lc rgb '{}', '-' with lines lw 2 dt (9,5) lc rgb "
        "'{}', "
        "'-' with lines lw 3.5 lc rgb '{}'\n",
        colors::blue, colors::green, colors::vermilion);
    gnuplot.send1d(outline);
    for (const auto* family : {&round_third, &round_first, &boundary}) gnuplot.send1d(split(*family, false));
    gnuplot.send1d(outline);
    for (const auto* family : {&round_third, &round_first, &boundary}) gnuplot.send1d(split(*family, true));
  });
}

// ---- cones
// -----------------------------------------------------------------------------------------------------------------

struct Cone {
  Vector3d axis;
  double half_angle;
  double slant;

  std::vector<Vector3d> rim() const {
    const Vector3d p = axis.unitOrthogonal(), q = axis.cross(p);
    std::vector<Vector3d> points;
    for (int i = 0; i <= 120; ++i) {
      const double angle = 2 * pi * i / 120;
      points.push_back(
          slant * (std::cos(half_angle) * axis + std::sin(half_angle) * (std::cos(angle) * p + std::sin(angle) * q)));
    }
    return points;
  }
};

void draw_cones(const std::filesystem::path& directory) {
  // L upright, and L, ω, ê₃ in the plane of the paper, seen a little from above.
  const View view({0, -1, 0.3}, Vector3d::UnitZ());
  const auto in_plane = [](double angle) { return Vector3d(std::sin(angle), 0, std::cos(angle)); };
  struct Top {
    const char* title;
    double ratio;    // I₃/I₁
    double opening;  // between ω and the axis
  };
  const std::array<Top, 2> tops = {Top{"long top, I_3 = I_1 / 2", 0.5, 26 * degree},
                                   Top{"flattened top, I_3 = 1.8 I_1", 1.8, 42 * degree}};

  workbook::draw_figure(directory, "cones", {580, 310}, [&](Gnuplot& gnuplot) {
    gnuplot << "set multiplot\n" << no_axes << "set size ratio -1\n";
    for (std::size_t k = 0; k < 2; ++k) {
      const Top& top = tops[k];
      // tan(angle between L and the axis) = I₁ω⊥ / (I₃ω₃).
      const double tilt = std::atan(std::tan(top.opening) / top.ratio);
      const Vector3d axis = in_plane(tilt), omega = in_plane(tilt - top.opening);
      const Cone body{axis, top.opening, 1.0};
      const Cone space{Vector3d::UnitZ(), std::abs(tilt - top.opening), 1.0};
      gnuplot << fmt::format("set origin {},0; set size 0.5,1\nunset arrow; unset label\n", k == 0 ? 0 : 0.5);
      gnuplot << (k == 0 ? "set xrange [-0.68:1.32]; set yrange [-0.25:1.65]\n"
                         : "set xrange [-0.86:1.14]; set yrange [-0.25:1.65]\n");
      const Point origin = view(Vector3d::Zero());
      const auto draw_arrow = [&](const Vector3d& direction, double length, const char* name, const char* color,
                                  Point shift) {
        const Point tip = view(length * direction);
        arrow(gnuplot, origin, tip, fmt::format("lw 2.5 lc rgb '{}' size 0.07,18 filled", color));
        label(gnuplot, name, {tip.first + shift.first, tip.second + shift.second},
              fmt::format("center tc rgb '{}'", color));
      };
      draw_arrow(Vector3d::UnitZ(), 1.45, "L (fixed)", colors::black, k == 0 ? Point(-0.12, 0.1) : Point(0.05, 0.1));
      draw_arrow(omega, 1.3, "ω", colors::vermilion, k == 0 ? Point(0.1, 0.04) : Point(-0.08, 0.07));
      draw_arrow(axis, 1.35, "axis ê_3", colors::blue, k == 0 ? Point(0.06, 0.1) : Point(0.14, 0.08));
      label(gnuplot, top.title, {k == 0 ? 0.34 : 0.14, -0.14}, "center");
      if (k == 0) {
        label(gnuplot, "space\\ncone", {-0.6, 0.5}, fmt::format("left tc rgb '{}'", "#8A5F00"));
        label(gnuplot, "body cone", {0.72, 0.13}, fmt::format("left tc rgb '{}'", colors::blue));
      } else {
        label(gnuplot, "space cone\\ninside", {-0.84, 0.5}, fmt::format("left tc rgb '{}'", "#8A5F00"));
        label(gnuplot, "body cone", {0.5, 0.1}, fmt::format("left tc rgb '{}'", colors::blue));
      }
      const auto shadow = [&](const Cone& cone) {
        Curve points{origin};
        for (const Vector3d& point : cone.rim()) points.push_back(view(point));
        return hull(points);
      };
      const auto rim = [&](const Cone& cone) {
        Curve points;
        for (const Vector3d& point : cone.rim()) points.push_back(view(point));
        return points;
      };
      gnuplot << fmt::format(
          "plot '-' with filledcurves closed fs transparent solid 0.25 noborder lc rgb '{0}', '-' with lines lw 2 lc "
          "rgb '{0}', "
          "'-' with filledcurves closed fs transparent solid 0.45 noborder lc rgb '{1}', '-' with lines lw 2 dt (6,3) "
          "lc rgb '{1}', "
          "'-' with lines lw 1.5 lc rgb '{0}', '-' with lines lw 1.5 dt (6,3) lc rgb '{1}'\n",
          colors::sky, colors::orange);
      gnuplot.send1d(shadow(body));
      gnuplot.send1d(rim(body));
      gnuplot.send1d(shadow(space));
      gnuplot.send1d(rim(space));
      gnuplot.send1d(shadow(body));
      gnuplot.send1d(shadow(space));
    }
    gnuplot << "unset multiplot\n";
  });
}

// ---- curves over time and over shapes
// ---------------------------------------------------------------------------------------

void draw_slip(const std::filesystem::path& directory) {
  const Vector3d I(2, 3, 1);
  const double omega3 = 5, amplitude = 1e-5, duration = 3;
  const Vector2d rates = linearized_rates(I, omega3);
  const Curve exact = component(integrated(I, {amplitude, 0, omega3}, duration, 301), 1, 1e5);
  Curve slides, corrected;
  for (int i = 0; i <= 300; ++i) {
    const double t = duration * i / 300;
    slides.emplace_back(t, 1e5 * amplitude * std::sqrt(rates[1] / rates[0]) * std::sin(std::sqrt(rates.prod()) * t));
    if (i % 12 == 6) corrected.emplace_back(t, 1e5 * linearized_top(I, omega3, amplitude, 0, t)[1]);
  }

  workbook::draw_figure(directory, "slip", {540, 370}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key\nset xlabel 'time (s)'; set ylabel 'ω_2 (10^{-5} rad/s)'\n"
               "set xrange [0:3]; set yrange [-0.95:0.95]; set xzeroaxis lc rgb '#444444'\n";
    label(gnuplot, "as printed on the slides", {0.32, 0.72}, fmt::format("left tc rgb '{}'", colors::vermilion));
    label(gnuplot, "Euler's equations, integrated", {0.32, -0.71}, fmt::format("left tc rgb '{}'", colors::blue));
    label(gnuplot, "○ formula with sgn(Ω_1)", {0.32, -0.84}, "left");
    gnuplot << fmt::format(
        "plot '-' with lines lw 2.5 dt (9,5) lc rgb '{}', '-' with lines lw 3 lc rgb '{}', '-' with points pt 6 ps 0.9 "
        "lw 1.5 lc rgb '{}'\n",
        colors::vermilion, colors::blue, colors::black);
    gnuplot.send1d(slides);
    gnuplot.send1d(exact);
    gnuplot.send1d(corrected);
  });
}

void draw_flip(const std::filesystem::path& directory) {
  const Vector3d omega0(0, 1, 1e-3);
  const double duration = 90;
  const auto motion = integrated(flat_body, omega0, duration, 1200);
  const double interval = tumbling_period(flat_body, omega0) / 2;

  workbook::draw_figure(directory, "flip", {560, 370}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key\nset xlabel 'time (s)'; set ylabel 'body component of ω (rad/s)'\n"
               "set xrange [0:90]; set yrange [-1.35:1.5]; set ytics 0.5\n";
    const double first = interval / 2;
    for (int i = 0; i < 3; ++i) {
      gnuplot << fmt::format("set arrow from {0:.4f},-1.35 to {0:.4f},1.5 nohead dt 3 lc rgb '#888888'\n",
                             first + i * interval);
    }
    arrow(gnuplot, {first, 1.22}, {first + interval, 1.22}, "heads size 1,20 filled lc rgb '#222222'");
    label(gnuplot, fmt::format("{:.2f} s", interval), {first + interval / 2, 1.35}, "center");
    label(gnuplot, "ω_2", {5, 1.12}, fmt::format("center tc rgb '{}'", colors::vermilion));
    label(gnuplot, "ω_1", {first - 2.5, -0.72}, fmt::format("right tc rgb '{}'", colors::green));
    label(gnuplot, "ω_3", {first + 2.5, 0.55}, fmt::format("left tc rgb '{}'", colors::blue));
    gnuplot << fmt::format(
        "plot '-' with lines lw 3 lc rgb '{}', '-' with lines lw 2.5 dt (3,3) lc rgb '{}', '-' with lines lw 2.5 dt "
        "(10,4) lc rgb '{}'\n",
        colors::vermilion, colors::green, colors::blue);
    gnuplot.send1d(component(motion, 1));
    gnuplot.send1d(component(motion, 0));
    gnuplot.send1d(component(motion, 2));
  });
}

void draw_flip_law(const std::filesystem::path& directory) {
  Curve exact, logarithm;
  const double sigma = growth_rate(flat_body, 1);
  for (int i = 0; i <= 120; ++i) {
    const double disturbance = std::pow(10.0, -6 + 6.0 * i / 120);
    const double squares = disturbance * disturbance;
    exact.emplace_back(disturbance, tumbling_period(flat_body, {0, 1, disturbance}) / 2);
    logarithm.emplace_back(disturbance, std::log(16 * (2 + 6 * squares) / (6 * squares)) / sigma);
  }
  workbook::draw_figure(directory, "flip_law", {560, 380}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key\nset logscale x; set format x '10^{%T}'\n"
               "set xlabel 'ω_3 at the start (rad/s), with ω_2 = 1 rad/s'; set ylabel 'time between flips (s)'\n"
               "set xrange [1e-6:1]; set yrange [0:60]\n";
    label(gnuplot, "exact, 2K(m)/λ", {2e-5, 47}, fmt::format("left tc rgb '{}'", colors::blue));
    label(gnuplot, "(1/σ) ln(16/(1−m))", {1.5e-6, 28}, fmt::format("left tc rgb '{}'", colors::vermilion));
    arrow(gnuplot, {4e-5, 30.3}, {1.3e-4, 33}, fmt::format("size graph 0.02,20 filled lc rgb '{}'", colors::vermilion));
    label(gnuplot, "2π/σ, a guess that is wrong in kind", {1.5e-6, 13.5}, fmt::format("left tc rgb '{}'", "#555555"));
    gnuplot << fmt::format(
        "plot '-' with lines lw 4 lc rgb '{}', '-' with lines lw 2 dt (6,5) lc rgb '{}', {} with lines lw 2 dt 3 lc "
        "rgb '{}'\n",
        colors::sky, colors::vermilion, 2 * pi / sigma, colors::grey);
    gnuplot.send1d(exact);
    gnuplot.send1d(logarithm);
  });
}

void draw_growth_rates(const std::filesystem::path& directory) {
  const auto rate = [](double first, double middle) { return growth_rate({first, middle, 1}, 1); };
  Curve flat;
  for (int i = 0; i <= 200; ++i) {
    const double x = 0.5 + 0.5 * i / 200;
    if (i < 200) flat.emplace_back(x, rate(1 - x, x));
  }
  flat.emplace_back(1, 1);  // the limit of a flat needle

  const std::array<double, 5> ratios = {0.1, 0.2, 0.35, 0.5, 0.7};
  const std::array<const char*, 5> dashes = {"solid", "(12,4)", "(6,4)", "(3,3)", "(12,4,3,4)"};
  const std::array<Point, 5> places = {Point(0.93, 0.6), Point(0.86, 0.6), Point(0.735, 0.49), Point(0.75, 0.3),
                                       Point(0.85, 0.13)};
  workbook::draw_figure(directory, "growth_rates", {560, 410}, [&](Gnuplot& gnuplot) {
    gnuplot << "unset key\nset xlabel 'I_2 / I_3'; set ylabel 'growth rate σ / |ω_2|'\n"
               "set xrange [0.5:1]; set yrange [0:1.05]\n";
    label(gnuplot, "no body here:\\nI_1 + I_2 < I_3", {0.53, 0.85}, "left tc rgb '#555555'");
    label(gnuplot, "flat bodies: I_1 + I_2 = I_3", {0.755, 0.775},
          fmt::format("left rotate by 23 tc rgb '{}'", colors::vermilion));
    label(gnuplot, "I = (1, 2, 3)", {0.655, 0.62}, "right");
    gnuplot << fmt::format("set label '' at {:.6f},{:.6f} point pt 7 ps 0.9 lc rgb '#000000' front\n", 2.0 / 3,
                           rate(1.0 / 3, 2.0 / 3));
    std::string plot = fmt::format(
        "plot '-' with filledcurves y1=1.05 fs solid noborder lc rgb '#E8E8E8', '-' with lines lw 3.5 lc rgb '{}'",
        colors::vermilion);
    for (std::size_t i = 0; i < ratios.size(); ++i) {
      plot += fmt::format(", '-' with lines lw 2.2 dt {} lc rgb '{}'", dashes[i], colors::blue);
      label(gnuplot, fmt::format("{}{:g}", i < 2 ? "" : "I_1/I_3 = ", ratios[i]), places[i],
            fmt::format("center tc rgb '{}'", colors::blue));
    }
    gnuplot << plot << "\n";
    gnuplot.send1d(flat);
    gnuplot.send1d(flat);
    for (const double first : ratios) {
      const double from = std::max(first, 1 - first);
      Curve curve;
      for (int i = 0; i <= 100; ++i)
        curve.emplace_back(from + (1 - from) * i / 100, rate(first, from + (1 - from) * i / 100));
      gnuplot.send1d(curve);
    }
  });
}

// ---- the racket
// -------------------------------------------------------------------------------------------------------------

/// A racket in its own axes: the handle along axis 1 (smallest moment), axis 2 across it in the plane of the strings
/// (intermediate), axis 3 out of the plane (largest).
struct Racket {
  std::vector<Vector3d> head, handle;

  Racket() {
    for (int i = 0; i <= 40; ++i)
      head.emplace_back(0.45 + 0.42 * std::cos(2 * pi * i / 40), 0.3 * std::sin(2 * pi * i / 40), 0);
    for (const auto& [x, y] :
         {Point(0.04, 0.045), Point(-0.85, 0.045), Point(-0.85, -0.045), Point(0.04, -0.045), Point(0.04, 0.045)}) {
      handle.emplace_back(x, y, 0);
    }
  }
};

/// The motion of the animation: the flat body of the lecture, turning about its intermediate axis, with L to the right.
struct Flight {
  static constexpr double disturbance = 0.03;
  Vector3d omega0{0, 1, disturbance};
  Matrix3d momentum_to_right =
      Eigen::Quaterniond::FromTwoVectors(flat_body.cwiseProduct(omega0), Vector3d::UnitX()).toRotationMatrix();
  double half_period = tumbling_period(flat_body, omega0) / 2;
  View view{{0.45, -1, 0.35}, Vector3d::UnitZ()};

  Matrix3d attitude(const Motion& now) const { return momentum_to_right * now.A; }
};

/// The racket at one attitude, shifted to `center`: first the plot elements, then their data in the same order.
class RacketPicture {
 public:
  RacketPicture(const Flight& flight, const Motion& now, Point center) : center_(center) {
    const Matrix3d A = flight.attitude(now);
    const Racket racket;
    for (const Vector3d& point : racket.head) head_.push_back(shifted(flight.view(A * point)));
    for (const Vector3d& point : racket.handle) handle_.push_back(shifted(flight.view(A * point)));
    front_ = A.col(2).dot(flight.view.towards()) > 0;
    second_axis_ = shifted(flight.view(0.8 * A.col(1)));
  }

  std::string elements() const {
    return fmt::format(
        "'-' with filledcurves closed fs solid noborder lc rgb '{}', '-' with lines lw 2.5 lc rgb '#222222', "
        "'-' with filledcurves closed fs solid noborder lc rgb '#555555'",
        front_ ? colors::sky : colors::orange);
  }
  void send(Gnuplot& gnuplot) const {
    gnuplot.send1d(head_);
    gnuplot.send1d(head_);
    gnuplot.send1d(handle_);
  }
  void set_arrow(Gnuplot& gnuplot) const {
    arrow(gnuplot, center_, second_axis_, fmt::format("lw 3 lc rgb '{}' size 0.13,20 filled", colors::vermilion));
  }
  Point tip() const { return second_axis_; }

 private:
  Point shifted(Point point) const { return {point.first + center_.first, point.second + center_.second}; }

  Point center_, second_axis_;
  Curve head_, handle_;
  bool front_ = false;
};

void draw_racket_stills(const std::filesystem::path& directory) {
  const Flight flight;
  const int columns = 4, rows = 2;
  const auto motion = integrated(flat_body, flight.omega0, flight.half_period * 1.05, columns * rows);
  workbook::draw_figure(directory, "racket", {580, 360}, [&](Gnuplot& gnuplot) {
    gnuplot << no_axes << "set xrange [-1.0:7.85]; set yrange [-3.85:1.6]\n";
    arrow(gnuplot, {-0.8, 1.35}, {0.6, 1.35}, "lw 2 lc rgb '#222222' size 0.13,20 filled");
    label(gnuplot, "L, the same at all times", {0.75, 1.35}, "left");
    arrow(gnuplot, {4.35, 1.35}, {5.15, 1.35}, fmt::format("lw 3 lc rgb '{}' size 0.13,20 filled", colors::vermilion));
    label(gnuplot, "axis 2 of the racket", {5.3, 1.35}, fmt::format("left tc rgb '{}'", colors::vermilion));
    std::string plot;
    std::vector<RacketPicture> pictures;
    for (int i = 0; i < columns * rows; ++i) {
      const Point center(2.28 * (i % columns), i < columns ? 0.0 : -2.55);
      const Motion& now = motion[static_cast<std::size_t>(i)];
      pictures.emplace_back(flight, now, center);
      pictures.back().set_arrow(gnuplot);
      label(gnuplot, fmt::format("{:.1f} s", now.t), {center.first, center.second - 1.12}, "center");
      plot += (plot.empty() ? "plot " : ", ") + pictures.back().elements();
    }
    gnuplot << plot << "\n";
    for (const RacketPicture& picture : pictures) picture.send(gnuplot);
  });
}

/// The same flight as an animated picture; gnuplot's gif terminal makes one frame of each plot.
void animate_racket(const std::filesystem::path& directory) {
  const Flight flight;
  const int frames = 120;
  const double duration = 2 * flight.half_period;
  const auto motion = integrated(flat_body, flight.omega0, duration, frames);
  const Curve history = component(motion, 1);

  const std::filesystem::path file = directory / "racket.gif";
  std::filesystem::remove(file);
  {
    Gnuplot gnuplot("gnuplot");
    gnuplot << "set encoding utf8\nset terminal gif animate delay 8 loop 0 optimize enhanced size 480,440 font "
               "'sans,11' background '#FFFFFF'\n"
            << "set output '" << file.string() << "'\n";
    for (const Motion& now : motion) {
      const RacketPicture picture(flight, now, {0, 0});
      gnuplot << "set multiplot\nunset arrow; unset label\n"
              << no_axes
              << "set origin 0,0.3; set size 1,0.7; set size ratio -1\nset xrange [-1.5:1.5]; set yrange [-1.0:1.0]\n";
      picture.set_arrow(gnuplot);
      arrow(gnuplot, {-0.9, -0.92}, {0.9, -0.92}, "lw 2 lc rgb '#222222' size 0.08,20 filled");
      label(gnuplot, "L", {1.0, -0.92}, "left");
      // The key serves a second purpose: gnuplot takes the colours of all frames from the first one.
      label(gnuplot, "  one face", {-1.45, 0.85}, fmt::format("left point pt 5 ps 2 lc rgb '{}'", colors::sky));
      label(gnuplot, "  the other", {-1.45, 0.7}, fmt::format("left point pt 5 ps 2 lc rgb '{}'", colors::orange));
      label(gnuplot, "e_2", {picture.tip().first * 1.12, picture.tip().second * 1.12 + 0.04},
            fmt::format("center tc rgb '{}'", colors::vermilion));
      gnuplot << "plot " << picture.elements() << "\n";
      picture.send(gnuplot);

      gnuplot << "unset arrow; unset label\nset origin 0,0; set size 1,0.3; set size noratio\n"
                 "set lmargin 8; set rmargin 2; set tmargin 0.5; set bmargin 3\n"
                 "set border lc rgb '#444444'; set tics; set ytics -1,1,1; set xtics 5; set xlabel 'time (s)'; set "
                 "ylabel 'ω_2 (rad/s)'\n"
              << fmt::format("set xrange [0:{:.3f}]; set yrange [-1.25:1.25]\n", duration)
              << fmt::format("plot '-' with lines lw 2 lc rgb '{0}', '-' with points pt 7 ps 1.6 lc rgb '{0}'\n",
                             colors::vermilion);
      gnuplot.send1d(history);
      gnuplot.send1d(Curve{{now.t, now.omega[1]}});
      gnuplot << "unset multiplot\n";
    }
    gnuplot << "set output\n";
  }
  if (!std::filesystem::exists(file) || std::filesystem::file_size(file) == 0) {
    throw std::runtime_error(fmt::format("gnuplot drew no {}: does it know the terminal 'gif'?", file.string()));
  }
}

/// The stills of a page and the same in motion.
void draw_racket(const std::filesystem::path& directory) {
  draw_racket_stills(directory);
  animate_racket(directory);
}

}  // namespace

int main(int argc, char** argv) {
  return workbook::draw_figures(argc, argv,
                                {{"cones", draw_cones},
                                 {"slip", draw_slip},
                                 {"growth_rates", draw_growth_rates},
                                 {"polhodes", draw_polhodes},
                                 {"flip", draw_flip},
                                 {"flip_law", draw_flip_law},
                                 {"racket", draw_racket}});
}
