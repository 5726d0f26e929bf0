#include <cmath>
#include <rigid/free_tops.hpp>
int axis_stability(const Vector3d& I, int axis) {
//! right: largest, smallest, or between
  const double a = I[axis], b = I[(axis + 1) % 3], c = I[(axis + 2) % 3];
  if (a == b || a == c) return 0;
  if ((a > b && a > c) || (a < b && a < c)) return 1;
  return -1;
//! wrong: only the largest moment is taken for stable
-  if ((a > b && a > c) || (a < b && a < c)) return 1;
-  return -1;
+  return a > b && a > c ? 1 : -1;
//! right: counting
  int larger = 0, equal = 0;
  for (int i = 0; i < 3; ++i) {
    if (i == axis) continue;
    if (I[i] > I[axis]) ++larger;
    if (I[i] == I[axis]) ++equal;
  }
  if (equal > 0) return 0;
  return larger == 1 ? -1 : 1;
//! wrong: stable and unstable exchanged
  const double a = I[axis] - I[(axis + 1) % 3], b = I[axis] - I[(axis + 2) % 3];
  if (a * b > 0) return -1;
  if (a * b < 0) return 1;
  return 0;
//! wrong: neutral is missing
  const double a = I[axis] - I[(axis + 1) % 3], b = I[axis] - I[(axis + 2) % 3];
  return a * b < 0 ? -1 : 1;
//! wrong: differences in whole numbers
  const int a = I[axis] - I[(axis + 1) % 3];
  const int b = I[axis] - I[(axis + 2) % 3];
  if (a == 0 || b == 0) return 0;
  return (a > 0) == (b > 0) ? 1 : -1;
//! wrong: the moments are taken for ascending
  if (I[0] == I[1] && I[1] == I[2]) return 0;
  if (axis == 1) return (I[0] == I[1] || I[1] == I[2]) ? 0 : -1;
  if (axis == 0) return I[0] == I[1] ? 0 : 1;
  return I[2] == I[1] ? 0 : 1;
//! wrong: two equal moments anywhere are taken for neutral
  if (I[0] == I[1] || I[1] == I[2] || I[0] == I[2]) return 0;
  return I[axis] == I.maxCoeff() || I[axis] == I.minCoeff() ? 1 : -1;
//! wrong: small bodies are taken for spheres
  const double a = I[axis] - I[(axis + 1) % 3], b = I[axis] - I[(axis + 2) % 3];
  if (std::abs(a) < 1e-6 || std::abs(b) < 1e-6) return 0;
  return a * b > 0 ? 1 : -1;
//! wrong: nearly equal moments are taken for equal
  const double a = I[axis], b = I[(axis + 1) % 3], c = I[(axis + 2) % 3];
  if (std::abs(a - b) < 0.001 * a || std::abs(a - c) < 0.001 * a) return 0;
  return (a > b) == (a > c) ? 1 : -1;
//! wrong: compares with axes 0 and 1 only
  const double p = (I[axis] - I[0]) * (I[axis] - I[1]);
  return p > 0 ? 1 : p < 0 ? -1 : 0;
