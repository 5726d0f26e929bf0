#include "rigid/inertia_tensor.hpp"

namespace rigid {

double moment_about_axis(const Matrix3d& I, const Vector3d& axis) {
  const Vector3d n = axis.stableNormalized();  // no square underflows, however short the arrow
  return n.dot(I * n);
}

}  // namespace rigid
