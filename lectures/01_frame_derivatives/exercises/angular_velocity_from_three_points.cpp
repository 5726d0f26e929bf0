// The task stands in include/rigid/frame_derivatives.hpp; ./checker/run check angular_velocity_from_three_points shows it in short.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d angular_velocity_from_three_points(const Matrix3d& r, const Matrix3d& v) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
