#include <cmath>
#include <rigid/measured.hpp>
//! right: Cramer
Vector2d moment_ratios(double a, double c) {
  const double determinant = c + 1;
  return {(a * c + 1) / determinant, (1 - a) / determinant};
}
//! wrong: flat racket
Vector2d moment_ratios(double a, double c) {
  const double r = (1 + a * c) / (1 + c);
  return {r, 1 + r};
}
//! wrong: ratios to z
Vector2d moment_ratios(double a, double c) {
  const double s = (1 - a) / (1 + c), r = s + a;
  return {r / s, 1 / s};
}
//! wrong: third equation with I_y - I_x
Vector2d moment_ratios(double a, double c) {
  const double s = (1 - a) / (1 - c);
  return {s + a, s};
}
