// A body has spun about its intermediate axis at the rate -spin since the infinite past, turns over once, and ends up
// with +spin. Its angular velocity at time t; at t = 0 it is half way, with positive components on the axes 1 and 3.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
