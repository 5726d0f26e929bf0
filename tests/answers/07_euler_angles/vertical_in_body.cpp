#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d vertical_in_body(double theta, double psi) {
//! right: two passive rotations
  const Vector3d after_theta = Eigen::AngleAxisd(-theta, Vector3d::UnitY()) * Vector3d::UnitZ();
  return Eigen::AngleAxisd(-psi, Vector3d::UnitZ()) * after_theta;
//! right: sums of angles
  return {(std::sin(psi - theta) - std::sin(psi + theta)) / 2, (std::cos(theta - psi) - std::cos(theta + psi)) / 2,
          std::cos(theta)};
//! wrong: sign of the first component
  return {std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
//! wrong: sine and cosine of psi exchanged
  return {-std::sin(theta) * std::sin(psi), std::sin(theta) * std::cos(psi), std::cos(theta)};
//! wrong: signs of the two exchanged
  return {std::sin(theta) * std::cos(psi), -std::sin(theta) * std::sin(psi), std::cos(theta)};
//! wrong: sine and cosine of theta exchanged
  return {-std::cos(theta) * std::cos(psi), std::cos(theta) * std::sin(psi), std::sin(theta)};
//! wrong: arguments in another order
Vector3d vertical_in_body(double psi, double theta) {
  return {-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
}
//! wrong: horizontal part normalised, which fails upright
  Vector3d v(-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), 0);
  v = v / v.norm() * std::abs(std::sin(theta));
  v[2] = std::cos(theta);
  return v;
