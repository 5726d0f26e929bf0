#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/rotating_frames.hpp>
Vector3d apparent_gravity(double latitude, double radius, double g0, double earth_rate, const Vector2d& v) {
//! right: written out
  const double s = std::sin(latitude), c = std::cos(latitude);
  const double W = earth_rate;
  return Vector3d(2 * W * s * v[1], -2 * W * s * v[0] - W * W * radius * s * c,
                  -g0 + 2 * W * c * v[0] + W * W * radius * c * c + v.squaredNorm() / radius);
//! wrong: north and east exchanged in the Coriolis term
-  return Vector3d(2 * W * s * v[1], -2 * W * s * v[0] - W * W * radius * s * c,
+  return Vector3d(2 * W * s * v[0], -2 * W * s * v[1] - W * W * radius * s * c,
//! wrong: only the northward speed curves the track
-                  -g0 + 2 * W * c * v[0] + W * W * radius * c * c + v.squaredNorm() / radius);
+                  -g0 + 2 * W * c * v[0] + W * W * radius * c * c + v[1] * v[1] / radius);
//! wrong: gravity points up
-                  -g0 + 2 * W * c * v[0] + W * W * radius * c * c + v.squaredNorm() / radius);
+                  g0 + 2 * W * c * v[0] + W * W * radius * c * c + v.squaredNorm() / radius);
//! wrong: centrifugal uses cos only once
  const double s = std::sin(latitude), c = std::cos(latitude);
  Vector3d a(0, 0, -g0);
  a += Vector3d(0, -earth_rate * earth_rate * radius * s, earth_rate * earth_rate * radius * c);
  const Vector3d w = earth_rate * Vector3d(0, c, s);
  a -= 2 * w.cross(Vector3d(v[0], v[1], 0));
  a[2] += v.squaredNorm() / radius;
  return a;
//! wrong: along a circle of latitude
  const double c = std::cos(latitude), s = std::sin(latitude);
  const double total_east = earth_rate * radius * c + v.x();
  const double outward = total_east * total_east / (radius * c);
  return {2 * earth_rate * s * v.y(), -outward * s, -g0 + outward * c + v.y() * v.y() / radius};
