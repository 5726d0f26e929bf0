// The second derivatives of (φ, θ, ψ) for a body with three principal moments that rotates about a fixed point under
// its weight. The centre of mass lies on axis 3; sin θ is not zero.
#include <rigid/heavy_top.hpp>

namespace rigid {

Vector3d heavy_top_accelerations(const Vector3d& I, double mgl, const Vector3d& angles, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
