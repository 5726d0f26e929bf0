// The largest absolute values that the three body components of the angular velocity reach while a free body tumbles.
// The moments come in ascending order.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector3d largest_rates(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
