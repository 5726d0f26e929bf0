// The attitude of a free body, as free_attitude of lecture 05 (principal axes along the inertial axes at time 0; the
// columns are the principal axes), but for times up to days and exact up to rounding. The moments come in ascending
// order.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

Matrix3d exact_attitude(const Vector3d& I, const Vector3d& omega0, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
