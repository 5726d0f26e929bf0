// A rotor spins at a constant rate about axis 3 of a vehicle that turns itself. The torque that the vehicle must
// exert on the rotor, on the vehicle's axes.
#include <rigid/euler_equations.hpp>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
