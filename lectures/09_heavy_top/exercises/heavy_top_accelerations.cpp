// The task stands in include/rigid/heavy_top.hpp; ./checker/run check heavy_top_accelerations shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

Vector3d heavy_top_accelerations(const Vector3d& I, double mgl, const Vector3d& angles, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
