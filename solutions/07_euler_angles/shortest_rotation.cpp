#include "rigid/euler_angles.hpp"

namespace rigid {

Matrix3d shortest_rotation(const Vector3d& a, const Vector3d& b) {
  const Vector3d from = a.normalized(), to = b.normalized();
  const Vector3d v = from.cross(to);  // the axis times the sine of the angle
  const Matrix3d V{{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}};
  // 1 + sin α [n] + (1 − cos α) [n]², where (1 − cos α)/sin² α = 1/(1 + cos α) has no trouble with parallel directions
  return Matrix3d::Identity() + V + V * V / (1 + from.dot(to));
}

}  // namespace rigid
