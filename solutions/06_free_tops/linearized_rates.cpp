#include "rigid/free_tops.hpp"

namespace rigid {

Vector2d linearized_rates(const Vector3d& I, double omega3) {
  return omega3 * Vector2d((I[2] - I[1]) / I[0], (I[2] - I[0]) / I[1]);
}

}  // namespace rigid
