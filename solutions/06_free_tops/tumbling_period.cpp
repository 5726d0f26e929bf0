#include "rigid/free_tops.hpp"

#include <cmath>
#include <utility>

namespace rigid {

double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
  double I1 = I[0], I2 = I[1], I3 = I[2];
  const double twice_energy = I.dot(omega0.cwiseAbs2());
  const double momentum_squared = I.cwiseProduct(omega0).squaredNorm();

  // The formulas hold for motion about axis 3. Motion about axis 1 is the same with the names 1 and 3 exchanged: both
  // brackets then change sign, and so do both differences of moments, and every product stays positive.
  if (momentum_squared < twice_energy * I2) std::swap(I1, I3);
  const double steady = (momentum_squared - twice_energy * I1) * (I3 - I2);
  const double wobbling = (twice_energy * I3 - momentum_squared) * (I2 - I1);

  const double lambda = std::sqrt(steady / (I1 * I2 * I3));
  const double m = wobbling / steady;
  return 4 * std::comp_ellint_1(std::sqrt(m)) / lambda;  // the library takes the modulus k = √m
}

}  // namespace rigid
