// The task stands in include/rigid/attitude_of_a_free_body.hpp; ./checker/run check azimuth_rate shows it in short.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

double azimuth_rate(const Vector3d& I, const Vector3d& omega) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
