// Where a bead on a rotating hoop rests in stable equilibrium, and how fast it oscillates about this position: {angle
// from the lowest point, angular frequency}.
#include <rigid/rotating_frames.hpp>

namespace rigid {

Vector2d bead_on_hoop(double radius, double g, double rate) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
