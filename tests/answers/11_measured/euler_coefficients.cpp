#include <cmath>
#include <rigid/measured.hpp>
Vector3d euler_coefficients(const VectorXd& t, const Matrix3Xd& omega) {
//! right: sums in one loop
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    double S = 0, n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int m = 0; m < t.size(); ++m) {
      if (m > 0) S += 0.5 * (t[m] - t[m - 1]) * (omega(j, m) * omega(k, m) + omega(j, m - 1) * omega(k, m - 1));
      const double y = omega(i, m);
      n += 1;
      sx += S;
      sy += y;
      sxx += S * S;
      sxy += S * y;
    }
    result[i] = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  }
  return result;
//! wrong: mean of the factors instead of the products
-      if (m > 0) S += 0.5 * (t[m] - t[m - 1]) * (omega(j, m) * omega(k, m) + omega(j, m - 1) * omega(k, m - 1));
+      if (m > 0) S += (t[m] - t[m - 1]) * (omega(j, m) + omega(j, m - 1)) / 2 * (omega(k, m) + omega(k, m - 1)) / 2;
//! wrong: rectangles
-      if (m > 0) S += 0.5 * (t[m] - t[m - 1]) * (omega(j, m) * omega(k, m) + omega(j, m - 1) * omega(k, m - 1));
+      if (m > 0) S += (t[m] - t[m - 1]) * omega(j, m) * omega(k, m);
//! wrong: steps of a hundredth of a second
-      if (m > 0) S += 0.5 * (t[m] - t[m - 1]) * (omega(j, m) * omega(k, m) + omega(j, m - 1) * omega(k, m - 1));
+      if (m > 0) S += 0.005 * (omega(j, m) * omega(k, m) + omega(j, m - 1) * omega(k, m - 1));
//! right: normal equations
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    Eigen::MatrixX2d X(t.size(), 2);
    double S = 0;
    for (int m = 0; m < t.size(); ++m) {
      if (m > 0) {
        const auto p = [&](int at) { return omega((i + 1) % 3, at) * omega((i + 2) % 3, at); };
        S += (t[m] - t[m - 1]) * (p(m) + p(m - 1)) / 2;
      }
      X.row(m) << 1, S;
    }
    const Vector2d line = (X.transpose() * X).ldlt().solve(X.transpose() * omega.row(i).transpose());
    result[i] = line[1];
  }
  return result;
//! wrong: derivative by differences
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    double above = 0, below = 0;
    for (int m = 1; m < t.size(); ++m) {
      const double p = omega((i + 1) % 3, m) * omega((i + 2) % 3, m);
      above += p * (omega(i, m) - omega(i, m - 1)) / (t[m] - t[m - 1]);
      below += p * p;
    }
    result[i] = above / below;
  }
  return result;
