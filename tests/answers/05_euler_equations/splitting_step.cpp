//! wrong: last stage forgotten
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i] / I[i], Vector3d::Unit(i)) * L; };
  go(0, h / 2);
  go(1, h / 2);
  go(2, h);
  go(1, h / 2);
  return L.cwiseQuotient(I);
}

}  // namespace rigid
//! wrong: returns L
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i] / I[i], Vector3d::Unit(i)) * L; };
  go(0, h / 2);
  go(1, h / 2);
  go(2, h);
  go(1, h / 2);
  go(0, h / 2);
  return L;
}

}  // namespace rigid
//! wrong: angle without the moment
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i], Vector3d::Unit(i)) * L; };
  go(0, h / 2);
  go(1, h / 2);
  go(2, h);
  go(1, h / 2);
  go(0, h / 2);
  return L.cwiseQuotient(I);
}

}  // namespace rigid
//! wrong: middle stage halved
#include "rigid/euler_equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigid {

Vector3d splitting_step(const Vector3d& I, const Vector3d& omega, double h) {
  Vector3d L = I.cwiseProduct(omega);
  auto go = [&](int i, double t) { L = Eigen::AngleAxisd(-t * L[i] / I[i], Vector3d::Unit(i)) * L; };
  go(0, h / 2);
  go(1, h / 2);
  go(2, h / 2);
  go(1, h / 2);
  go(0, h / 2);
  return L.cwiseQuotient(I);
}

}  // namespace rigid
