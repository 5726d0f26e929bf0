#include <algorithm>
#include <cmath>
#include <numbers>
#include <rigid/inertia_tensor.hpp>
Matrix3d inertia_of_mesh(const Matrix3Xd& corners, double density) {
//! right: signed tetrahedra from the origin
  Matrix3d C = Matrix3d::Zero();
  for (int k = 0; k < corners.cols(); k += 3) {
    const Vector3d a = corners.col(k), b = corners.col(k + 1), c = corners.col(k + 2), s = a + b + c;
    const double m = density * a.dot(b.cross(c)) / 6;
    C += m / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  return C.trace() * Matrix3d::Identity() - C;
//! wrong: absolute volumes
-    const double m = density * a.dot(b.cross(c)) / 6;
+    const double m = density * std::abs(a.dot(b.cross(c))) / 6;
//! wrong: second moments instead of the tensor
-  return C.trace() * Matrix3d::Identity() - C;
+  return C;
//! wrong: whole-number division
-    const double m = density * a.dot(b.cross(c)) / 6;
-    C += m / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
+    const double m = density * a.dot(b.cross(c));
+    C += 1 / 120 * m * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
//! wrong: point masses at the centroids of the tetrahedra
  Matrix3d I = Matrix3d::Zero();
  for (int k = 0; k < corners.cols(); k += 3) {
    const Vector3d a = corners.col(k), b = corners.col(k + 1), c = corners.col(k + 2);
    const double m = density * a.dot(b.cross(c)) / 6;
    const Vector3d r = (a + b + c) / 4;
    I += m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
  }
  return I;
//! wrong: weights of equal and of different corners exchanged
  Matrix3d C = Matrix3d::Zero();
  for (int k = 0; k < corners.cols() / 3; k++) {
    const Vector3d a = corners.col(3 * k), b = corners.col(3 * k + 1), c = corners.col(3 * k + 2);
    const double det = a.dot(b.cross(c));
    Matrix3d A;
    A << a, b, c;
    Matrix3d canonical;
    canonical << 1, 2, 2, 2, 1, 2, 2, 2, 1;
    C += density * det / 120 * A * canonical * A.transpose();
  }
  return C.trace() * Matrix3d::Identity() - C;
