#include "rigid/eigen.hpp"

namespace rigid {

Vector3d center_of_points(const Matrix3Xd& r) { return r.rowwise().mean(); }

}  // namespace rigid
