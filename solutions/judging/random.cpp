#include "solutions/judging/random.hpp"

#include <numbers>
#include <utility>

namespace workbook::judging {

Eigen::Vector3d Random::vector(double size) {
  Eigen::Vector3d result;
  for (double& component : result) {
    const double magnitude = uniform(0.2, 1.0);
    component = size * magnitude * sign();
  }
  return result;
}

Eigen::VectorXd Random::masses(int count) {
  Eigen::VectorXd result(count);
  for (double& mass : result) mass = uniform(0.5, 3);
  return result;
}

Eigen::Matrix3Xd Random::points(int count, const Eigen::Vector3d& center) {
  Eigen::Matrix3Xd result(3, count);
  for (auto column : result.colwise()) {
    for (int i = 0; i < 3; ++i) column[i] = center[i] + uniform(-1, 1);
  }
  return result;
}

Eigen::Matrix3d Random::rotation() {
  const double u = uniform(0, 1), a = uniform(0, 2 * std::numbers::pi), b = uniform(0, 2 * std::numbers::pi);
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Eigen::Quaterniond(p * std::sin(a), p * std::cos(a), q * std::sin(b), q * std::cos(b)).toRotationMatrix();
}

Eigen::Matrix3d Random::inertia_tensor() {
  const Eigen::Matrix3d axes = rotation();
  return axes * ascending_moments().asDiagonal() * axes.transpose();
}

Eigen::Vector3d Random::ascending_moments() {
  // Spreads of mass along the three axes; a moment is the sum of the other two, hence the triangle inequality.
  const double x = uniform(1.6, 2.2), y = uniform(0.9, 1.3), z = uniform(0.3, 0.6);
  return {y + z, z + x, x + y};
}

Eigen::Vector3d Random::principal_moments() {
  Eigen::Vector3d moments = ascending_moments();
  std::swap(moments[2], moments[whole(0, 2)]);
  std::swap(moments[1], moments[whole(0, 1)]);
  return moments;
}

Eigen::Vector3d Random::euler_angles() {
  const double phi = uniform(-4, 4);
  const double psi = phi + sign() * uniform(0.4, 2);  // φ = ψ would hide an exchange of the two
  const double theta = uniform(0.3, 1.3) + (whole(0, 1) == 1 ? std::numbers::pi / 2 : 0.0);
  const int outside = whole(0, 3);  // one in four each: θ negated, θ beyond π
  return {phi, outside == 0 ? -theta : outside == 1 ? theta + std::numbers::pi : theta, psi};
}

}  // namespace workbook::judging
