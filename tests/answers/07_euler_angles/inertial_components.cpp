#include <cmath>
#include <rigid/euler_angles.hpp>
Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles) {
//! right: the body axes, weighted
  const double cf = std::cos(angles[0]), sf = std::sin(angles[0]);
  const double ct = std::cos(angles[1]), st = std::sin(angles[1]);
  const double cp = std::cos(angles[2]), sp = std::sin(angles[2]);
  const Vector3d e1(cp * ct * cf - sp * sf, cp * ct * sf + sp * cf, -cp * st);
  const Vector3d e2(-sp * ct * cf - cp * sf, -sp * ct * sf + cp * cf, sp * st);
  const Vector3d e3(st * cf, st * sf, ct);
  return V_body[0] * e1 + V_body[1] * e2 + V_body[2] * e3;
//! right: one quaternion
  const Eigen::Quaterniond q(std::cos(angles[1] / 2) * std::cos((angles[0] + angles[2]) / 2),
                             std::sin(angles[1] / 2) * std::sin((angles[2] - angles[0]) / 2),
                             std::sin(angles[1] / 2) * std::cos((angles[2] - angles[0]) / 2),
                             std::cos(angles[1] / 2) * std::sin((angles[0] + angles[2]) / 2));
  return q * V_body;
//! wrong: from inertial to body components
  using Eigen::AngleAxisd;
  return AngleAxisd(-angles[2], Vector3d::UnitZ()) *
         (AngleAxisd(-angles[1], Vector3d::UnitY()) * (AngleAxisd(-angles[0], Vector3d::UnitZ()) * V_body));
//! wrong: factors transposed, their order kept
  using Eigen::AngleAxisd;
  return AngleAxisd(angles[2], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitY()) * (AngleAxisd(angles[0], Vector3d::UnitZ()) * V_body));
//! wrong: about x in the middle
  using Eigen::AngleAxisd;
  return AngleAxisd(angles[0], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitX()) * (AngleAxisd(angles[2], Vector3d::UnitZ()) * V_body));
//! wrong: the last rotation is forgotten
  using Eigen::AngleAxisd;
  return AngleAxisd(angles[0], Vector3d::UnitZ()) * (AngleAxisd(angles[1], Vector3d::UnitY()) * V_body);
//! wrong: arguments in another order
Vector3d inertial_components(const Vector3d& angles, const Vector3d& V_body) {
  using Eigen::AngleAxisd;
  return AngleAxisd(angles[0], Vector3d::UnitZ()) *
         (AngleAxisd(angles[1], Vector3d::UnitY()) * (AngleAxisd(angles[2], Vector3d::UnitZ()) * V_body));
}
//! wrong: one sign in the matrix
static Matrix3d rot(const Vector3d& a) {
  const double cf = std::cos(a[0]), sf = std::sin(a[0]), ct = std::cos(a[1]), st = std::sin(a[1]), cp = std::cos(a[2]), sp = std::sin(a[2]);
  Matrix3d R;
  R << cp * ct * cf - sp * sf, cp * ct * sf + sp * cf, cp * st,
       -sp * ct * cf - cp * sf, -sp * ct * sf + cp * cf, sp * st,
       st * cf, st * sf, ct;
  return R;
}
Vector3d inertial_components(const Vector3d& V_body, const Vector3d& angles) {
  return rot(angles).transpose() * V_body;
}
