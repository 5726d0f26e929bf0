#include <cmath>
#include <rigid/euler_equations.hpp>
Matrix3d reorientation(const Matrix3d& I, const Vector2d& J, const VectorXd& wheel1, const VectorXd& wheel2) {
//! right: leg by leg
  Matrix3d A = Matrix3d::Identity();
  for (int k = 0; k + 1 < wheel1.size(); ++k) {
    const Vector3d h(J[0] * (wheel1[k + 1] - wheel1[k]), J[1] * (wheel2[k + 1] - wheel2[k]), 0);
    const Vector3d v = -I.inverse() * h;
    if (v.norm() > 0) A = A * Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
  }
  return A;
//! right: many small steps
-    const Vector3d v = -I.inverse() * h;
-    if (v.norm() > 0) A = A * Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
+    const Vector3d w = I.fullPivLu().solve(-h);  // per unit of time, one per leg
+    Matrix3d W;
+    W << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
+    const int n = 2000;
+    const double dt = 1.0 / n;
+    for (int i = 0; i < n; ++i) {
+      const Matrix3d k1 = A * W, k2 = (A + dt / 2 * k1) * W, k3 = (A + dt / 2 * k2) * W, k4 = (A + dt * k3) * W;
+      A += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
+    }
//! wrong: product on the left
-    if (v.norm() > 0) A = A * Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
+    if (v.norm() > 0) A = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix() * A;
//! wrong: sign
-    const Vector3d v = -I.inverse() * h;
+    const Vector3d v = I.inverse() * h;
//! wrong: one wheel after the other
-    const Vector3d h(J[0] * (wheel1[k + 1] - wheel1[k]), J[1] * (wheel2[k + 1] - wheel2[k]), 0);
-    const Vector3d v = -I.inverse() * h;
-    if (v.norm() > 0) A = A * Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
+    const Vector3d first = -I.inverse() * Vector3d(J[0] * (wheel1[k + 1] - wheel1[k]), 0, 0);
+    const Vector3d second = -I.inverse() * Vector3d(0, J[1] * (wheel2[k + 1] - wheel2[k]), 0);
+    A = A * Eigen::AngleAxisd(first.norm(), first.stableNormalized()).toRotationMatrix() *
+        Eigen::AngleAxisd(second.norm(), second.stableNormalized()).toRotationMatrix();
//! wrong: divided by the diagonal
-    const Vector3d v = -I.inverse() * h;
+    const Vector3d v = -h.cwiseQuotient(I.diagonal());
//! wrong: first corner counted as a leg from zero
   Matrix3d A = Matrix3d::Identity();
+  {
+    const Vector3d v = -I.inverse() * Vector3d(J[0] * wheel1[0], J[1] * wheel2[0], 0);
+    A = Eigen::AngleAxisd(v.norm(), v.stableNormalized()).toRotationMatrix();
+  }
//! wrong: the wheels are back, so the body is back
  (void)I, (void)J, (void)wheel1, (void)wheel2;
  return Matrix3d::Identity();
//! wrong: inverse of every entry
  Matrix3d A = Matrix3d::Identity();
  const Matrix3d inverse = I.cwiseInverse();
  for (int k = 1; k < wheel1.size(); ++k) {
    const Vector3d u(J[0] * (wheel1[k] - wheel1[k - 1]), J[1] * (wheel2[k] - wheel2[k - 1]), 0);
    const Vector3d turn = -inverse * u;
    if (turn.norm() > 0) A = A * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  return A;
//! wrong: angles of the corner in place of their change
  Matrix3d A = Matrix3d::Identity();
  for (int k = 1; k < wheel1.size(); ++k) {
    const Vector3d u(J[0] * wheel1[k], J[1] * wheel2[k], 0);
    const Vector3d turn = -I.inverse() * u;
    if (turn.norm() > 0) A = A * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  return A;
