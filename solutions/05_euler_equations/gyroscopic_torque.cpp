#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  // A symmetric rotor has the same tensor on the vehicle's axes, however far it has turned about axis 3.
  const Vector3d L(I1 * turn[0], I1 * turn[1], I3 * (turn[2] + spin));
  return turn.cross(L);  // L is constant on axes that turn with `turn`
}

}  // namespace rigid
