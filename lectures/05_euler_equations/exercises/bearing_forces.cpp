// A rotor with a given inertia tensor about its centre of mass turns about the z axis at a constant rate, held by two
// bearings. The forces of the bearings on the shaft, apart from its weight: one column each, on the body axes.
#include <rigid/euler_equations.hpp>

namespace rigid {

Matrix3Xd bearing_forces(const Matrix3d& I_cm, double M, const Vector3d& r_cm, double rate,
                         const Vector2d& bearings) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
