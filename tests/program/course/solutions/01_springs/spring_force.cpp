#include "rigid/springs.hpp"

namespace rigid {

Vector3d spring_force(double k, const Vector3d& x) { return -k * x; }

}  // namespace rigid
