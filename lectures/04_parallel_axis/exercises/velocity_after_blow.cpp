// A free body at rest is struck: its point r receives the impulse. With what velocity does its point p begin to move?
// Both points are seen from the centre of mass.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
