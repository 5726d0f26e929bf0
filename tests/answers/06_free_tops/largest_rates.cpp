#include <cmath>
#include <rigid/free_tops.hpp>
Vector3d largest_rates(const Vector3d& I, const Vector3d& omega0) {
//! wrong: largest samples of an integrated motion
  const auto f = [&](const Vector3d& w) -> Vector3d { return I.cwiseProduct(w).cross(w).cwiseQuotient(I); };
  Vector3d w = omega0, best = omega0.cwiseAbs();
  const double h = 0.01 / omega0.norm();
  for (int i = 0; i < 5000; ++i) {
    const Vector3d a = f(w), b = f(w + h * a / 2), c = f(w + h * b / 2), d = f(w + h * c);
    w += h / 6 * (a + 2 * b + 2 * c + d);
    best = best.cwiseMax(w.cwiseAbs());
  }
  return best;
