#include "rigid/free_tops.hpp"

#include <cmath>

namespace rigid {

Vector2d linearized_top(const Vector3d& I, double omega3, double amplitude, double phase, double t) {
  const Vector2d rates = linearized_rates(I, omega3);
  const double frequency = std::sqrt(rates[0] * rates[1]);
  const double angle = frequency * t + phase;
  // frequency / Ω1 is sgn(Ω1) √(Ω2/Ω1): written as a quotient, the sign comes by itself.
  return amplitude * Vector2d(std::cos(angle), frequency / rates[0] * std::sin(angle));
}

}  // namespace rigid
