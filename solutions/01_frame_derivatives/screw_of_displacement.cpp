#include "rigid/frame_derivatives.hpp"

#include <cmath>

namespace rigid {

Matrix3Xd screw_of_displacement(const Vector3d& rotation, const Vector3d& d) {
  const double angle = rotation.norm();
  const Vector3d n = rotation / angle, shift = n * n.dot(d), across = d - shift;
  Matrix3Xd result(3, 2);
  result << 0.5 * (across + n.cross(across) / std::tan(angle / 2)), shift;
  return result;
}

}  // namespace rigid
