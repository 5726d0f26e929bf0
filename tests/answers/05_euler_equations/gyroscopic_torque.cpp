//! wrong: spin not added to the turn about 3
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  return turn.cross(Vector3d(I1 * turn[0], I1 * turn[1], I3 * spin));
}

}  // namespace rigid
//! wrong: only the spin
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  return turn.cross(Vector3d(0, 0, I3 * spin));
}

}  // namespace rigid
//! wrong: torque on the vehicle
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  return -turn.cross(Vector3d(I1 * turn[0], I1 * turn[1], I3 * (turn[2] + spin)));
}

}  // namespace rigid
//! wrong: I1 and I3 exchanged
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  return turn.cross(Vector3d(I3 * turn[0], I3 * turn[1], I1 * (turn[2] + spin)));
}

}  // namespace rigid
//! wrong: total omega crossed
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  const Vector3d w(turn[0], turn[1], turn[2] + spin);
  return w.cross(Vector3d(I1 * w[0], I1 * w[1], I3 * w[2]));
}

}  // namespace rigid
//! right: by components
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d gyroscopic_torque(double I1, double I3, double spin, const Vector3d& turn) {
  const double h = I3 * (spin + turn[2]) - I1 * turn[2];
  return {turn[1] * h, -turn[0] * h, 0.0};
}

}  // namespace rigid
