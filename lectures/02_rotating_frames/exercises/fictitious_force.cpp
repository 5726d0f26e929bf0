// The task stands in include/rigid/rotating_frames.hpp; ./checker/run check fictitious_force shows it in short.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector3d fictitious_force(double m, const Vector3d& r, const Vector3d& v_body, const Vector3d& omega,
                          const Vector3d& alpha) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
