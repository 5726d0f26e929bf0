// The inertia tensor of a uniform cuboid of mass M with whole edges a, b, c along x, y, z, about its centre.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d cuboid_about_center(double M, double a, double b, double c) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
