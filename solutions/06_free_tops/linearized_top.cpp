#include "rigid/free_tops.hpp"

#include <cmath>

namespace rigid {

Vector2d linearized_top(const Vector3d& I, double omega3, double amplitude, double phase, double t) {
  const double Omega1 = omega3 * (I[2] - I[1]) / I[0];
  const double Omega2 = omega3 * (I[2] - I[0]) / I[1];
  const double frequency = std::sqrt(Omega1 * Omega2);
  const double angle = frequency * t + phase;
  // frequency / Ω1 is sgn(Ω1) √(Ω2/Ω1): written as a quotient, the sign comes by itself.
  return amplitude * Vector2d(std::cos(angle), frequency / Omega1 * std::sin(angle));
}

}  // namespace rigid
