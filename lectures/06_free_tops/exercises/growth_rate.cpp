// The rate σ at which a small disturbance grows, e^(σt), when a body spins about its intermediate axis 2. The moments
// come in ascending order; the spin may have either sign, the rate is never negative.
#include <rigid/free_tops.hpp>

namespace rigid {

double growth_rate(const Vector3d& I_ascending, double omega2) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
