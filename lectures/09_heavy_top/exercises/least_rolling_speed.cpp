// The task stands in include/rigid/heavy_top.hpp; ./checker/run check least_rolling_speed shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

double least_rolling_speed(double radius, double g, double axial, double transverse) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
