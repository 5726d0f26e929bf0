// The task stands in include/rigid/inertia_tensor.hpp; ./checker/run check largest_angle_between_L_and_omega shows it in short.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

double largest_angle_between_L_and_omega(const Vector3d& I) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
