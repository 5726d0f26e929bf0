#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/euler_equations.hpp>
Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
//! right: by components
  const double h = I3 * (spin + turn[2]) - I1 * turn[2];
  return {turn[1] * h, -turn[0] * h, 0.0};
//! wrong: spin not added to the turn about 3
  return turn.cross(Vector3d(I1 * turn[0], I1 * turn[1], I3 * spin));
//! wrong: only the spin
  return turn.cross(Vector3d(0, 0, I3 * spin));
//! wrong: torque on the vehicle
  return -turn.cross(Vector3d(I1 * turn[0], I1 * turn[1], I3 * (turn[2] + spin)));
//! wrong: I1 and I3 exchanged
  return turn.cross(Vector3d(I3 * turn[0], I3 * turn[1], I1 * (turn[2] + spin)));
//! wrong: total omega crossed
  const Vector3d w(turn[0], turn[1], turn[2] + spin);
  return w.cross(Vector3d(I1 * w[0], I1 * w[1], I3 * w[2]));
//! wrong: cross product reversed, and the spin for all of the rate
  const Vector3d L(I1 * turn[0], I1 * turn[1], I3 * spin);
  return L.cross(turn);
