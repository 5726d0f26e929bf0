#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

double tide(double mass_ratio, double radius, double distance, double angle) {
  // Potential of the moon and of the uniform field, with the opposite sign, for a moon of mass and distance 1. Written
  // out it is 1/w − x c − 1 with w = √(1 − 2 x c + x²); this form keeps its digits where x is small.
  const auto tidal = [](double x, double c) {
    const double u = x * (x - 2 * c), w = std::sqrt(1 + u);
    return -x * (c * u * (2 + w) / (w * (1 + w)) + x / w) / (1 + w);
  };
  const double x = radius / distance, quarter = tidal(x, 0);
  double height = 0;  // in units of radius: 1 − 1/(1 + height) is what the planet's potential gains
  for (int i = 0; i < 30; ++i) {
    const double gain = mass_ratio * x * (tidal(x * (1 + height), std::cos(angle)) - quarter);
    height = gain / (1 - gain);
  }
  return height * radius;
}

}  // namespace rigid
