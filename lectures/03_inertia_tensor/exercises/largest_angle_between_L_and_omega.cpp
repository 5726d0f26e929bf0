// A body with the principal moments I may rotate about any axis through the origin. How large can the angle between
// its angular momentum and its angular velocity become?
#include <rigid/inertia_tensor.hpp>

namespace rigid {

double largest_angle_between_L_and_omega(const Vector3d& I) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
