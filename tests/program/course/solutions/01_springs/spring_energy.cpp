#include "rigid/springs.hpp"

namespace rigid {

double spring_energy(double k, const Vector3d& x) { return 0.5 * k * x.squaredNorm(); }

}  // namespace rigid
