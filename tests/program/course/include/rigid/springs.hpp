/// @file
/// Contract of a tiny course that the tests of the checker are run on.
#pragma once

#include "rigid/vocabulary.hpp"

namespace rigid {

/// Energy of a spring with stiffness k, stretched by x: ½ k x².
double spring_energy(double k, const Vector3d& x);

/// Force of the spring on what stretches it: −k x.
Vector3d spring_force(double k, const Vector3d& x);

}  // namespace rigid
