//! wrong: sign of the first component
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  return {std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
}
}  // namespace rigid

//! wrong: sine and cosine of psi exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  return {-std::sin(theta) * std::sin(psi), std::sin(theta) * std::cos(psi), std::cos(theta)};
}
}  // namespace rigid

//! wrong: signs of the two exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  return {std::sin(theta) * std::cos(psi), -std::sin(theta) * std::sin(psi), std::cos(theta)};
}
}  // namespace rigid

//! wrong: sine and cosine of theta exchanged
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  return {-std::cos(theta) * std::cos(psi), std::cos(theta) * std::sin(psi), std::sin(theta)};
}
}  // namespace rigid

//! wrong: arguments in another order
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double psi, double theta) {
  return {-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), std::cos(theta)};
}
}  // namespace rigid

//! wrong: horizontal part normalised, which fails upright
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  Vector3d v(-std::sin(theta) * std::cos(psi), std::sin(theta) * std::sin(psi), 0);
  v = v / v.norm() * std::abs(std::sin(theta));
  v[2] = std::cos(theta);
  return v;
}
}  // namespace rigid

//! right: two passive rotations
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  const Vector3d after_theta = Eigen::AngleAxisd(-theta, Vector3d::UnitY()) * Vector3d::UnitZ();
  return Eigen::AngleAxisd(-psi, Vector3d::UnitZ()) * after_theta;
}
}  // namespace rigid

//! right: sums of angles
#include <cmath>
#include <rigid/euler_angles.hpp>
namespace rigid {
Vector3d vertical_in_body(double theta, double psi) {
  return {(std::sin(psi - theta) - std::sin(psi + theta)) / 2, (std::cos(theta - psi) - std::cos(theta + psi)) / 2,
          std::cos(theta)};
}
}  // namespace rigid
