// A heavy symmetric top starts at the inclination theta with the rates (φ̇, θ̇, ψ̇). The smallest and the largest
// inclination of its axis.
#include <rigid/heavy_top.hpp>

namespace rigid {

Vector2d nutation_limits(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
