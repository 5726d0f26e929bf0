#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

Vector2d bead_on_hoop(double radius, double g, double rate) {
  // The potential −g cos θ − ½ rate² radius sin² θ, per mass and radius, has its minimum at the lowest point or, once
  // that has become a maximum, where cos θ = g/(rate² radius).
  const double pendulum = g / radius, hoop = rate * rate;
  if (hoop < pendulum) return {0, std::sqrt(pendulum - hoop)};
  const double cosine = pendulum / hoop;
  return {std::acos(cosine), std::abs(rate) * std::sqrt((1 - cosine) * (1 + cosine))};
}

}  // namespace rigid
