// The task stands in include/rigid/attitude_of_a_free_body.hpp; ./checker/run check racket_twist shows it in short.
#include <rigid/attitude_of_a_free_body.hpp>

namespace rigid {

double racket_twist(const Vector3d& I, const Vector3d& omega0) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
