#include "rigid/free_tops.hpp"

#include <boost/math/special_functions/ellint_rf.hpp>

#include <cmath>
#include <utility>

namespace rigid {

double first_flip(const Vector3d& I, const Vector3d& omega0) {
  using boost::math::ellint_rf;
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
  const double below_third = I1 * (I3 - I1) * squares[0] + I2 * (I3 - I2) * squares[1];  // 2T I₃ − L²
  const double rate = std::sqrt(above_first * (I3 - I2) / (I1 * I2 * I3));

  // ω2 = a₂ sin α, ω1 = a₁ cos α, ω3 = a₃ √(1 − m sin²α); from α = 0 to α takes the time F(α)/rate.
  const double sine = std::sqrt(I2 * (I3 - I2) * squares[1] / below_third);
  const double cosine2 = I1 * (I3 - I1) * squares[0] / below_third;
  const double delta2 = I3 * (I3 - I1) * squares[2] / above_first;
  const double complement = (I3 - I1) * excess / (above_first * (I3 - I2));  // 1 − m
  const double from_zero = sine * ellint_rf(cosine2, delta2, 1.0) / rate;
  const double zero_to_zero = 2 * ellint_rf(0.0, complement, 1.0) / rate;
  // Euler's second equation: ω2 moves away from zero at first if the product of all three components is positive.
  return omega0.prod() > 0 ? zero_to_zero - from_zero : from_zero;
}

}  // namespace rigid
