// The point of contact of Poinsot's ellipsoid draws a curve on the plane, between two circles around the foot of the
// perpendicular. Their radii, the smaller first. The moments come in ascending order.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

Vector2d herpolhode_radii(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
