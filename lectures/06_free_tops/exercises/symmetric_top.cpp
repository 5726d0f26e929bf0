// The angular velocity of a free symmetric top at time t, in body components. At time 0 it is omega0.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector3d symmetric_top(double I1, double I3, const Vector3d& omega0, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
