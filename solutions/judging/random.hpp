/// @file
/// Random but physical inputs, the same on every machine for the same seed.
#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

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
  Eigen::Vector3d vector(double size = 1.0);

  /// Masses between 0.5 and 3 kg.
  Eigen::VectorXd masses(int count);

  /// Points in a box of edge 2 m around `center`, as columns.
  Eigen::Matrix3Xd points(int count, const Eigen::Vector3d& center = {0, 0, 0});

  /// Uniform over all attitudes: Shoemake's quaternion from three uniform numbers.
  Eigen::Matrix3d rotation();

  /// No axis of the body is special, and its moments are well apart.
  Eigen::Matrix3d inertia_tensor();

  /// Moments of a real body, well apart.
  Eigen::Vector3d ascending_moments();

  /// The same in random order.
  Eigen::Vector3d principal_moments();

  /// Euler angles (φ, θ, ψ), any real numbers, θ outside [0, π] included, sin θ away from 0.
  Eigen::Vector3d euler_angles();

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
