#include <cmath>
#include <rigid/measured.hpp>
Vector2d rigidity_defect(const Vector3d& coefficients, const Vector3d& errors) {
//! right: term by term
  const double a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const double da = errors[0] * (1 + b * c), db = errors[1] * (1 + a * c), dc = errors[2] * (1 + a * b);
  return {a + b + c + a * b * c, std::sqrt(da * da + db * db + dc * dc)};
//! wrong: errors of the sum
  const double a = coefficients[0], b = coefficients[1], c = coefficients[2];
  return {a + b + c + a * b * c, errors.norm()};
//! wrong: relative errors of the product
  const double a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const double product = a * b * c;
  const double r = product * errors.cwiseQuotient(coefficients).norm();
  return {a + b + c + product, std::sqrt(errors.squaredNorm() + r * r)};
//! wrong: absolute value of the defect
  const double a = coefficients[0], b = coefficients[1], c = coefficients[2];
  const Vector3d s(1 + b * c, 1 + a * c, 1 + a * b);
  return {std::abs(a + b + c + a * b * c), s.cwiseProduct(errors).norm()};
