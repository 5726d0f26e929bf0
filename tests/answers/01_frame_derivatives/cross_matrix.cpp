#include <rigid/frame_derivatives.hpp>
Matrix3d cross_matrix(const Vector3d& omega) {
//! right: columns are the products with the unit vectors
  Matrix3d m;
  for (int i = 0; i < 3; ++i) m.col(i) = omega.cross(Vector3d::Unit(i));
  return m;
//! wrong: the transpose
-  for (int i = 0; i < 3; ++i) m.col(i) = omega.cross(Vector3d::Unit(i));
+  m << 0, omega.z(), -omega.y(), -omega.z(), 0, omega.x(), omega.y(), -omega.x(), 0;
//! wrong: the y component with the other sign
-  for (int i = 0; i < 3; ++i) m.col(i) = omega.cross(Vector3d::Unit(i));
+  m << 0, -omega[2], -omega[1], omega[2], 0, -omega[0], omega[1], omega[0], 0;
//! wrong: the diagonal is never set
-  for (int i = 0; i < 3; ++i) m.col(i) = omega.cross(Vector3d::Unit(i));
+  m(0, 1) = -omega.z();
+  m(0, 2) = omega.y();
+  m(1, 0) = omega.z();
+  m(1, 2) = -omega.x();
+  m(2, 0) = -omega.y();
+  m(2, 1) = omega.x();
//! right: row by row
Matrix3d cross_matrix(const Vector3d& omega) { return Matrix3d::Identity().rowwise().cross(omega); }
//! right: upper part minus its transpose
  Matrix3d upper = Matrix3d::Zero();
  upper(0, 1) = -omega[2];
  upper(0, 2) = omega[1];
  upper(1, 2) = -omega[0];
  return upper - upper.transpose();
//! wrong: symmetric
  Matrix3d m = Matrix3d::Zero();
  m(0, 1) = m(1, 0) = omega.z();
  m(0, 2) = m(2, 0) = omega.y();
  m(1, 2) = m(2, 1) = omega.x();
  return m;
//! wrong: whole numbers
  const int x = omega.x(), y = omega.y(), z = omega.z();
  Matrix3d m;
  m << 0, -z, y, z, 0, -x, -y, x, 0;
  return m;
