// At this moment the points of one straight line move along it, or not at all. Return the point of this line that is
// nearest to the origin.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d point_on_screw_axis(const Vector3d& r, const Vector3d& v, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
