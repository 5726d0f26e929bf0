// The angular acceleration, in inertial components, of a rotor that spins on a rotating platform. E holds the axes of
// the platform; spin and spin_rate are what is measured on the platform.
#include <rigid/frame_derivatives.hpp>

namespace rigid {

Vector3d composed_angular_acceleration(const Matrix3d& E, const Vector3d& omega, const Vector3d& alpha,
                                       const Vector3d& spin, const Vector3d& spin_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
