// The task stands in include/rigid/free_tops.hpp; ./checker/run check space_precession_rate shows it in short.
#include <rigid/free_tops.hpp>

namespace rigid {

double space_precession_rate(double I1, double I3, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
