#include "rigid/free_tops.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <cmath>
#include <utility>

namespace rigid {

double tumbling_period(const Vector3d& I, const Vector3d& omega0) {
  double I1 = I[0], I2 = I[1], I3 = I[2];
  Vector3d squares = omega0.cwiseAbs2();

  // L² − 2T I_k as a sum over the two other axes, so that no two large numbers are subtracted.
  const double excess = I1 * (I1 - I2) * squares[0] + I3 * (I3 - I2) * squares[2];  // L² − 2T I₂
  // The formulas hold for motion about axis 3. Motion about axis 1 is the same with the names 1 and 3 exchanged.
  if (excess < 0) {
    std::swap(I1, I3);
    std::swap(squares[0], squares[2]);
  }
  const double above_first = I2 * (I2 - I1) * squares[1] + I3 * (I3 - I1) * squares[2];  // L² − 2T I₁

  const double lambda = std::sqrt(above_first * (I3 - I2) / (I1 * I2 * I3));
  const double complement = (I3 - I1) * excess / (above_first * (I3 - I2));  // 1 − m
  // K(m) = R_F(0, 1 − m, 1), Carlson's form. Close to the separatrix m is almost 1 and K lives on 1 − m, which the
  // modulus k = √m of the usual function has rounded away.
  return 4 * boost::math::ellint_rf(0.0, complement, 1.0) / lambda;
}

}  // namespace rigid
