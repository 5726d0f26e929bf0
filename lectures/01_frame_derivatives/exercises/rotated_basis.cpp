// The basis E (its columns are the basis vectors) after rotating for a time dt with the constant angular velocity
// omega. All components are inertial. The rotation is finite: the first-order step ω × e dt will not do. omega may
// vanish.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Matrix3d rotated_basis(const Matrix3d& E, const Vector3d& omega, double dt) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
