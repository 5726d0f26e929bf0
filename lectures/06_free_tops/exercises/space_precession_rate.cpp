// The rate at which the symmetry axis of a free symmetric top runs round the angular momentum, seen from the inertial
// frame. omega holds the body components of the angular velocity.
#include <rigid/free_tops.hpp>

namespace rigid {

double space_precession_rate(double I1, double I3, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
