#include <cmath>
#include <rigid/rotating_frames.hpp>
double shell_drift(double latitude, double azimuth, double range, double time, double g, double earth_rate) {
//! right: integrals of the velocities
  const double up = g * time / 2, level = range / time;  // at the start
  const double way = level * time * time / 2, climb = up * time * time / 2 - g * time * time * time / 6;
  return 2 * earth_rate * (std::sin(latitude) * way - std::cos(latitude) * std::cos(azimuth) * climb);
//! wrong: starts with the vertical speed at which it would fly twice as long
-  const double up = g * time / 2, level = range / time;  // at the start
+  const double up = g * time, level = range / time;  // at the start
