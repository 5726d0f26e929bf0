// The task stands in include/rigid/parallel_axis.hpp; ./checker/run check inertia_about_shifted_origin shows it in short.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d inertia_about_shifted_origin(const Matrix3d& I_origin, double M, const Vector3d& r_cm, const Vector3d& R) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
