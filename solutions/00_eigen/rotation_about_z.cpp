#include "rigid/eigen.hpp"

#include <cmath>

namespace rigid {

Matrix3d rotation_about_z(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Matrix3d R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

}  // namespace rigid
