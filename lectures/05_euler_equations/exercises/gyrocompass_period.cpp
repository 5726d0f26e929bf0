// The task stands in include/rigid/euler_equations.hpp; ./checker/run check gyrocompass_period shows it in short.
#include <rigid/euler_equations.hpp>

namespace rigid {

double gyrocompass_period(double I1, double I3, double spin, double latitude, double ground_rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
