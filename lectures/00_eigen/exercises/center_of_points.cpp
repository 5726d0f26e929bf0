// The task stands in include/rigid/eigen.hpp; ./checker/run check center_of_points shows it in short.
#include <rigid/eigen.hpp>

namespace rigid {

Vector3d center_of_points(const Matrix3Xd& r) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
