#include "rigid/free_tops.hpp"

#include <cmath>

namespace rigid {

double growth_rate(const Vector3d& I_ascending, double omega2) {
  const Vector3d& I = I_ascending;
  return std::abs(omega2) * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2]));
}

}  // namespace rigid
