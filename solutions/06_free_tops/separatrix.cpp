#include "rigid/free_tops.hpp"

#include <cmath>

namespace rigid {

Vector3d separatrix(const Vector3d& I, double spin, double t) {
  const double d21 = I[1] - I[0], d32 = I[2] - I[1], d31 = I[2] - I[0];
  const double angle = spin * std::sqrt(d21 * d32 / (I[0] * I[2])) * t;
  const double pulse = 1 / std::cosh(angle);  // where cosh overflows the pulse is over
  return spin * Vector3d(pulse * std::sqrt(I[1] * d32 / (I[0] * d31)), std::tanh(angle),
                         pulse * std::sqrt(I[1] * d21 / (I[2] * d31)));
}

}  // namespace rigid
