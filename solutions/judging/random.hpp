/// @file
/// Random but physical inputs, the same on every machine for the same seed.
#pragma once

#include <Eigen/Dense>

#include <cstdint>
#include <random>

namespace workbook::judging {

/// Draws inputs. The standard's distributions differ between libraries, so the numbers are made from the raw bits here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  /// A number in [lower, upper).
  double uniform(double lower, double upper);

  /// A whole number from lower to upper, both included.
  int whole(int lower, int upper);

  /// +1 or −1.
  double sign();

  /// A vector with components of either sign and magnitude between 0.2 and 1 times `size`: never near a coordinate
  /// plane.
  Eigen::Vector3d vector(double size = 1.0);

  /// A direction, uniform on the sphere.
  Eigen::Vector3d direction();

  /// `count` masses between 0.5 and 3 kg.
  Eigen::VectorXd masses(int count);

  /// `count` points in a box of edge 2 m around `center`, as columns.
  Eigen::Matrix3Xd points(int count, const Eigen::Vector3d& center = Eigen::Vector3d::Zero());

  /// A rotation matrix, uniform over all attitudes.
  Eigen::Matrix3d rotation();

  /// The inertia tensor of a random body of points: no axis of it is special, and its moments are well apart.
  Eigen::Matrix3d inertia_tensor();

  /// Principal moments of a real body, ascending and well apart: they obey the triangle inequality.
  Eigen::Vector3d ascending_moments();

  /// The same in random order.
  Eigen::Vector3d principal_moments();

  /// Euler angles (φ, θ, ψ), any real numbers, θ outside [0, π] included, sin θ away from 0.
  Eigen::Vector3d euler_angles();

 private:
  std::mt19937_64 bits_;
};

}  // namespace workbook::judging
