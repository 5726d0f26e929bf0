#include "rigid/heavy_top.hpp"

#include <cmath>

namespace rigid {

int path_type(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
  if (phi_rate == 0) return 0;
  // φ̇ vanishes at cos θ = p_φ/p_ψ. In units of p_ψ/I₁ the push is `push`, and twice the rate of the gyroscope formula
  // is `cusp`.
  const double own = I3 * omega3 / I1, push = phi_rate / own, cusp = 2 * mgl / (I1 * own * own);
  const double turning = std::cos(theta) + std::pow(std::sin(theta), 2) * push;
  const bool is_reached = push < 0 || push > cusp;  // by the energy
  return std::abs(turning) < 1 && is_reached ? -1 : 1;
}

}  // namespace rigid
