//! wrong: lever from p
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d w = I_cm.inverse() * p.cross(impulse);
  return impulse / M + w.cross(p);
}

}  // namespace rigid
//! wrong: impulse cross r
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d w = I_cm.inverse() * impulse.cross(r);
  return impulse / M + w.cross(p);
}

}  // namespace rigid
//! wrong: tensor multiplied instead of inverted
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d w = I_cm * r.cross(impulse);
  return impulse / M + w.cross(p);
}

}  // namespace rigid
//! wrong: momentum instead of velocity
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d w = I_cm.inverse() * r.cross(impulse);
  return impulse + M * w.cross(p);
}

}  // namespace rigid
//! wrong: p scaled by M
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  const Vector3d w = I_cm.inverse() * r.cross(impulse);
  return (impulse + w.cross(p)) / M;
}

}  // namespace rigid
//! wrong: auto keeps an expression
#include "rigid/parallel_axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  auto w = I_cm.inverse() * r.cross(impulse).eval().normalized();
  return impulse / M + w.cross(p);
}

}  // namespace rigid
