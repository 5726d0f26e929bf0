#include "rigid/inertia_tensor.hpp"

namespace rigid {

Vector3d angular_momentum(const Matrix3d& I, const Vector3d& omega) { return I * omega; }

}  // namespace rigid
