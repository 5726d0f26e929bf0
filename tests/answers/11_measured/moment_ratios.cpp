#include <cmath>
#include <rigid/measured.hpp>
Vector2d moment_ratios(double a, double c) {
//! right: Cramer
  const double determinant = c + 1;
  return {(a * c + 1) / determinant, (1 - a) / determinant};
//! wrong: flat racket
  const double r = (1 + a * c) / (1 + c);
  return {r, 1 + r};
//! wrong: ratios to z
  const double s = (1 - a) / (1 + c), r = s + a;
  return {r / s, 1 / s};
//! wrong: third equation with I_y - I_x
  const double s = (1 - a) / (1 - c);
  return {s + a, s};
//! wrong: sign of c
  const double y = (1 + a * c) / (1 - c);
  return {y, y + a};
//! wrong: both coefficients with the other sign, as two linear equations
  Eigen::Matrix2d A;
  A << -1, 1, 1, -c;
  const Vector2d rhs(a, 1);
  return A.fullPivLu().solve(rhs);
