// The task stands in include/rigid/euler_angles.hpp; ./checker/run check to_zxz shows it in short.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d to_zxz(const Vector3d& angles) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
