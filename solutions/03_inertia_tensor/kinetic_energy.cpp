#include "rigid/inertia_tensor.hpp"

namespace rigid {

double kinetic_energy(const Matrix3d& I, const Vector3d& omega) { return 0.5 * omega.dot(I * omega); }

}  // namespace rigid
