#include "rigid/euler_equations.hpp"

#include <cmath>

namespace rigid {

Vector2d ball_on_turntable(double k, double table_rate, const Vector2d& start, const Vector2d& velocity, double t) {
  // The force at the contact turns the velocity at this rate: the ball runs on a circle, this angle of it, by a chord.
  const double half = k / (1 + k) * table_rate * t / 2;
  const double shortened = half == 0 ? 1 : std::sin(half) / half;
  return start + shortened * t * (Eigen::Rotation2Dd(half) * velocity);
}

}  // namespace rigid
