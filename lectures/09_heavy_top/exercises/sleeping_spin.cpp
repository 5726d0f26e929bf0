// The task stands in include/rigid/heavy_top.hpp; ./checker/run check sleeping_spin shows it in short.
#include <rigid/heavy_top.hpp>

namespace rigid {

double sleeping_spin(double I1, double I3, double mgl) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
