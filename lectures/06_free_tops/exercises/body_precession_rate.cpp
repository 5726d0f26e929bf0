// The rate Ω at which the angular velocity of a free symmetric top runs round the symmetry axis, seen from the body.
// It has a sign: keep that of the slides.
#include <rigid/free_tops.hpp>

namespace rigid {

double body_precession_rate(double I1, double I3, double omega3) {
  // TODO: write this function; the next line says that you have not started yet.
  throw NotStarted{};
}

}  // namespace rigid
