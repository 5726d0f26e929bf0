// The ellipsoid of all angular velocities that have the energy of the present motion, fixed in a free body, touches a
// plane fixed in space and rolls on it. Return {distance of the plane from the centre, distance of the point of
// contact from the foot of the perpendicular}, both to nine digits.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

Vector2d poinsot(const Vector3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
