#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <rigid/euler_equations.hpp>
//! right: five turns about the axes
Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i] / I[i], Vector3d::Unit(i)) * L; };
  go(0, h / 2);
  go(1, h / 2);
  go(2, h);
  go(1, h / 2);
  go(0, h / 2);
  return L.cwiseQuotient(I);
}
//! wrong: last stage forgotten
   go(1, h / 2);
-  go(0, h / 2);
//! wrong: returns L
-  return L.cwiseQuotient(I);
+  return L;
//! wrong: angle without the moment
-  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i] / I[i], Vector3d::Unit(i)) * L; };
+  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i], Vector3d::Unit(i)) * L; };
//! wrong: middle stage halved
-  go(2, h);
+  go(2, h / 2);
//! wrong: first component overwritten before it is used
Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  const std::array<double, 5> part{0.5, 0.5, 1, 0.5, 0.5};
  const std::array<int, 5> axis{0, 1, 2, 1, 0};
  for (int s = 0; s < 5; ++s) {
    const int i = axis[s], j = (i + 1) % 3, k = (i + 2) % 3;
    const double a = -part[s] * h * L[i] / I[i];
    L[j] = std::cos(a) * L[j] - std::sin(a) * L[k];
    L[k] = std::sin(a) * L[j] + std::cos(a) * L[k];
  }
  return L.cwiseQuotient(I);
}
//! right: recursion with complex numbers
static void stage(Vector3d& L, const Vector3d& I, double h, int i) {
  std::complex<double> z(L[(i + 1) % 3], L[(i + 2) % 3]);
  z *= std::exp(std::complex<double>(0, -h * L[i] / I[i]));
  L[(i + 1) % 3] = z.real();
  L[(i + 2) % 3] = z.imag();
}
static void strang(Vector3d& L, const Vector3d& I, double h, int i) {
  if (i == 2) return stage(L, I, h, 2);
  stage(L, I, h / 2, i);
  strang(L, I, h, i + 1);
  stage(L, I, h / 2, i);
}
Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.array() * omega.array();
  strang(L, I, h, 0);
  return L.array() / I.array();
}
