#include "rigid/rotating_frames.hpp"

#include <cmath>

namespace rigid {

double foucault_period(double latitude, double sidereal_day) {
  // The pendulum feels only the vertical part of the Earth's rotation, Ω sin λ.
  return sidereal_day / std::sin(latitude);
}

}  // namespace rigid
