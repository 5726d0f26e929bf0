// On the axes of the body the direction of L moves once around axis 1 or axis 3 in a period, along a closed curve on
// the unit sphere. The solid angle, between 0 and 2π, that it encloses around that axis.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

double geometric_phase(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
