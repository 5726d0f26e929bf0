// Is a free spin about the axis with the moment I[axis] stable (+1), unstable (-1) or neutral (0)? Moments come in
// any order; axis is 0, 1 or 2. Neutral means that another moment is equal to this one.
#include <rigid/free_tops.hpp>

namespace rigid {

int axis_stability(const Vector3d& I, int axis) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
