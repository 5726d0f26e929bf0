// Worked examples of lecture 11. Each case computes the numbers of one paragraph of the notes, which quotes its lines
// between the marks [NAME in brief], what it prints, and the whole of it.
#include "lectures/11_measured/throws.hpp"
#include "lectures/support/agrees.hpp"
#include "lectures/support/result.hpp"

#include <rigid/free_tops.hpp>
#include <rigid/measured.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

using namespace rigid;
using namespace measured;
using workbook::agrees;
using workbook::result;
using workbook::result_table;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;

/// The coefficients of all throws, a column each.
Matrix3Xd coefficients_of(const std::vector<Flight>& flights) {
  Matrix3Xd all(3, flights.size());
  for (std::size_t k = 0; k < flights.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = euler_coefficients(flights[k].t, flights[k].omega);
  return all;
}

/// Mean and standard error of each row, a column each.
Eigen::MatrixXd means_of_rows(const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd both(rows.rows(), 2);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    both.row(i) = mean_and_error(VectorXd(rows.row(i).transpose())).transpose();
  return both;
}

/// The rate at which |L| falls in a flight, 1/s.
double decay_of_L(const Flight& flight) { return -log_slope(flight.t, sizes_of_L(flight, racket)); }

/// The samples that a flight would have given without air, in which |L| falls at a steady rate.
Flight without_air(Flight flight) {
  const double gamma = decay_of_L(flight);
  const VectorXd t = flight.t;
  for (Eigen::Index k = 0; k < t.size(); ++k) {
    const double before = k > 0 ? t[k - 1] : t[0], middle = (before + t[k]) / 2 - t[0];
    flight.omega.col(k) *= std::exp(gamma * (t[k] - t[0]));
    flight.t[k] = k > 0 ? flight.t[k - 1] + (t[k] - before) * std::exp(-gamma * middle) : 0.0;
  }
  return flight;
}

/// The same where |L| falls as it was measured, ripples included.
Flight without_measured_losses(Flight flight) {
  const VectorXd share = sizes_of_L(flight, racket) / sizes_of_L(flight, racket)[0], t = flight.t;
  for (Eigen::Index k = 0; k < t.size(); ++k) {
    flight.omega.col(k) /= share[k];
    flight.t[k] = k > 0 ? flight.t[k - 1] + (t[k] - t[k - 1]) * (share[k - 1] + share[k]) / 2 : 0.0;
  }
  return flight;
}

/// The defects of the throws one by one: a, b and c of the same throw are not independent.
Vector2d mean_defect(const std::vector<Flight>& flights) {
  const Matrix3Xd abc = coefficients_of(flights);
  VectorXd defects(abc.cols());
  for (Eigen::Index k = 0; k < abc.cols(); ++k) defects[k] = rigidity_defect(abc.col(k), Vector3d::Zero())[0];
  return mean_and_error(defects);
}

/// The attitude up to each sample.
std::vector<Matrix3d> attitudes_of(const Flight& flight) {
  std::vector<Matrix3d> all = {Matrix3d::Identity()};
  for (Eigen::Index k = 1; k < flight.t.size(); ++k)
    all.emplace_back(all.back() * attitude_from_rates(flight.t.segment(k - 1, 2), flight.omega.middleCols(k - 1, 2)));
  return all;
}

/// The direction of L in space at a sample, for an attitude that is the unit matrix at the first one.
Vector3d direction_of_L(const Flight& flight, const Matrix3d& A, Eigen::Index k) {
  return (A * racket.cwiseProduct(Vector3d(flight.omega.col(k)))).normalized();
}

/// Where the normal of the strings points after the handle has gone once round L: its component along where it was.
double face_after_a_round(const Flight& flight) {
  const std::vector<Matrix3d> A = attitudes_of(flight);
  const Vector3d L = direction_of_L(flight, A[0], 0);
  double angle = 0;
  for (std::size_t k = 1; k < A.size(); ++k) {
    const Vector3d before = L.cross(A[k - 1].col(1)), now = L.cross(A[k].col(1));
    angle += std::atan2(L.dot(before.cross(now)), before.dot(now));
    if (angle >= 2 * pi) return A[k](2, 2);
  }
  throw std::domain_error("the handle has not gone round");
}

/// What is left of the samples when the motion in a torque −γ|ω|ⁿL that fits them best is subtracted.
Matrix3Xd misfit(const Flight& flight, double gamma, int n = 0) {
  const auto motion = [&](const Vector3d& start) { return motion_in_air(racket, flight.t, start, gamma, n); };
  return motion(fitted_start(flight, motion)) - flight.omega;
}

/// The γ that leaves least of all throws together, and the root mean square of each.
std::pair<double, VectorXd> common_air(const std::vector<Flight>& flights, int n, double most) {
  const auto left_of_all = [&](double gamma) {
    double squares = 0;
    for (const Flight& flight : flights) squares += misfit(flight, gamma, n).squaredNorm();
    return squares;
  };
  const double gamma = boost::math::tools::brent_find_minima(left_of_all, 0.0, most, 12).first;
  VectorXd each(flights.size());
  for (std::size_t k = 0; k < flights.size(); ++k)
    each[static_cast<Eigen::Index>(k)] = root_mean_square(misfit(flights[k], gamma, n));
  return {gamma, each};
}

/// When ω_x goes through zero, s after the beginning, and the number of the sample before.
std::vector<std::pair<double, Eigen::Index>> zeros_of_x(const Flight& flight) {
  std::vector<std::pair<double, Eigen::Index>> zeros;
  for (Eigen::Index k = 1; k < flight.t.size(); ++k) {
    const double before = flight.omega(0, k - 1), now = flight.omega(0, k);
    if (before * now < 0)
      zeros.emplace_back(flight.t[k - 1] + (flight.t[k] - flight.t[k - 1]) * before / (before - now), k);
  }
  return zeros;
}

/// Half of the period of ω, s: the intermediate axis is x, the others are y and z.
double half_period(const Vector3d& omega) {
  return tumbling_period({racket[1], racket[0], racket[2]}, {omega[1], omega[0], omega[2]}) / 2;
}

}  // namespace

// ---- Lines

//! [lines]
TEST_CASE("lines: Three slopes of one throw") {
  //! [lines in brief]
  const Flight flight = racket_throws()[5];
  const Vector3d abc = euler_coefficients(flight.t, flight.omega);
  //! [lines in brief]

  // The same lines by their normal equations, and how far the samples lie from them.
  const Matrix3Xd sums = product_integrals(flight);
  Vector3d scatter, errors;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::MatrixX2d system(flight.t.size(), 2);
    system << VectorXd::Ones(flight.t.size()), sums.row(axis).transpose();
    const VectorXd samples = flight.omega.row(axis).transpose();
    const Eigen::Matrix2d squares = system.transpose() * system;
    const Vector2d line = squares.inverse() * (system.transpose() * samples);
    CHECK(agrees(line[1], abc[axis], 1e-11));
    const VectorXd left = samples - system * line;
    scatter[axis] = std::sqrt(left.squaredNorm() / static_cast<double>(left.size() - 2));
    const VectorXd from_mean = sums.row(axis).transpose().array() - sums.row(axis).mean();
    errors[axis] = scatter[axis] / from_mean.norm();
  }
  CHECK(agrees(abc, Vector3d(-0.9910, 0.9668, 0.8577), 1e-4));

  result("(a, b, c)", abc.transpose(), "", "throw 6", 3);
  result("s", scatter.transpose(), "rad/s", "the deviations of the three components from their lines", 2);
  result(R"(\Delta)", errors.transpose(), "",
         "the errors of the slopes that would follow from these, if they were independent", 2);
}
//! [lines]

//! [scatter]
TEST_CASE("scatter: Twelve throws of the same racket") {
  //! [scatter in brief]
  const Matrix3Xd abc = coefficients_of(racket_throws());  // a column per throw
  const Vector2d a = mean_and_error(VectorXd(abc.row(0).transpose()));
  const Vector2d b = mean_and_error(VectorXd(abc.row(1).transpose()));
  const Vector2d c = mean_and_error(VectorXd(abc.row(2).transpose()));
  //! [scatter in brief]

  CHECK(agrees(Vector3d(a[0], b[0], c[0]), Vector3d(-0.99192, 0.97120, 0.85226), 1e-5));
  CHECK(agrees(Vector3d(a[1], b[1], c[1]), Vector3d(0.00274, 0.00895, 0.00429), 1e-3));

  result("(a, b, c)", Eigen::RowVector3d(a[0], b[0], c[0]), "", "the means", 3);
  result(R"((\Delta a, \Delta b, \Delta c))", Eigen::RowVector3d(a[1], b[1], c[1]), "", "their standard errors", 2);
  result(R"(\sqrt{12}\,(\Delta a, \Delta b, \Delta c))", std::sqrt(12.0) * Eigen::RowVector3d(a[1], b[1], c[1]), "",
         "the scatter from throw to throw", 2);
}
//! [scatter]

//! [noise]
TEST_CASE("noise: Error bars of one throw, and a thousand synthetic throws") {
  //! [noise in brief]
  const Flight flight = racket_throws()[5];
  const Vector3d noise = noise_of_samples(flight), abc = coefficients_without_steps(flight);
  const Vector3d errors = changes_by_noise(flight).rowwise().norm();  // squares add up
  //! [noise in brief]

  // Throws of bodies that are known, half a second long at 100 Hz, with noise that is normally distributed.
  constexpr int throws = 1000, samples = 50;
  std::mt19937_64 generator(11);  // NOLINT(cert-msc51-cpp): the same throws each time
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  Vector3d covered = Vector3d::Zero();
  double covered_defects = 0;
  for (int number = 0; number < throws; ++number) {
    const double I_y = 0.06 + 0.3 * uniform(generator), I_z = 1 + I_y * (0.5 + 0.5 * uniform(generator));
    const Vector3d start(12 + 4 * uniform(generator), -4 - 6 * uniform(generator), 12 * uniform(generator) - 6);
    Flight made{VectorXd::LinSpaced(samples, 0, 0.49), {}};
    made.omega = motion_in_air({1, I_y, I_z}, made.t, start, 0);
    for (double& component : made.omega.reshaped()) component += 0.01 * normal(generator);
    const Vector3d found = coefficients_without_steps(made), truth(I_y - I_z, (I_z - 1) / I_y, (1 - I_y) / I_z);
    const Matrix3Xd changes = changes_by_noise(made);
    covered += ((found - truth).cwiseAbs().array() < 1.96 * changes.rowwise().norm().array()).cast<double>().matrix();
    const Vector3d slopes(1 + found[1] * found[2], 1 + found[2] * found[0], 1 + found[0] * found[1]);
    const double defect = rigidity_defect(found, Vector3d::Zero())[0];
    covered_defects += std::abs(defect) < 1.96 * (slopes.transpose() * changes).norm() ? 1 : 0;
  }
  for (const double share : {covered[0], covered[1], covered[2], covered_defects}) CHECK(std::abs(share - 950) <= 30);

  result("s", noise.transpose(), "rad/s", "the noise of a sample of throw 6", 1);
  result("(a, b, c)", abc.transpose(), "", "throw 6, without the error of the trapezoids", 4);
  result(R"(\Delta)", errors.transpose(), "", "from the noise alone", 1);
  result("n", (covered / 10).transpose(), "%", "of a thousand synthetic throws, the truth is within 1.96 errors", 3);
  result("n", covered_defects / 10, "%", "the same for \\(D\\)", 3);
}
//! [noise]

// ---- The identity

//! [identity]
TEST_CASE("identity: Is the racket rigid and free?") {
  //! [identity in brief]
  const Eigen::MatrixXd abc = means_of_rows(coefficients_of(racket_throws()));  // means, errors
  const Vector2d D = rigidity_defect(abc.col(0), abc.col(1));
  //! [identity in brief]

  const Vector2d by_throw = mean_defect(racket_throws());
  CHECK(agrees(by_throw, Vector2d(0.0100, 0.0042), 2e-2));

  result("D", D[0], "", "of the means", 2);
  result(R"(\Delta D)", D[1], "", "from the errors of the three means", 2);
  result(R"(\bar D)", by_throw[0], "", "the mean of the twelve throws", 2);
  result(R"(\Delta\bar D)", by_throw[1], "", "from their scatter", 2);
}
//! [identity]

// ---- Moments

//! [ratios]
TEST_CASE("ratios: The moments beside that about x") {
  //! [ratios in brief]
  const Matrix3Xd abc = coefficients_of(racket_throws());
  Eigen::MatrixXd ratios(2, 12);
  for (int k = 0; k < 12; ++k) ratios.col(k) = moment_ratios(abc(0, k), abc(2, k));
  const Eigen::MatrixXd without_12 = means_of_rows(ratios.leftCols(11));
  //! [ratios in brief]

  const Eigen::MatrixXd all = means_of_rows(ratios);
  CHECK(agrees(without_12, Eigen::MatrixXd{{0.08016, 0.00132}, {1.07469, 0.00162}}, 2e-5));
  CHECK(agrees(racket.tail<2>(), without_12.col(0), 1e-3));
  // What the ratios say of b, which they were not made from.
  const double b = (without_12(1, 0) - 1) / without_12(0, 0);
  CHECK(std::abs(b - mean_and_error(VectorXd(abc.row(1).transpose()))[0]) < 0.06);

  result("I_y/I_x", without_12(0, 0), "", "without throw 12", 3);
  result(R"(\Delta)", without_12(0, 1), "", "its standard error", 2);
  result("I_z/I_x", without_12(1, 0), "", "", 4);
  result(R"(\Delta)", without_12(1, 1), "", "its standard error", 2);
  result("I_y/I_x", all(0, 0), "", "with throw 12, which begins in the hand", 3);
  result(R"(\Delta)", all(0, 1), "", "its standard error", 2);
}
//! [ratios]

//! [pendulum]
TEST_CASE("pendulum: The racket hung up by the end of its handle") {
  //! [pendulum in brief]
  const double M = 0.285 + 0.17228;  // kg, racket and phone
  const double g = 9.809;            // m/s²
  const Vector2d I_x = moment_from_pendulum(M, g, 0.413, 1.436, 0.005, 0.039);
  const Vector2d I_z = moment_from_pendulum(M, g, 0.413, 1.450, 0.005, 0.023);
  //! [pendulum in brief]

  const double about_end = M * g * 0.413 * 1.436 * 1.436 / (4 * pi * pi), parallel = M * 0.413 * 0.413;
  CHECK(agrees(I_x[0], about_end - parallel, 1e-12));
  CHECK(agrees(I_x, Vector2d(0.01877, 0.00531), 1e-3));

  result("I_O", 1e3 * about_end, "g m²", "about the end, swinging about x", 3);
  result("M d^2", 1e3 * parallel, "g m²", "", 3);
  result("I_x", 1e3 * I_x[0], "g m²", "", 3);
  result(R"(\Delta I_x)", 1e3 * I_x[1], "g m²", "", 2);
  result("I_z", 1e3 * I_z[0], "g m²", "", 3);
  result(R"(\Delta I_z)", 1e3 * I_z[1], "g m²", "", 2);
}
//! [pendulum]

//! [torsion]
TEST_CASE("torsion: The racket on a fishing line, and I_x from the throws") {
  //! [torsion in brief]
  const VectorXd half{{53.81, 54.70, 52.26, 53.04, 53.49, 52.68, 51.07, 53.04, 52.32}};  // s, the phone alone
  const Vector2d P_phone = 2 * mean_and_error(half);
  const double I_phone = 0.17228 * (0.0715 * 0.0715 + 0.1467 * 0.1467) / 12;  // kg m², a plate
  const double P = 201.9, error_of_P = 4.1;                                   // s, racket and phone about the handle
  const double I_y = I_phone * std::pow(P / P_phone[0], 2);
  const double error_of_I_y = 2 * I_y * std::hypot(error_of_P / P, P_phone[1] / P_phone[0]);
  const double I_x = I_y / 0.0802;  // the ratio of the throws, to 0.0013
  const double error_of_I_x = I_x * std::hypot(error_of_I_y / I_y, 0.0013 / 0.0802);
  //! [torsion in brief]

  CHECK(agrees(4 * pi * pi * I_phone / (P_phone[0] * P_phone[0]), 1.347e-6, 1e-3));  // the stiffness of the line, N m
  CHECK(agrees(I_y, 1.391e-3, 1e-3));

  result(R"(P_\mathrm{phone})", P_phone[0], "s", "", 4);
  result(R"(\Delta P_\mathrm{phone})", P_phone[1], "s", "", 2);
  result("I_y", 1e3 * I_y, "g m²", "about the handle", 3);
  result(R"(\Delta I_y)", 1e3 * error_of_I_y, "g m²", "", 2);
  result("I_x", 1e3 * I_x, "g m²", "with the ratio from the throws", 3);
  result(R"(\Delta I_x)", 1e3 * error_of_I_x, "g m²", "", 2);
}
//! [torsion]

// ---- What the air does

//! [losses]
TEST_CASE("losses: L and T fall, and 2T/L² does not") {
  //! [losses in brief]
  const std::vector<Flight> flights = racket_throws();
  VectorXd of_L(12), of_T(12), of_curve(12);
  for (std::size_t k = 0; k < 12; ++k) {
    const Flight& flight = flights[k];
    const VectorXd L = sizes_of_L(flight, racket);
    const VectorXd twice_T = (racket.asDiagonal() * flight.omega.cwiseAbs2()).colwise().sum();
    of_L[k] = log_slope(flight.t, L);
    of_T[k] = log_slope(flight.t, twice_T);
    of_curve[k] = log_slope(flight.t, twice_T.cwiseQuotient(L.cwiseAbs2()));
  }
  //! [losses in brief]

  // A torque −β ω with the same decay of L, from the angle between ω and L at all samples.
  VectorXd against_omega(12);
  for (std::size_t k = 0; k < 12; ++k) {
    const Flight& flight = flights[k];
    double sum = 0;
    for (Eigen::Index i = 0; i < flight.t.size(); ++i) {
      const Vector3d omega = flight.omega.col(i), L = racket.cwiseProduct(omega);
      sum += omega.cross(L).squaredNorm() / std::pow(omega.dot(L), 2);
    }
    against_omega[static_cast<Eigen::Index>(k)] =
        2 * sum / static_cast<double>(flight.t.size()) * of_L[static_cast<Eigen::Index>(k)];
  }

  const Vector2d L = mean_and_error(of_L), T = mean_and_error(of_T), curve = mean_and_error(of_curve);
  CHECK(agrees(L[0], -0.216, 5e-3));
  CHECK(agrees(T[0], -0.435, 5e-3));
  CHECK(std::abs(curve[0]) < 0.01 * std::abs(T[0]));

  result(R"(\dd\ln L/\dd t)", L[0], "1/s", "", 3);
  result(R"(\Delta)", L[1], "1/s", "its standard error", 1);
  result(R"(\dd\ln T/\dd t)", T[0], "1/s", "", 3);
  result(R"(\Delta)", T[1], "1/s", "its standard error", 1);
  result(R"(\dd\ln(2T/L^2)/\dd t)", curve[0], "1/s", "", 2);
  result(R"(\Delta)", curve[1], "1/s", "its standard error", 1);
  result(R"(\dd\ln(2T/L^2)/\dd t)", against_omega.mean(), "1/s", "if the torque were opposite to \\(\\vec\\omega\\)",
         2);
}
//! [losses]

//! [clock]
TEST_CASE("clock: The coefficients without the air") {
  //! [clock in brief]
  std::vector<Flight> flights = racket_throws();
  for (Flight& flight : flights) flight = without_air(flight);
  const Eigen::MatrixXd abc = means_of_rows(coefficients_of(flights));
  //! [clock in brief]

  const Vector2d D = mean_defect(flights);
  std::vector<Flight> rippled = racket_throws();
  for (Flight& flight : rippled) flight = without_measured_losses(flight);
  const Vector2d otherwise = mean_defect(rippled);
  CHECK(agrees(otherwise, Vector2d(-0.00757, 0.00100), 1e-3));
  CHECK(std::abs(D[0]) < D[1]);

  result("(a, b, c)", abc.col(0).transpose(), "", "the means", 4);
  result(R"((\Delta a, \Delta b, \Delta c))", abc.col(1).transpose(), "", "their standard errors", 1);
  result(R"(\bar D)", D[0], "", "the mean of twelve throws", 1);
  result(R"(\Delta\bar D)", D[1], "", "from their scatter", 2);
  result(R"(\bar D)", otherwise[0], "", "if the clock follows the measured \\(L\\)", 1);
  result(R"(\Delta\bar D)", otherwise[1], "", "from their scatter", 1);
}
//! [clock]

//! [air]
TEST_CASE("air: The exact motion beside the samples") {
  //! [air in brief]
  const std::vector<Flight> flights = racket_throws();
  const auto [gamma, in_air] = common_air(flights, 0, 0.5);          // torque −γ L, with one γ for all throws
  const auto [gamma_2, in_fast_air] = common_air(flights, 1, 0.05);  // torque −γ' |ω| L, with one γ' for all throws
  Eigen::MatrixXd table(12, 4);
  for (int k = 0; k < 12; ++k)
    table.row(k) << k + 1, root_mean_square(misfit(flights[static_cast<std::size_t>(k)], 0)), in_air[k], in_fast_air[k];
  //! [air in brief]

  // What was left, with the exact solution in place of the integration.
  for (int k = 0; k < 12; ++k) {
    const Flight& flight = flights[static_cast<std::size_t>(k)];
    const auto motion = [&](const Vector3d& start) { return motion_in_air(racket, flight.t, start, gamma); };
    const Vector3d start = fitted_start(flight, motion);
    Matrix3Xd left = -flight.omega;
    for (Eigen::Index i = 0; i < left.cols(); ++i)
      left.col(i) += damped_rotation(racket, start, gamma, flight.t[i] - flight.t[0]);
    CHECK(agrees(root_mean_square(left), in_air[k], 1e-3));
  }
  const auto halved = [&](int column) { return (table.col(column).array() < 0.5 * table.col(1).array()).count(); };
  CHECK(halved(2) >= 10);
  CHECK(halved(3) >= 10);

  result(R"(\gamma)", gamma, "1/s", "common to all throws, torque \\(-\\gamma\\vec L\\)", 2);
  result(R"(\gamma')", gamma_2, "", "common to all throws, torque \\(-\\gamma'\\omega\\vec L\\)", 2);
  result("n", static_cast<double>(halved(2)), "",
         "throws with less than half of the deviations, torque \\(-\\gamma\\vec L\\)");
  result("n", static_cast<double>(halved(3)), "", "the same, torque \\(-\\gamma'\\omega\\vec L\\)");
  result_table(
      {"throw", "without air / (rad/s)", R"(\(-\gamma\vec L\) / (rad/s))", R"(\(-\gamma'\omega\vec L\) / (rad/s))"},
      table, 2);
}
//! [air]

//! [period]
TEST_CASE("period: From one zero of omega_x to the next") {
  //! [period in brief]
  std::vector<double> of_middle, of_start;
  for (const Flight& flight : racket_throws()) {
    const auto zeros = zeros_of_x(flight);
    for (std::size_t k = 1; k < zeros.size(); ++k) {
      const auto [begin, first] = zeros[k - 1];
      const auto [end, last] = zeros[k];
      of_middle.push_back((end - begin) / half_period(flight.omega.col((first + last) / 2)));
      of_start.push_back((end - begin) / half_period(flight.omega.col(first)));
    }
  }
  //! [period in brief]

  const Vector2d middle = mean_and_error(VectorXd::Map(of_middle.data(), static_cast<Eigen::Index>(of_middle.size())));
  const Vector2d start = mean_and_error(VectorXd::Map(of_start.data(), static_cast<Eigen::Index>(of_start.size())));
  CHECK(agrees(middle[0], 0.992, 3e-3));

  result("n", static_cast<double>(of_middle.size()), "", "intervals");
  result(R"(\Delta t\big/\tfrac P2)", middle[0], "", "with the period that belongs to the sample half-way", 3);
  result(R"(\Delta)", middle[1], "", "its standard error", 1);
  result(R"(\Delta t\big/\tfrac P2)", start[0], "", "with the period that belongs to the sample at the first zero", 3);
  result(R"(\Delta)", start[1], "", "its standard error", 1);
}
//! [period]

// ---- Attitude

//! [direction]
TEST_CASE("direction: L in space, and the face of the racket") {
  //! [direction in brief]
  const std::vector<Flight> flights = racket_throws();
  Eigen::MatrixXd table(12, 4);
  for (int k = 0; k < 12; ++k) {
    const Flight& flight = flights[static_cast<std::size_t>(k)];
    const Eigen::Index last = flight.t.size() - 1;
    const Matrix3d A = attitude_from_rates(flight.t, flight.omega);
    const Vector3d begin = direction_of_L(flight, Matrix3d::Identity(), 0), end = direction_of_L(flight, A, last);
    const double turned = flight.omega.colwise().norm().mean() * (flight.t[last] - flight.t[0]);
    const double off = std::acos(begin.dot(end)), face = face_after_a_round(flight);
    table.row(k) << k + 1, turned / degree, off / degree, face;
  }
  //! [direction in brief]

  CHECK(table.col(2).maxCoeff() < 3);
  CHECK((table.col(3).array() < -0.4).count() == 9);
  result_table({"throw", "turned by / °", R"(\(\vec L\) off by / °)", R"(\(\unit e_z\) after a round)"}, table, 3);
}
//! [direction]
