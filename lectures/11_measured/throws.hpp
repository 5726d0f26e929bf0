/// @file
/// The measured throws of lecture 11, for its worked examples and figures.
#pragma once

#include <rigid/measured.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// The folder of this file, if the build does not name it.
#ifndef WORKBOOK_MEASURED
#define WORKBOOK_MEASURED __FILE__ "/.."
#endif

namespace measured {

using namespace rigid;

/// The samples of one flight: times in s, angular velocity on the axes of the phone in rad/s.
struct Flight {
  VectorXd t;
  Matrix3Xd omega;
};

/// The throws of racket_throws.csv, which lies beside this file, in order.
inline std::vector<Flight> racket_throws() {
  const std::filesystem::path file = std::filesystem::path(WORKBOOK_MEASURED).lexically_normal() / "racket_throws.csv";
  std::ifstream lines(file);
  std::vector<std::vector<std::vector<double>>> samples;
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::vector<double> numbers;
    for (std::string cell; std::getline(cells, cell, ',');) numbers.push_back(std::stod(cell));
    const auto number = static_cast<std::size_t>(numbers.at(0));
    if (samples.size() < number) samples.resize(number);
    samples.at(number - 1).push_back(numbers);
  }
  if (samples.empty()) throw std::runtime_error(file.string() + " cannot be read.");
  std::vector<Flight> flights;
  for (const auto& rows : samples) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    Flight flight{VectorXd(count), Matrix3Xd(3, count)};
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::vector<double>& row = rows[static_cast<std::size_t>(k)];
      flight.t[k] = row.at(1);
      flight.omega.col(k) = Vector3d(row.at(2), row.at(3), row.at(4));
    }
    flights.push_back(flight);
  }
  return flights;
}

/// The mean of repeated measurements and its standard error, from their scatter.
inline Vector2d mean_and_error(const VectorXd& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().sum() / (n * (n - 1)))};
}

/// Running integrals of the three products, one row per axis, as euler_coefficients takes them.
inline Matrix3Xd product_integrals(const Flight& flight) {
  Matrix3Xd sums = Matrix3Xd::Zero(3, flight.t.size());
  const auto products = [&](Eigen::Index k) {
    const Vector3d w = flight.omega.col(k);
    return Vector3d(w[1] * w[2], w[2] * w[0], w[0] * w[1]);
  };
  for (Eigen::Index k = 1; k < flight.t.size(); ++k)
    sums.col(k) = sums.col(k - 1) + (flight.t[k] - flight.t[k - 1]) / 2 * (products(k - 1) + products(k));
  return sums;
}

/// The rate at which the logarithm of a quantity grows: the slope of the line of least squares.
inline double log_slope(const VectorXd& t, const VectorXd& quantity) {
  const VectorXd from_mean = t.array() - t.mean();
  return from_mean.dot(quantity.array().log().matrix()) / from_mean.squaredNorm();
}

/// The size of the angular momentum at each sample, for moments in any unit.
inline VectorXd sizes_of_L(const Flight& flight, const Vector3d& I) {
  return (I.asDiagonal() * flight.omega).colwise().norm().transpose();
}

/// euler_coefficients without the error of the trapezoids, which is four times as large with every second sample.
inline Vector3d coefficients_without_steps(const Flight& flight) {
  const auto every_second = Eigen::seqN(0, (flight.t.size() + 1) / 2, 2);
  const Vector3d all = euler_coefficients(flight.t, flight.omega);
  const Vector3d half = euler_coefficients(flight.t(every_second), flight.omega(Eigen::all, every_second));
  return all + (all - half) / 3;
}

/// Standard deviation of the noise of a sample, from the differences of neighbouring deviations from the three lines:
/// what is slow, such as the noise that the integrals have added up, hardly differs between neighbours.
inline Vector3d noise_of_samples(const Flight& flight) {
  const Eigen::Index steps = flight.t.size() - 1;
  const Vector3d slopes = coefficients_without_steps(flight);
  const Matrix3Xd left = flight.omega - slopes.asDiagonal() * product_integrals(flight);
  const Matrix3Xd differences = left.rightCols(steps) - left.leftCols(steps);
  return (differences.rowwise().squaredNorm() / (2.0 * static_cast<double>(steps))).cwiseSqrt();
}

/// What the noise of the samples alone makes of the coefficients: each sample moves them, in ω and in the integrals,
/// and all that they are moved adds up as squares. A column per moved number: how far its standard deviation moves
/// them.
inline Matrix3Xd changes_by_noise(const Flight& flight) {
  const Vector3d noise = noise_of_samples(flight), here = coefficients_without_steps(flight);
  Matrix3Xd changes(3, 3 * flight.t.size());
  Flight moved = flight;
  for (Eigen::Index k = 0; k < flight.t.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      moved.omega(axis, k) += noise[axis];
      changes.col(3 * k + axis) = coefficients_without_steps(moved) - here;
      moved.omega(axis, k) = flight.omega(axis, k);
    }
  }
  return changes;
}

/// The moment about each axis beside that about x, from all throws but the last.
inline const Vector3d racket(1, 0.0802, 1.0747);

/// The motion of a body at times in ascending order, in air whose torque is −γ|ω|ⁿL, by the classical rule of Runge and
/// Kutta: fast enough for fits, and another way than damped_rotation.
inline Matrix3Xd motion_in_air(const Vector3d& I, const VectorXd& t, const Vector3d& start, double gamma, int n = 0) {
  const auto rate = [&](const Vector3d& omega) -> Vector3d {
    const Vector3d L = I.cwiseProduct(omega);
    return L.cross(omega).cwiseQuotient(I) - gamma * std::pow(omega.norm(), n) * omega;
  };
  Matrix3Xd all(3, t.size());
  Vector3d omega = start;
  for (Eigen::Index k = 0; k < t.size(); ++k) {
    const double step = k > 0 ? t[k] - t[k - 1] : 0.0, parts = std::ceil(omega.norm() * step / 0.1), h = step / parts;
    for (int part = 0; part < parts; ++part) {
      const Vector3d a = rate(omega), b = rate(omega + h / 2 * a), c = rate(omega + h / 2 * b), d = rate(omega + h * c);
      omega += h / 6 * (a + 2 * b + 2 * c + d);
    }
    all.col(k) = omega;
  }
  return all;
}

/// The start with which a motion fits the samples of a flight best, where motion(start) is ω at all of its times: Gauss
/// and Newton, with Marquardt's damping.
template <class Motion>
Vector3d fitted_start(const Flight& flight, const Motion& motion) {
  const auto deviations = [&](const Vector3d& start) -> VectorXd { return (motion(start) - flight.omega).reshaped(); };
  Vector3d start = flight.omega.col(0);
  VectorXd left = deviations(start);
  double damping = 1e-3;
  for (int step = 0; step < 25 && damping < 1e6; ++step) {
    constexpr double h = 1e-5;
    Eigen::Matrix<double, Eigen::Dynamic, 3> slopes(left.size(), 3);
    for (int i = 0; i < 3; ++i) slopes.col(i) = (deviations(start + h * Vector3d::Unit(i)) - left) / h;
    const Matrix3d normal = slopes.transpose() * slopes;
    const Matrix3d damped = normal + damping * Matrix3d(normal.diagonal().asDiagonal());
    const Vector3d change = -damped.inverse() * (slopes.transpose() * left);
    const VectorXd then = deviations(start + change);
    if (then.norm() < left.norm()) {
      start += change;
      left = then;
      damping /= 10;
      if (change.norm() < 1e-4) break;
    } else {
      damping *= 10;
    }
  }
  return start;
}

/// Root mean square of what a motion leaves of the samples, per component.
inline double root_mean_square(const Matrix3Xd& left) {
  return left.norm() / std::sqrt(static_cast<double>(left.size()));
}

}  // namespace measured
