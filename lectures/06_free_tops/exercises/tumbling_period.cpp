// The time after which the angular velocity of a free top repeats itself in the body, exact for any amplitude. The
// moments come in ascending order. Mind what your library takes for K: the modulus k or the parameter m = k².
#include <rigid/free_tops.hpp>

namespace rigid {

double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
