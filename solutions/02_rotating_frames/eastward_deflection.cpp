#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

double eastward_deflection(double height, double latitude, double g, double earth_rate) {
  const double fall_time = std::sqrt(2 * height / g);
  // The Coriolis acceleration 2 Ω cos λ · g t of the falling body, integrated twice over the time.
  return earth_rate * std::cos(latitude) * g * fall_time * fall_time * fall_time / 3;
}

}  // namespace rigid
