#include <cmath>
#include <rigid/rotating_frames.hpp>
Vector3d coriolis_acceleration(const Vector3d& v_enu, double latitude, double earth_rate) {
//! right: componentwise
  const double s = 2 * earth_rate * std::sin(latitude), c = 2 * earth_rate * std::cos(latitude);
  const double east = v_enu[0], north = v_enu[1], up = v_enu[2];
  return {s * north - c * up, -s * east, c * east};
//! right: on axes whose third is that of the Earth, and back
  const Eigen::AngleAxisd tilt(M_PI / 2 - latitude, Vector3d::UnitX());
  const Vector3d v = tilt * v_enu;
  const Vector3d a(2 * earth_rate * v.y(), -2 * earth_rate * v.x(), 0);
  return tilt.inverse() * a;
//! wrong: sine and cosine of the latitude exchanged
  const Vector3d Omega = earth_rate * Vector3d(0, std::sin(latitude), std::cos(latitude));
  return -2 * Omega.cross(v_enu);
//! wrong: without the factor 2
  const Vector3d Omega(0, earth_rate * std::cos(latitude), earth_rate * std::sin(latitude));
  return -Omega.cross(v_enu);
//! wrong: sign
  const Vector3d Omega(0, earth_rate * std::cos(latitude), earth_rate * std::sin(latitude));
  return 2 * Omega.cross(v_enu);
//! wrong: the southern hemisphere like the northern
  const double lambda = std::abs(latitude);
  const Vector3d Omega(0, earth_rate * std::cos(lambda), earth_rate * std::sin(lambda));
  return -2 * Omega.cross(v_enu);
//! wrong: latitude taken for degrees
-  const double lambda = std::abs(latitude);
+  const double lambda = latitude * M_PI / 180;
//! wrong: only the vertical part of the rotation
  const double f = 2 * earth_rate * std::sin(latitude);
  return {f * v_enu.y(), -f * v_enu.x(), 0};
//! wrong: the axis in the plane of east and up
  const Vector3d Omega(earth_rate * std::cos(latitude), 0, earth_rate * std::sin(latitude));
  return -2 * Omega.cross(v_enu);
//! wrong: nothing on the equator
  if (std::abs(latitude) < 1e-6) return Vector3d::Zero();
  const Vector3d Omega(0, earth_rate * std::cos(latitude), earth_rate * std::sin(latitude));
  return -2 * Omega.cross(v_enu);
