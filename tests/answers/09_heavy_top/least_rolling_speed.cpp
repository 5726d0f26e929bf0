#include <cmath>
#include <rigid/heavy_top.hpp>
double least_rolling_speed(double radius, double g, double axial, double transverse) {
//! right: the spin first
  const double spin2 = g / radius * transverse / (axial * axial + axial);
  return radius * std::sqrt(spin2);
//! right: the lean searched for by bisection
  double low = 0, high = 1;
  const auto grows = [&](double v) {
    const double spin = v / radius, heading = axial * spin / transverse;
    return g / radius - (1 + axial) * spin * heading > 0;
  };
  while (grows(high)) high *= 2;
  for (int i = 0; i < 100; ++i) (grows((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
//! wrong: the disc of the book
  (void)axial, (void)transverse;
  return std::sqrt(g * radius / 3);
//! wrong: the ground does not turn the momentum
  return std::sqrt(g * radius * transverse) / axial;
//! wrong: moment about the edge for the axle in both places
  return std::sqrt(g * radius * transverse) / (axial + 1);
//! wrong: the angular velocity
  return std::sqrt(g / radius * transverse / (axial * (axial + 1)));
//! wrong: height of the centre turned into motion
  (void)transverse;
  return std::sqrt(2 * g * radius / (1 + axial));
