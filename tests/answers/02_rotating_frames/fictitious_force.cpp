#include <rigid/rotating_frames.hpp>
Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha) {
//! right: three forces
  const Vector3d coriolis = 2 * m * v_body.cross(omega);
  const Vector3d euler = m * r.cross(alpha);
  const Vector3d centrifugal = m * omega.cross(r.cross(omega));
  return coriolis + euler + centrifugal;
//! right: centrifugal force from the distance to the axis
  const Vector3d perpendicular = omega.squaredNorm() * r - omega.dot(r) * omega;
  return m * (perpendicular - 2 * omega.cross(v_body) - alpha.cross(r));
//! wrong: without the minus sign
  return m * (2 * omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r)));
//! wrong: the Coriolis force without its factor 2
  return -m * (omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r)));
//! wrong: the mass is forgotten
  return -2 * omega.cross(v_body) - alpha.cross(r) - omega.cross(omega.cross(r));
//! wrong: the mass only multiplies the first force
  return -m * 2 * omega.cross(v_body) - alpha.cross(r) - omega.cross(omega.cross(r));
//! wrong: Euler force with the factors exchanged
  return -2 * m * omega.cross(v_body) - m * r.cross(alpha) - m * omega.cross(omega.cross(r));
//! wrong: centrifugal force towards the axis
  const Vector3d centrifugal = m * omega.cross(omega.cross(r));
  return -2 * m * omega.cross(v_body) - m * alpha.cross(r) + centrifugal;
//! wrong: position and velocity exchanged in the list
Vector3d fictitious_force(double m, const Vector3d& v_body, const Vector3d& r, const Vector3d& omega,
                          const Vector3d& alpha) {
  return -m * (2 * omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r)));
}
//! wrong: nothing for a mass at rest in the frame
  if (v_body.isZero()) return -m * omega.cross(omega.cross(r));
  return -m * (2 * omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r)));
//! wrong: mass forgotten in one term
  return -2 * m * omega.cross(v_body) - alpha.cross(r) - m * omega.cross(omega.cross(r));
