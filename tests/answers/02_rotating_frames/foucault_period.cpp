#include <cmath>
#include <rigid/rotating_frames.hpp>
double foucault_period(double latitude, double sidereal_day) {
//! right: from the rate of the plane
  const double Omega = 2 * M_PI / sidereal_day;
  return 2 * M_PI / (Omega * std::sin(latitude));
//! right: with the cotangent
  const double cotangent = 1 / std::tan(latitude);
  return sidereal_day * std::sqrt(1 + cotangent * cotangent);
//! wrong: cosine of the latitude
double foucault_period(double latitude, double sidereal_day) { return sidereal_day / std::cos(latitude); }
//! wrong: product in place of the quotient
double foucault_period(double latitude, double sidereal_day) { return sidereal_day * std::sin(latitude); }
//! wrong: latitude taken for degrees
  return sidereal_day / std::sin(latitude * M_PI / 180.0);
//! wrong: always our solar day
double foucault_period(double latitude, double sidereal_day) { return 86400.0 / std::sin(latitude); }
//! wrong: the plane is back after half a rotation
double foucault_period(double latitude, double sidereal_day) { return sidereal_day / (2 * std::sin(latitude)); }
//! wrong: a whole day for every latitude close to the pole
  if (latitude > 1.5) return sidereal_day;
  return sidereal_day / std::sin(latitude);
//! wrong: single precision
  const float s = std::sin(latitude);
  return sidereal_day / s;
