#include "rigid/eigen.hpp"

namespace rigid {

double tetrahedron_volume(const Vector3d& a, const Vector3d& b, const Vector3d& c) { return a.dot(b.cross(c)) / 6; }

}  // namespace rigid
