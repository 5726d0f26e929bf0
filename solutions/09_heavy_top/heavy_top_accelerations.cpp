#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

Vector3d heavy_top_accelerations(const Vector3d& I, double mgl, const Vector3d& angles, const Vector3d& rates) {
  const double s = std::sin(angles[1]), c = std::cos(angles[1]);
  const double s_psi = std::sin(angles[2]), c_psi = std::cos(angles[2]);
  const double phi_rate = rates[0], theta_rate = rates[1], psi_rate = rates[2];

  const Vector3d omega(-phi_rate * s * c_psi + theta_rate * s_psi, phi_rate * s * s_psi + theta_rate * c_psi,
                       phi_rate * c + psi_rate);
  const Vector3d torque(mgl * s * s_psi, mgl * s * c_psi, 0);  // about the line of nodes
  const Vector3d omega_rate = (torque - omega.cross(I.cwiseProduct(omega))).cwiseQuotient(I);

  // ω̇ = B q̈ + Ḃ q̇: the vertical and the line of nodes turn as seen from the body.
  const Vector3d from_turning_axes(
      -phi_rate * (theta_rate * c * c_psi - psi_rate * s * s_psi) + theta_rate * psi_rate * c_psi,
      phi_rate * (theta_rate * c * s_psi + psi_rate * s * c_psi) - theta_rate * psi_rate * s_psi,
      -phi_rate * theta_rate * s);
  const Vector3d rest = omega_rate - from_turning_axes;  // = B q̈

  const double phi_acceleration = (-rest[0] * c_psi + rest[1] * s_psi) / s;
  return {phi_acceleration, rest[0] * s_psi + rest[1] * c_psi, rest[2] - c * phi_acceleration};
}

}  // namespace rigid
