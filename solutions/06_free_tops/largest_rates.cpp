#include "rigid/free_tops.hpp"

#include <algorithm>

namespace rigid {

Vector3d largest_rates(const Vector3d& I, const Vector3d& omega0) {
  // T and L² are linear in the squares of the components, so the squares move to and fro on a straight line: when ω2²
  // grows, the two others shrink. The line ends where one of the squares vanishes.
  const Vector3d squares = omega0.cwiseAbs2();
  const Vector3d share((I[2] - I[1]) / I[0], (I[2] - I[0]) / I[1], (I[1] - I[0]) / I[2]);
  const double until_second_vanishes = squares[1] / share[1];
  const double until_first_or_third = std::min(squares[0] / share[0], squares[2] / share[2]);  // ∞ if one never does
  const Vector3d largest(squares[0] + share[0] * until_second_vanishes, squares[1] + share[1] * until_first_or_third,
                         squares[2] + share[2] * until_second_vanishes);
  return largest.cwiseSqrt();
}

}  // namespace rigid
