#include "rigid/measured.hpp"

namespace rigid {

Vector2d rigidity_defect(const Vector3d& coefficients, const Vector3d& errors) {
  const double a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const Vector3d slopes(1 + b * c, 1 + c * a, 1 + a * b);
  return {a + b + c + a * b * c, slopes.cwiseProduct(errors).stableNorm()};
}

}  // namespace rigid
