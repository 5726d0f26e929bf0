//! wrong: cosine of the latitude
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) { return sidereal_day / std::cos(latitude); }
}  // namespace rigid

//! wrong: product in place of the quotient
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) { return sidereal_day * std::sin(latitude); }
}  // namespace rigid

//! wrong: latitude taken for degrees
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) {
  return sidereal_day / std::sin(latitude * M_PI / 180.0);
}
}  // namespace rigid

//! wrong: always our solar day
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) { return 86400.0 / std::sin(latitude); }
}  // namespace rigid

//! wrong: the plane is back after half a rotation
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) { return sidereal_day / (2 * std::sin(latitude)); }
}  // namespace rigid

//! wrong: a whole day for every latitude close to the pole
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) {
  if (latitude > 1.5) return sidereal_day;
  return sidereal_day / std::sin(latitude);
}
}  // namespace rigid

//! wrong: single precision
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) {
  const float s = std::sin(latitude);
  return sidereal_day / s;
}
}  // namespace rigid

//! right: from the rate of the plane
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) {
  const double Omega = 2 * M_PI / sidereal_day;
  return 2 * M_PI / (Omega * std::sin(latitude));
}
}  // namespace rigid

//! right: with the cotangent
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double foucault_period(double latitude, double sidereal_day) {
  const double cotangent = 1 / std::tan(latitude);
  return sidereal_day * std::sqrt(1 + cotangent * cotangent);
}
}  // namespace rigid
