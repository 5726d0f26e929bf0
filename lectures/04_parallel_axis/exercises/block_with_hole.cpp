// A uniform block has its centre at the origin; a ball of the given radius around center is cut out of it. Return the
// inertia tensor of what remains, about the centre of mass of what remains.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d block_with_hole(double density, const Vector3d& edges, const Vector3d& center, double radius) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
