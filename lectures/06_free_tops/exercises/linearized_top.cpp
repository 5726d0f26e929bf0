// The small wobble (ω1, ω2) of an asymmetric top at time t, spinning about a stable axis 3: ω1 = amplitude · cos(… t
// + phase). The formula for ω2 on the slides has the wrong sign in one of two cases; yours must be right in both.
#include <rigid/free_tops.hpp>

namespace rigid {

Vector2d linearized_top(const Vector3d& I, double omega3, double amplitude, double phase, double t) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
