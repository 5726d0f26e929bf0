#include <cmath>
#include <rigid/kinetic_energy.hpp>
Matrix3d momentum_brackets(const Vector3d& angles, const Vector3d& momenta) {
//! wrong: forward differences: the step is too coarse
  const auto L = [](const Vector3d& q, const Vector3d& p) -> Vector3d {
    const double s = std::sin(q[1]), x = (p[0] - p[2] * std::cos(q[1])) / s, sp = std::sin(q[2]), cp = std::cos(q[2]);
    return {-x * cp + p[1] * sp, x * sp + p[1] * cp, p[2]};
  };
  const double h = 1e-5;
  Matrix3d Q, P;
  for (int k = 0; k < 3; ++k) {
    Q.col(k) = (L(angles + h * Vector3d::Unit(k), momenta) - L(angles, momenta)) / h;
    P.col(k) = (L(angles, momenta + h * Vector3d::Unit(k)) - L(angles, momenta)) / h;
  }
  return Q * P.transpose() - P * Q.transpose();
//! wrong: inertial components of L with the sign of the body's
  const double x = (momenta[2] - momenta[0] * std::cos(angles[1])) / std::sin(angles[1]);
  const Vector3d L(x * std::cos(angles[0]) - momenta[1] * std::sin(angles[0]),
                   x * std::sin(angles[0]) + momenta[1] * std::cos(angles[0]), momenta[0]);
  Matrix3d P = Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    P(i, (i + 1) % 3) = -L[(i + 2) % 3];
    P((i + 1) % 3, i) = L[(i + 2) % 3];
  }
  return P;
