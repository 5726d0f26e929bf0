// The attitude of an aircraft is given by its z–y–z angles. Find its yaw, pitch and roll: turns about axis 3, then
// about the new axis 2, then about the newest axis 1, from the same inertial axes to the same body axes.
#include <rigid/euler_angles.hpp>

namespace rigid {

Vector3d yaw_pitch_roll(const Vector3d& angles) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
