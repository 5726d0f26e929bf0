// The angular velocity of a free body with three different moments (ascending) at time t, possibly days after it was
// omega0. Exact up to rounding: a step-by-step integration over the whole time is too slow and too inaccurate.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

Vector3d exact_rotation(const Vector3d& I, const Vector3d& omega0, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
