#include <cmath>
#include <rigid/parallel_axis.hpp>
double gravity_from_kater(double h1, double T1, double h2, double T2) {
//! right: both terms of Bessel's formula
  const double pi = std::acos(-1.0);
  return 8 * pi * pi / ((T1 * T1 + T2 * T2) / (h1 + h2) + (T1 * T1 - T2 * T2) / (h1 - h2));
//! wrong: only the first term of Bessel's formula
-  return 8 * pi * pi / ((T1 * T1 + T2 * T2) / (h1 + h2) + (T1 * T1 - T2 * T2) / (h1 - h2));
+  return 8 * pi * pi * (h1 + h2) / (T1 * T1 + T2 * T2);
