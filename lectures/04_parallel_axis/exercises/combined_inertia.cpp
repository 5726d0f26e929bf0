// The inertia tensor of several bodies fixed to one another, about their common centre of mass. Body k has the mass
// masses[k], its own centre of mass in column k of centers, and the tensor tensors[k] about that centre.
#include <rigid/parallel_axis.hpp>

namespace rigid {

Matrix3d combined_inertia(const VectorXd& masses, const Matrix3Xd& centers, const std::vector<Matrix3d>& tensors) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
