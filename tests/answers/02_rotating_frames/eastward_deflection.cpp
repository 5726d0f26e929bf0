//! wrong: sine of the latitude
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * std::pow(t, 3) * std::sin(latitude) / 3;
}
}  // namespace rigid

//! wrong: one third in whole numbers
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(2 * height / g);
  return 1 / 3 * earth_rate * g * t * t * t * std::cos(latitude);
}
}  // namespace rigid

//! wrong: integrated only once with one half
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 2;
}
}  // namespace rigid

//! wrong: time of the fall without its factor 2
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 3;
}
}  // namespace rigid

//! wrong: square of the time
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * std::cos(latitude) / 3;
}
}  // namespace rigid

//! wrong: to the west on the southern hemisphere
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double t = std::sqrt(2 * height / g);
  const double d = earth_rate * g * t * t * t * std::cos(latitude) / 3;
  return latitude < 0 ? -d : d;
}
}  // namespace rigid

//! wrong: time of the fall in whole seconds
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const int t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 3;
}
}  // namespace rigid

//! right: two thirds of the height
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  return 2.0 / 3.0 * earth_rate * height * std::sqrt(2 * height / g) * std::cos(latitude);
}
}  // namespace rigid

//! right: the eastward velocity integrated by Simpson's rule, which is exact here
#include <cmath>
#include <rigid/rotating_frames.hpp>
namespace rigid {
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double end = std::sqrt(2 * height / g);
  const auto velocity = [&](double t) { return earth_rate * std::cos(latitude) * g * t * t; };
  return end / 6 * (velocity(0) + 4 * velocity(end / 2) + velocity(end));
}
}  // namespace rigid
