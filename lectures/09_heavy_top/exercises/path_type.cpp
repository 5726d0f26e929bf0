// The task stands in include/rigid/heavy_top.hpp; ./checker/run check path_type shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

int path_type(double I1, double I3, double mgl, double theta, double phi_rate, double omega3) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
