/// @file
/// The measured throws of lecture 11, for its worked examples and figures.
#pragma once

#include <rigid/vocabulary.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace measured {

using namespace rigid;

/// The samples of one flight: times in s, angular velocity on the axes of the phone in rad/s.
struct Flight {
  VectorXd t;
  Matrix3Xd omega;
};

/// The throws of racket_throws.csv, which lies beside this file, in order.
inline std::vector<Flight> racket_throws() {
  const std::filesystem::path file = std::filesystem::path(__FILE__).parent_path() / "racket_throws.csv";
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

/// The moment about each axis beside that about x, from all throws but the last.
inline const Vector3d racket(1, 0.0802, 1.0747);

/// What is left of every fourth sample when a motion is subtracted that gives ω for a start and a time since then.
template <class Motion>
VectorXd deviations(const Flight& flight, const Motion& motion, const Vector3d& start) {
  constexpr Eigen::Index every = 4;
  const Eigen::Index count = (flight.t.size() + every - 1) / every;
  VectorXd all(3 * count);
  for (Eigen::Index k = 0; k < count; ++k)
    all.segment<3>(3 * k) = motion(start, flight.t[every * k] - flight.t[0]) - flight.omega.col(every * k);
  return all;
}

/// The start with which a motion fits the samples of a flight best: Gauss and Newton, with Marquardt's damping.
template <class Motion>
Vector3d fitted_start(const Flight& flight, const Motion& motion) {
  Vector3d start = flight.omega.col(0);
  VectorXd left = deviations(flight, motion, start);
  double damping = 1e-3;
  for (int step = 0; step < 25 && damping < 1e6; ++step) {
    constexpr double h = 1e-5;
    Eigen::MatrixXd slopes(left.size(), 3);
    for (int i = 0; i < 3; ++i) slopes.col(i) = (deviations(flight, motion, start + h * Vector3d::Unit(i)) - left) / h;
    const Matrix3d normal = slopes.transpose() * slopes;
    const Matrix3d damped = normal + damping * Matrix3d(normal.diagonal().asDiagonal());
    const Vector3d change = -damped.ldlt().solve(slopes.transpose() * left);
    const VectorXd then = deviations(flight, motion, start + change);
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

}  // namespace measured
