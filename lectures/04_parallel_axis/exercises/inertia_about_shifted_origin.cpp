// The inertia tensor after every position has become r' = r + R. The old origin need not be the centre of mass, which
// sits at r_cm as seen from there. Mind which way R points: the new origin is at -R.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
