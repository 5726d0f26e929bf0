#include <cmath>
#include <rigid/rotating_frames.hpp>
double eastward_deflection(double height, double latitude, double g, double earth_rate) {
//! right: two thirds of the height
  return 2.0 / 3.0 * earth_rate * height * std::sqrt(2 * height / g) * std::cos(latitude);
//! wrong: sine of the latitude
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * std::pow(t, 3) * std::sin(latitude) / 3;
//! wrong: one third in whole numbers
  const double t = std::sqrt(2 * height / g);
  return 1 / 3 * earth_rate * g * t * t * t * std::cos(latitude);
//! wrong: integrated only once with one half
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 2;
//! wrong: time of the fall without its factor 2
  const double t = std::sqrt(height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 3;
//! wrong: square of the time
  const double t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * std::cos(latitude) / 3;
//! wrong: time of the fall in whole seconds
  const int t = std::sqrt(2 * height / g);
  return earth_rate * g * t * t * t * std::cos(latitude) / 3;
//! right: the eastward velocity integrated by Simpson's rule, which is exact here
  const double end = std::sqrt(2 * height / g);
  const auto velocity = [&](double t) { return earth_rate * std::cos(latitude) * g * t * t; };
  return end / 6 * (velocity(0) + 4 * velocity(end / 2) + velocity(end));
//! wrong: to the west on the southern hemisphere
  const double t = std::sqrt(2 * height / g);
  const double d = earth_rate * g * t * t * t * std::cos(latitude) / 3;
  return latitude < 0 ? -d : d;
