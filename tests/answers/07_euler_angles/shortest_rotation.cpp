//! wrong: from b to a
#include "rigid/euler_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  return Eigen::Quaterniond::FromTwoVectors(b, a).toRotationMatrix();
}

}  // namespace rigid
//! wrong: not normalised
#include "rigid/euler_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  const Vector3d v = a.cross(b);
  Matrix3d V;
  V << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return Matrix3d::Identity() + V + V * V / (1 + a.dot(b));
}

}  // namespace rigid
//! wrong: angle read as its sine
#include "rigid/euler_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  const Vector3d f = a.normalized(), t = b.normalized();
  const Vector3d v = f.cross(t);
  if (v.norm() == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
}

}  // namespace rigid
//! right: by AngleAxis
#include "rigid/euler_angles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  const Vector3d f = a.normalized(), t = b.normalized();
  const Vector3d v = f.cross(t);
  if (v.norm() == 0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(std::atan2(v.norm(), f.dot(t)), v.normalized()).toRotationMatrix();
}

}  // namespace rigid
