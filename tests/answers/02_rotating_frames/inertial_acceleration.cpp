#include <rigid/rotating_frames.hpp>
Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& v_body, const Vector3d& r, const Vector3d& omega,
                               const Vector3d& alpha) {
//! right: the square of omega written out
  return a_body + 2 * omega.cross(v_body) + alpha.cross(r) + omega.dot(r) * omega - omega.squaredNorm() * r;
//! wrong: the Coriolis term without its factor 2
  return a_body + omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r));
//! wrong: centrifugal sign
  return a_body + 2 * omega.cross(v_body) + alpha.cross(r) - omega.cross(omega.cross(r));
//! wrong: brackets of the last term as on the slides
  return a_body + 2 * omega.cross(v_body) + alpha.cross(r) + omega.cross(omega).cross(r);
//! wrong: the rotation is taken for uniform
  return a_body + 2 * omega.cross(v_body) + omega.cross(omega.cross(r));
//! wrong: the centripetal term of a point perpendicular to the axis
  return a_body + 2 * omega.cross(v_body) + alpha.cross(r) - omega.squaredNorm() * r;
//! wrong: expressions kept that refer to vectors which are gone
  const auto coriolis = 2 * omega.cross(v_body);
  const auto rest = alpha.cross(r) + omega.cross(omega.cross(r));
  return a_body + coriolis + rest;
//! right: the transport theorem twice
  const Vector3d v = v_body + omega.cross(r);
  const Vector3d v_rate_body = a_body + alpha.cross(r) + omega.cross(v_body);
  return v_rate_body + omega.cross(v);
//! right: matrices
  const auto matrix = [](const Vector3d& w) {
    Matrix3d m;
    m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return m;
  };
  const Matrix3d W = matrix(omega);
  return a_body + 2 * W * v_body + (matrix(alpha) + W * W) * r;
//! wrong: position and velocity exchanged in the list
Vector3d inertial_acceleration(const Vector3d& a_body, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                               const Vector3d& alpha) {
  return a_body + 2 * omega.cross(v_body) + alpha.cross(r) + omega.cross(omega.cross(r));
}
//! wrong: Coriolis term reversed, velocity in the Euler term
  return a_body - 2 * omega.cross(v_body) + alpha.cross(v_body) + omega.cross(omega.cross(r));
