// Figures of lecture 11.
#include "lectures/11_measured/throws.hpp"
#include "lectures/support/sketch.hpp"

#include <rigid/measured.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace rigid;
using namespace measured;
using namespace workbook;

namespace {

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

PlaneCurve points_of(const VectorXd& x, const VectorXd& y) {
  PlaneCurve points;
  for (Eigen::Index k = 0; k < x.size(); ++k) points.emplace_back(x[k], y[k]);
  return points;
}

/// One throw: the samples, and the motion in air that fits them.
void draw_flight(const std::filesystem::path& directory) {
  const Flight flight = racket_throws()[5];
  const double gamma = -log_slope(flight.t, sizes_of_L(flight, racket));
  const Vector3d start =
      fitted_start(flight, [&](const Vector3d& from) { return motion_in_air(racket, flight.t, from, gamma); });
  constexpr int count = 161;
  const double begin = flight.t[0], end = flight.t[flight.t.size() - 1];
  std::array<PlaneCurve, 3> fitted;
  for (int k = 0; k < count; ++k) {
    const double t = begin + (end - begin) * k / (count - 1);
    const Vector3d omega = damped_rotation(racket, start, gamma, t - begin);
    for (std::size_t i = 0; i < 3; ++i) fitted.at(i).emplace_back(t, omega[static_cast<Eigen::Index>(i)]);
  }
  draw_figure(directory, "flight", {590, 560}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'time (s)'\nset ylabel 'component of ω (rad/s)'\nset xrange [0:0.9]\nset yrange [-20:24]\n"
            << "set key top right horizontal Left reverse samplen 1 width 1\n";
    std::string plot = "plot ";
    for (std::size_t i = 0; i < 3; ++i) {
      plot += fmt::format(
          "'-' with points pt 7 ps 0.45 lc rgb '{0}' title 'ω_{1}', '-' with lines lw 1.5 lc rgb '{0}' notitle{2}",
          axis_colors.at(i), axis_names.at(i), i < 2 ? ", " : "\n");
    }
    gnuplot << plot;
    for (std::size_t i = 0; i < 3; ++i) {
      gnuplot.send1d(points_of(flight.t, flight.omega.row(static_cast<Eigen::Index>(i)).transpose()));
      gnuplot.send1d(fitted.at(i));
    }
  });
}

/// The same samples over the running integrals: three lines.
void draw_lines(const std::filesystem::path& directory) {
  const Flight flight = racket_throws()[5];
  const Matrix3Xd sums = product_integrals(flight);
  const Vector3d slopes = euler_coefficients(flight.t, flight.omega);
  constexpr std::array<const char*, 3> below{"∫ω_yω_z dt (rad^2/s)", "∫ω_zω_x dt (rad^2/s)", "∫ω_xω_y dt (rad^2/s)"};
  draw_figure(directory, "lines", {590, 660}, [&](gnuplotio::Gnuplot& gnuplot) {
    std::array<PlaneCurve, 3> samples, lines;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const VectorXd sum = sums.row(i).transpose(), omega = flight.omega.row(i).transpose();
      samples.at(at) = points_of(sum, omega);
      for (const double x : {sum.minCoeff(), sum.maxCoeff()})
        lines.at(at).emplace_back(x, omega.mean() + slopes[i] * (x - sum.mean()));
      send_block(gnuplot, fmt::format("$samples{}", i), samples.at(at));
      send_block(gnuplot, fmt::format("$line{}", i), lines.at(at));
    }
    gnuplot << "set multiplot layout 3,1\nset key top left\n";
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      gnuplot << fmt::format(
          "set key {}\nset ytics {}\nset xlabel '{}'\nset ylabel 'ω_{} (rad/s)'\n"
          "plot $samples{} with points pt 7 ps 0.4 lc rgb '{}' notitle, "
          "$line{} with lines lw 1.5 lc rgb '{}' title 'slope {:.3f}'\n",
          i == 0 ? "top right" : "top left", i == 1 ? 4 : 10, below.at(at), axis_names.at(at), i, axis_colors.at(at), i,
          colors::black, slopes[i]);
    }
    gnuplot << "unset multiplot\n";
  });
}

/// The coefficients of twelve throws, and their means with error bars.
void draw_coefficients(const std::filesystem::path& directory) {
  const std::vector<Flight> flights = racket_throws();
  Matrix3Xd all(3, flights.size());
  for (std::size_t k = 0; k < flights.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = euler_coefficients(flights[k].t, flights[k].omega);
  const VectorXd numbers = VectorXd::LinSpaced(all.cols(), 1, static_cast<double>(all.cols()));
  draw_figure(directory, "coefficients", {590, 440}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot
        << "set xlabel 'throw'\nset ylabel 'coefficient'\nset xrange [0:15]\nset yrange [0.78:1.05]\n"
        << "set xtics ('1' 1, '2' 2, '3' 3, '4' 4, '5' 5, '6' 6, '7' 7, '8' 8, '9' 9, '10' 10, '11' 11, '12' 12, "
           "'mean' 13.5)\n"
        << "set key bottom left horizontal Left reverse samplen 1 width 1\n"
        << fmt::format(
               "plot '-' with points pt 7 ps 0.8 lc rgb '{0}' title '−a', '-' with points pt 5 ps 0.7 lc rgb '{1}' "
               "title 'b', '-' with points pt 9 ps 0.9 lc rgb '{2}' title 'c', '-' with yerrorbars pt 7 ps 0.8 lw 2 "
               "lc rgb '{0}' notitle, '-' with yerrorbars pt 5 ps 0.7 lw 2 lc rgb '{1}' notitle, '-' with "
               "yerrorbars pt 9 ps 0.9 lw 2 lc rgb '{2}' notitle\n",
               axis_colors[0], axis_colors[1], axis_colors[2]);
    const std::array<double, 3> signs{-1, 1, 1};
    for (int i = 0; i < 3; ++i)
      gnuplot.send1d(points_of(numbers, signs.at(static_cast<std::size_t>(i)) * all.row(i).transpose()));
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Vector2d mean = mean_and_error(all.row(i).transpose());
      gnuplot.send1d(std::vector<std::array<double, 3>>{{13.2 + 0.3 * i, signs.at(at) * mean[0], mean[1]}});
    }
  });
}

/// Polhodes: ω over |L| as measured, and the ellipses that follow from the mean of 2T/L².
void draw_polhodes(const std::filesystem::path& directory) {
  constexpr std::array<std::size_t, 3> numbers{5, 6, 12};
  constexpr std::array<const char*, 3> curve_colors{colors::blue, colors::vermilion, colors::purple};
  const double Iy = racket[1], Iz = racket[2];  // beside I_x
  draw_figure(directory, "polhodes", {590, 540}, [&](gnuplotio::Gnuplot& gnuplot) {
    gnuplot << "set xlabel 'I_xω_x / L'\nset ylabel 'I_x|ω_y| / L'\nset xrange [-1.1:1.1]\nset yrange [0:1.2]\n"
            << "set key center center Left reverse samplen 1 width 1\n";
    std::string plot = "plot ";
    std::vector<PlaneCurve> all;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const Flight flight = racket_throws()[numbers.at(i) - 1];
      const VectorXd L = sizes_of_L(flight, racket);
      const VectorXd twice_T = (racket.asDiagonal() * flight.omega.cwiseAbs2()).colwise().sum().transpose();
      const double e = twice_T.cwiseQuotient(L.cwiseAbs2()).mean();
      // 2T I_z − L² as a sum of squares in the x–y plane, as far as the third square is not negative.
      const double across = (e * Iz - 1) / (Iz - 1), along = (e * Iz - 1) / (Iy * (Iz - Iy));
      PlaneCurve ellipse;
      for (int k = 0; k <= 400; ++k) {
        const double angle = pi * k / 400, x = std::sqrt(across) * std::cos(angle),
                     y = std::sqrt(along) * std::sin(angle);
        if (x * x + Iy * y * y <= e) ellipse.emplace_back(x, y);
      }
      all.push_back(points_of(flight.omega.row(0).transpose().cwiseQuotient(L),
                              flight.omega.row(1).transpose().cwiseAbs().cwiseQuotient(L)));
      all.push_back(ellipse);
      plot += fmt::format(
          "'-' with points pt 7 ps 0.5 lc rgb '{0}' title 'throw {1}', '-' with lines lw 1.2 lc rgb '{0}' "
          "notitle{2}",
          curve_colors.at(i), numbers.at(i), i + 1 < numbers.size() ? ", " : "\n");
    }
    gnuplot << plot;
    for (const PlaneCurve& curve : all) gnuplot.send1d(curve);
  });
}

}  // namespace

int main(int argc, char** argv) {
  return draw_figures(argc, argv,
                      {{"flight", draw_flight},
                       {"lines", draw_lines},
                       {"coefficients", draw_coefficients},
                       {"polhodes", draw_polhodes}});
}
