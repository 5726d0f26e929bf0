// The task stands in include/rigid/attitude_of_a_free_body.hpp; ./checker/run check turn_per_period shows it in short.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

double turn_per_period(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
