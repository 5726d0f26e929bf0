#include "rigid/free_tops.hpp"

namespace rigid {

double body_precession_rate(double I1, double I3, double omega3) { return omega3 * (I3 - I1) / I1; }

}  // namespace rigid
