// A rotor, made of the masses m at the columns of r, turns about the z axis. Two more masses of correction kilograms
// each go into the planes z = planes[0] and z = planes[1]. Return their positions, two columns, such that the
// bearings do not feel the rotation at any speed.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3Xd balance_rotor(const VectorXd& m, const Matrix3Xd& r, const Vector2d& planes, double correction) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
