#include <rigid/inertia_tensor.hpp>
Matrix3d inertia_of_points(const VectorXd& m, const Matrix3Xd& r) {
//! right: trace of the second moments
  const Matrix3d S = r * m.asDiagonal() * r.transpose();
  return S.trace() * Matrix3d::Identity() - S;
//! right: componentwise
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p < r.cols(); ++p) {
    const double x = r(0, p), y = r(1, p), z = r(2, p);
    I(0, 0) += m(p) * (y * y + z * z);
    I(1, 1) += m(p) * (x * x + z * z);
    I(2, 2) += m(p) * (x * x + y * y);
    I(0, 1) -= m(p) * x * y;
    I(0, 2) -= m(p) * x * z;
    I(1, 2) -= m(p) * y * z;
  }
  I(1, 0) = I(0, 1);
  I(2, 0) = I(0, 2);
  I(2, 1) = I(1, 2);
  return I;
//! right: squares of the matrices of the cross product
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p < r.cols(); ++p) {
    Matrix3d X;
    X << 0, -r(2, p), r(1, p), r(2, p), 0, -r(0, p), -r(1, p), r(0, p), 0;
    I += m(p) * X * X.transpose();
  }
  return I;
//! wrong: products of inertia without the minus sign
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p < m.size(); ++p) {
    const double x = r(0, p), y = r(1, p), z = r(2, p);
    Matrix3d J;
    J << y * y + z * z, x * y, x * z, x * y, x * x + z * z, y * z, x * z, y * z, x * x + y * y;
    I += m[p] * J;
  }
  return I;
//! wrong: the square of the coordinate itself on the diagonal
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p < m.size(); ++p) I += m[p] * r.col(p) * r.col(p).transpose();
  return I;
//! wrong: the masses are forgotten
-  for (int p = 0; p < m.size(); ++p) I += m[p] * r.col(p) * r.col(p).transpose();
+  for (int p = 0; p < m.size(); ++p)
+    I += r.col(p).squaredNorm() * Matrix3d::Identity() - r.col(p) * r.col(p).transpose();
//! wrong: about the centre of mass
  Matrix3d I = Matrix3d::Zero();
  if (m.size() == 0) return I;
  const Vector3d center = r * m / m.sum();
  for (int p = 0; p < m.size(); ++p) {
    const Vector3d d = r.col(p) - center;
    I += m[p] * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
  }
  return I;
//! wrong: begins with the first point, even if there is none
  const auto one = [&](int p) -> Matrix3d {
    return m[p] * (r.col(p).squaredNorm() * Matrix3d::Identity() - r.col(p) * r.col(p).transpose());
  };
  Matrix3d I = one(0);
  for (int p = 1; p < m.size(); ++p) I += one(p);
  return I;
//! wrong: one point too many
  Matrix3d I = Matrix3d::Zero();
  for (int p = 0; p <= m.size(); ++p) {
    const Vector3d x = r.col(p);
    I += m[p] * (x.squaredNorm() * Matrix3d::Identity() - x * x.transpose());
  }
  return I;
//! wrong: the sum is never set to zero
-  Matrix3d I = Matrix3d::Zero();
-  for (int p = 0; p <= m.size(); ++p) {
+  Matrix3d I;
+  for (int p = 0; p < m.size(); ++p) {
//! wrong: a single point is taken to have no inertia
  Matrix3d I = Matrix3d::Zero();
  if (m.size() < 2) return I;
  for (int p = 0; p < m.size(); ++p)
    I += m[p] * (r.col(p).squaredNorm() * Matrix3d::Identity() - r.col(p) * r.col(p).transpose());
  return I;
