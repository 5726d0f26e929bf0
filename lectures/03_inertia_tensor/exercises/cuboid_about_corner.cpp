// The inertia tensor of a uniform cuboid of mass M with edges a, b, c along x, y, z, about the corner at the origin.
#include <rigid/inertia_tensor.hpp>

namespace rigid {

Matrix3d cuboid_about_corner(double M, double a, double b, double c) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
