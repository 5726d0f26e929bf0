// The task stands in include/rigid/heavy_top.hpp; ./checker/run check precession_per_nutation shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

double precession_per_nutation(double I1, double I3, double mgl, double theta, const Vector3d& rates) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
