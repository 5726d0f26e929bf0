// The task stands in include/rigid/free_tops.hpp; ./checker/run check growth_rate shows it in short.
#include <rigid/free_tops.hpp>

namespace rigid {

double growth_rate(const Vector3d& I_ascending, double omega2) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
