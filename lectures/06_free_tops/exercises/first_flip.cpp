// A body is thrown with the angular velocity omega0, mainly about its intermediate axis. The first time t > 0 at
// which the component on this axis vanishes.
#include <rigid/free_tops.hpp>

namespace rigid {

double first_flip(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
