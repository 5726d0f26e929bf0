#include "rigid/euler_equations.hpp"

namespace rigid {

Vector3d spin_up(double I1, double I3, const Vector3d& omega0, double torque, double t) {
  const double gain = torque / I3 * t;
  const double angle = (I3 - I1) / I1 * (omega0[2] + gain / 2) * t;  // the rate grows evenly: its mean counts
  Vector3d omega;
  omega << Eigen::Rotation2Dd(angle) * omega0.head<2>(), omega0[2] + gain;
  return omega;
}

}  // namespace rigid
