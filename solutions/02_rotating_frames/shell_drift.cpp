#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

double shell_drift(double latitude, double azimuth, double range, double time, double g, double earth_rate) {
  // To the right: 2 Ω (v_level sin λ − v_up cos λ cos α), with v_level = range/time and v_up = g (time/2 − t),
  // integrated twice over the flight. That the flight lasts somewhat longer or shorter shifts the impact along the line
  // only.
  const double level = range * time, climb = g * time * time * time / 6;
  return earth_rate * (level * std::sin(latitude) - climb * std::cos(latitude) * std::cos(azimuth));
}

}  // namespace rigid
