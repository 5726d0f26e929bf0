#include "rigid/free_tops.hpp"

namespace rigid {

int axis_stability(const Vector3d& I, int axis) {
  const auto sign = [](double number) { return (number > 0) - (number < 0); };
  // The two differences have the signs of Ω1 and Ω2 (for a positive spin): equal signs swing, opposite signs run away.
  return sign(I[axis] - I[(axis + 1) % 3]) * sign(I[axis] - I[(axis + 2) % 3]);
}

}  // namespace rigid
