#include <cmath>
#include <rigid/measured.hpp>
Vector2d moment_from_pendulum(double M, double g, double d, double P, double d_error, double P_error) {
//! right: partial derivatives by small steps of the closed form
  const auto I = [&](double dd, double PP) { return M * g * dd * PP * PP / (4 * M_PI * M_PI) - M * dd * dd; };
  const double by_d = (I(d * 1.25, P) - I(d * 0.75, P)) / (0.5 * d),
               by_P = (I(d, P * 1.25) - I(d, P * 0.75)) / (0.5 * P);
  return {I(d, P), std::hypot(by_d * d_error, by_P * P_error)};
//! wrong: largest of four corners
  const auto I = [&](double dd, double PP) { return M * g * dd * PP * PP / (4 * M_PI * M_PI) - M * dd * dd; };
  return {I(d, P), std::abs(I(d + d_error, P) - I(d, P)) + std::abs(I(d, P + P_error) - I(d, P))};
//! wrong: finite step for the derivative
  const auto I = [&](double dd, double PP) { return M * g * dd * PP * PP / (4 * M_PI * M_PI) - M * dd * dd; };
  return {I(d, P), std::hypot(I(d + d_error, P) - I(d, P), I(d, P + P_error) - I(d, P))};
//! wrong: relative errors added in the product
  const double I_O = M * g * d * P * P / (4 * M_PI * M_PI);
  const double dI = I_O * std::sqrt(std::pow(d_error / d, 2) + 4 * std::pow(P_error / P, 2));
  return {I_O - M * d * d, std::hypot(dI, 2 * M * d * d_error)};
//! wrong: relative errors of distance and period
  const double pi = std::acos(-1.0), k = g / (4 * pi * pi);
  const double I = M * d * (k * P * P - d);
  const double rel = std::hypot(d_error / d, 2 * P_error / P);
  return Vector2d(I, I * rel);
