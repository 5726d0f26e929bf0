#include <algorithm>
#include <cmath>
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
