/// @file
/// Random but physical inputs, the same on every machine for the same seed.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>

namespace workbook::judging {

/// Draws inputs. The standard's distributions differ between libraries, so the numbers are made from the raw bits here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// A number in [lower, upper).
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(bits_() >> 11) * 0x1.0p-53;
  }

  /// A whole number from lower to upper, both included.
  int whole(int lower, int upper) { return std::min(upper, static_cast<int>(std::floor(uniform(lower, upper + 1.0)))); }

  double sign() { return uniform(0, 1) < 0.5 ? -1.0 : 1.0; }

  /// Components of either sign and magnitude between 0.2 and 1 times `size`: never near a coordinate plane.
  Eigen::Vector3d vector(double size = 1.0) {
    Eigen::Vector3d result;
    for (double& component : result) {
      const double magnitude = uniform(0.2, 1.0);
      component = size * magnitude * sign();
    }
    return result;
  }

  /// Masses between 0.5 and 3 kg.
  Eigen::VectorXd masses(int count) {
    Eigen::VectorXd result(count);
    for (double& mass : result) mass = uniform(0.5, 3);
    return result;
  }

  /// Points in a box of edge 2 m around `center`, as columns.
  Eigen::Matrix3Xd points(int count, const Eigen::Vector3d& center = Eigen::Vector3d::Zero()) {
    Eigen::Matrix3Xd result(3, count);
    for (auto column : result.colwise()) {
      for (int i = 0; i < 3; ++i) column[i] = center[i] + uniform(-1, 1);
    }
    return result;
  }

  /// Uniform over all attitudes: Shoemake's quaternion from three uniform numbers.
  Eigen::Matrix3d rotation() {
    const double u = uniform(0, 1), a = uniform(0, 2 * std::numbers::pi), b = uniform(0, 2 * std::numbers::pi);
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return Eigen::Quaterniond(p * std::sin(a), p * std::cos(a), q * std::sin(b), q * std::cos(b)).toRotationMatrix();
  }

  /// No axis of the body is special, and its moments are well apart.
  Eigen::Matrix3d inertia_tensor() {
    const Eigen::Matrix3d axes = rotation();
    return axes * ascending_moments().asDiagonal() * axes.transpose();
  }

  /// Moments of a real body, well apart.
  Eigen::Vector3d ascending_moments() {
    // Spreads of mass along the three axes; a moment is the sum of the other two, hence the triangle inequality.
    const double x = uniform(1.6, 2.2), y = uniform(0.9, 1.3), z = uniform(0.3, 0.6);
    return {y + z, z + x, x + y};
  }

  /// The same in random order.
  Eigen::Vector3d principal_moments() {
    Eigen::Vector3d moments = ascending_moments();
    std::swap(moments[2], moments[whole(0, 2)]);
    std::swap(moments[1], moments[whole(0, 1)]);
    return moments;
  }

  /// Euler angles (φ, θ, ψ), any real numbers, θ outside [0, π] included, sin θ away from 0.
  Eigen::Vector3d euler_angles() {
    const double phi = uniform(-4, 4);
    const double psi = phi + sign() * uniform(0.4, 2);  // φ = ψ would hide an exchange of the two
    const double theta = uniform(0.3, 1.3) + (whole(0, 1) == 1 ? std::numbers::pi / 2 : 0.0);
    const int outside = whole(0, 3);  // one in four each: θ negated, θ beyond π
    return {phi, outside == 0 ? -theta : outside == 1 ? theta + std::numbers::pi : theta, psi};
  }

 private:
  std::mt19937_64 bits_;
};

/// Draws for Exercise::random.
namespace any {

inline auto uniform(double lower, double upper) {
  return [=](Random& random) { return random.uniform(lower, upper); };
}

/// Of either sign.
inline auto spin(double lower, double upper) {
  return [=](Random& random) {
    const double sign = random.sign();
    return sign * random.uniform(lower, upper);
  };
}

inline auto vector(double size) {
  return [=](Random& random) { return random.vector(size); };
}

}  // namespace any

}  // namespace workbook::judging
