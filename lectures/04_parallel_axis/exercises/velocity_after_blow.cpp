// The task stands in include/rigid/parallel_axis.hpp; ./checker/run check velocity_after_blow shows it in short.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Vector3d velocity_after_blow(double M, const Matrix3d& I_cm, const Vector3d& r, const Vector3d& impulse,
                             const Vector3d& p) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
