#include "rigid/euler_angles.hpp"

#include <cmath>

namespace rigid {

Vector3d line_of_nodes(double psi) { return {std::sin(psi), std::cos(psi), 0}; }

}  // namespace rigid
